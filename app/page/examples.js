// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

const digits = 5; // of coordinates behind the point, as make_page.py has them

/** Numbers of their differences. */
function sums(differences) {
  let sum = 0;
  return differences.map(difference => sum += difference);
}

/** The text of an OBJ file: its name, whole coordinates and corners of triangles. */
function objOf({name, coordinates, corners}) {
  const [x, y, z] = coordinates.map(sums).map(numbers => numbers.map(number => (number / 10 ** digits).toFixed(digits)));
  const all = sums(corners), lines = ['o ' + name, ...x.map((_, i) => `v ${x[i]} ${y[i]} ${z[i]}`)];
  for (let i = 0; i < all.length; i += 3) lines.push(`f ${all[i]} ${all[i + 1]} ${all[i + 2]}`);
  return lines.join('\n') + '\n';
}

/** The files of each model in what make_page.py packs: {model: [[path, bytes]]}. */
export function exampleFiles(bytes) {
  const models = JSON.parse(new TextDecoder().decode(bytes));
  return Object.fromEntries(Object.entries(models).map(([model, parts]) => [model, parts.map(
    part => [`${model}/parts/${part.name}.obj`, new TextEncoder().encode(objOf(part))])]));
}

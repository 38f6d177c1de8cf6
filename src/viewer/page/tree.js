// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

import {element, setBreakable} from './dom.js';

// A spanning tree of shapes as an indented list, the medoid at its root: readable at any width.

/** The shapes in the order of the list: [{shape, parent, depth, distance}], the distance to the parent, or null. */
export function walkTree(numberOfShapes, edges, root) {
  const near = Array.from({length: numberOfShapes}, () => []);
  for (const [a, b, distance] of edges) {
    near[a].push([b, distance]);
    near[b].push([a, distance]);
  }
  const result = [], stack = [[root, -1, 0, null]];
  while (stack.length) {
    const [shape, parent, depth, distance] = stack.pop();
    result.push({shape, parent, depth, distance});
    near[shape].filter(([child]) => child !== parent).sort((a, b) => b[1] - a[1]).forEach(
        ([child, d]) => stack.push([child, shape, depth + 1, d]));
  }
  return result;
}

/** Fills the list. @param tell returns the text for a distance */
export function fillTree(root, cards, edges, medoid, pictures, choose, tell) {
  for (const {shape, parent, depth, distance} of walkTree(cards.length, edges, medoid)) {
    const button = element('button', '', root);
    button.style.setProperty('--depth', Math.min(depth, 12));
    pictures.add(element('canvas', '', button), cards[shape].shape);
    setBreakable(cards[shape].name, element('span', '', button));
    if (distance !== null) element('small', `${tell(distance)} to ${cards[parent].name}`, button);
    button.onclick = () => choose(shape);
  }
}

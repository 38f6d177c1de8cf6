// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

// What the surfaces of parts tell: how large parts are, and which parts have two roles in one piece.

const samples = 4000;                  // number of points on a shape's surface
const leastFlat = 0.8;                 // least cosine of the slope of points that one can sit on
const cells = 8, leastCovered = 0.25;  // cells on each side of a grid on the ground, and the least share of them below a seat
// Relative to the box around the shape: least rise of a back above the seat; arm rests: least length, heights above the seat, and ends and
// beginnings of left and right ones; height up to which something is on the ground
const leastRise = 0.25, leastReach = 0.4, armHeights = [0.05, 0.45], sides = [0.3, 0.7], onGround = 0.03;

/**
 * How a shape's surface is spread over its parts.
 * @param meshes [{part, mesh}], meshes as of a GLB
 * @returns {areas, points: [{part, at, flat}]}: areas by part, and points of equal shares of the surface: `at`, the place in the box
 * around it, whose sides are 1, and `flat`, the cosine of the slope
 */
export function extentOf(meshes) {
  const low = [Infinity, Infinity, Infinity], high = [-Infinity, -Infinity, -Infinity], areas = [], triangles = [];
  for (const {part, mesh: {points, indices}} of meshes) {
    const count = indices ? indices.length : points.length / 3;
    const corner = k => { const i = 3 * (indices ? indices[k] : k); return [points[i], points[i + 1], points[i + 2]]; };
    for (let k = 0; k + 2 < count; k += 3) {
      const [a, b, c] = [corner(k), corner(k + 1), corner(k + 2)], [u, v] = [b, c].map(p => p.map((x, i) => x - a[i]));
      const normal = [u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]], area = Math.hypot(...normal) / 2;
      areas[part] = (areas[part] || 0) + area;
      triangles.push({part, a, u, v, area, flat: Math.abs(normal[1]) / (2 * area || 1)});
      for (const p of [a, b, c]) p.forEach((x, i) => { low[i] = Math.min(low[i], x); high[i] = Math.max(high[i], x); });
    }
  }
  const step = areas.reduce((sum, area) => sum + area, 0) / samples, result = [];
  let rest = step / 2;
  for (const {part, a, u, v, area, flat} of triangles)
    for (rest -= area; rest < 0; rest += step) {
      let s = result.length * 0.7548776662 % 1, t = result.length * 0.569840291 % 1; // evenly spread over a square
      if (s + t > 1) [s, t] = [1 - s, 1 - t];
      result.push({part, flat, at: a.map((x, i) => (x + s * u[i] + t * v[i] - low[i]) / (high[i] - low[i] || 1))});
    }
  return {areas, points: result};
}

/** The range of points along an axis, after leaving out a share of them at each end. */
function rangeOf(points, axis, without = 0.05) {
  const values = points.map(({at}) => at[axis]).sort((a, b) => a - b), cut = Math.floor(values.length * without);
  return values.length ? [values[cut], values[values.length - 1 - cut]] : [0, 0];
}

/** The height of a seat: the upper quartile of the points that are flat; null if these do not cover enough ground. */
function seatLevel(points) {
  const flat = points.filter(point => point.flat > leastFlat), cellOf = x => Math.min(cells - 1, Math.floor(cells * x));
  const covered = new Set(flat.map(({at}) => cells * cellOf(at[0]) + cellOf(at[2]))).size;
  return covered < leastCovered * cells * cells ? null : rangeOf(flat, 1, 0.25)[1];
}

/** Whether points reach along both sides of a shape, at the height of arm rests above the seat. */
function hasArms(points, level) {
  const arms = points.filter(({at}) => at[1] > level + armHeights[0] && at[1] < level + armHeights[1]), [left, right] = sides;
  return [arms.filter(({at}) => at[0] < left), arms.filter(({at}) => at[0] > right)].every(side => { const [from, to] = rangeOf(side, 2); return to - from > leastReach; });
}

/**
 * The further roles of parts of a chair or sofa that are several parts in one piece, such as a seat with a back.
 * @param points of its surface (`extentOf`) @param roles of its parts @param others further roles to look for
 * @returns [[role, further roles]]
 */
export function rolesInOnePiece(points, roles, others) {
  const of = role => points.filter(({part}) => roles[part] === role), level = seatLevel(of('seat').length ? of('seat') : of('back'));
  const found = new Map(), add = (role, other) => found.set(role, [...(found.get(role) || []), other]);
  const first = (other, candidates, isSo) => {
    const role = others.includes(other) && !roles.includes(other) && candidates.find(one => roles.includes(one) && isSo(of(one)));
    if (role) add(role, other);
  };
  first('seat', ['back'], () => level !== null);
  first('back', ['seat'], seat => level !== null && rangeOf(seat, 1)[1] - level > leastRise);
  first('armrest', ['leg', 'seat_frame', 'back'], part => level !== null && hasArms(part, level));
  first('leg', ['seat_frame', 'armrest', 'seat', 'back'], part => rangeOf(part, 1, 0)[0] < onGround);
  return [...found];
}

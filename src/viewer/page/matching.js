// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

// What a result of `match` says of the parts of two shapes, in the words of the page.

const shortestRange = 3; // parts with consecutive numbers
const longestCell = 40;  // characters of names in a cell of the table

/** The value of a fraction in per cent, or an empty text. */
export function percent(fraction) {
  return fraction === null || fraction === undefined ? '' : Math.round(100 * fraction) + ' %';
}

/** Names as one enumerates them; more than `most` are counted. */
export function listed(names, most = 6) {
  if (names.length > most) return names.slice(0, most - 1).join(', ') + ` and ${names.length - most + 1} more`;
  return names.length < 2 ? names.join('') : names.slice(0, -1).join(', ') + ' and ' + names[names.length - 1];
}

/** The same names, of several with consecutive numbers the first and the last: leg_1–4. */
export function withRanges(names) {
  const numbered = name => /^(.*?)(\d{1,6})$/.exec(name);
  const follows = (next, name) => {
    const [a, b] = [numbered(name), numbered(next)];
    return a && b && a[1] === b[1] && Number(b[2]) === Number(a[2]) + 1;
  };
  const result = [];
  for (let begin = 0, end; begin < names.length; begin = end) {
    for (end = begin + 1; end < names.length && follows(names[end], names[end - 1]);) ++end;
    if (end - begin < shortestRange) result.push(...names.slice(begin, end));
    else result.push(names[begin] + '–' + numbered(names[end - 1])[2]);
  }
  return result;
}

/** Parts in a cell of the table: their names, or how many they are. */
export function cellOf(names) {
  const text = withRanges(names).join(', ');
  return names.length > 1 && text.length > longestCell ? `${names.length} parts` : text;
}

/** An operation with the numbers of parts, if they are not one and one. */
export function operationText(block) {
  const [sources, targets] = block.parts.map(parts => parts.length);
  return block.operation + (sources === 1 && targets === 1 ? '' : ` ${sources}:${targets}`);
}

/** The same in a sentence, for a part of side 0, the source, or 1. */
export function inWords(block, side) {
  const [here, there] = [block.parts[side].length, block.parts[1 - side].length];
  if (here === 1 && there === 1) return 'one part matches one part';
  if (here === 1) return side === 0 ? `splits into ${there} parts` : `${there} parts merge into it`;
  if (there === 1) return side === 0 ? `merges with ${here - 1} other part${here > 2 ? 's' : ''} into one`
                                     : `one part splits into this and ${here - 1} other part${here > 2 ? 's' : ''}`;
  return `${here} parts correspond to ${there} parts, together`;
}

function indicesOf(names) {
  return names.map(list => new Map(list.map((name, i) => [name, i])));
}

/**
 * The blocks of a result of `match` by the indices of parts in `names`, the names of both shapes' parts: [{parts: [indices,
 * indices], role, operation, confidence}]; the role may be empty, the confidence null.
 */
export function indexedBlocks(result, names) {
  const index = indicesOf(names);
  return result.blocks.map(block => ({
    parts: [block.source, block.target].map((list, side) => list.map(name => index[side].get(name))),
    role: block.role || '', operation: block.operation, confidence: block.confidence === undefined ? null : block.confidence}));
}

/** For each shape the group of every part: parts that the search took together have one number, others -1. */
export function groupNumbers(result, names) {
  const index = indicesOf(names);
  const numbers = names.map(list => list.map(() => -1));
  (result.groups || []).forEach((group, number) => [group.source, group.target].forEach(
      (parts, side) => parts.forEach(name => { numbers[side][index[side].get(name)] = number; })));
  return numbers;
}

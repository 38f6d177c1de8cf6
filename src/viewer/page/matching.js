// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

// What a result of `match` says of the parts of two shapes, in the words of the page.

/** The value of a fraction in per cent, or an empty text. */
export function percent(fraction) {
  return fraction === null || fraction === undefined ? '' : Math.round(100 * fraction) + ' %';
}

/** Names as one enumerates them; more than `most` are counted. */
export function listed(names, most = 6) {
  if (names.length > most) return names.slice(0, most - 1).join(', ') + ` and ${names.length - most + 1} more`;
  return names.length < 2 ? names.join('') : names.slice(0, -1).join(', ') + ' and ' + names[names.length - 1];
}

/** What becomes of `sources` parts that correspond to `targets` parts. */
export function operationOf(sources, targets) {
  if (sources === 0 || targets === 0) return 'no counterpart';
  if (sources === 1) return targets === 1 ? 'match' : 'split';
  return targets === 1 ? 'merge' : 'many to many';
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

/**
 * Blocks of parts that pairs connect, in the order of the source's parts: [{parts: [indices, indices], operation,
 * confidence}]; the confidence is the mean over the pairs, or null.
 * @param pairs [[index in the source, index in the target, confidence or null]]
 */
export function blocksOf(pairs, numberOfSources, numberOfTargets) {
  const parent = Array.from({length: numberOfSources + numberOfTargets}, (_, i) => i);
  const root = i => { while (parent[i] !== i) i = parent[i]; return i; };
  for (const [s, t] of pairs) {
    const [a, b] = [root(s), root(numberOfSources + t)];
    parent[Math.max(a, b)] = Math.min(a, b);
  }
  const blocks = new Map();
  for (const [s, t, confidence] of pairs) {
    const key = root(s);
    if (!blocks.has(key)) blocks.set(key, {key, parts: [new Set(), new Set()], confidences: []});
    const block = blocks.get(key);
    block.parts[0].add(s);
    block.parts[1].add(t);
    if (confidence !== null && confidence !== undefined) block.confidences.push(confidence);
  }
  return [...blocks.values()].sort((a, b) => a.key - b.key).map(block => {
    const parts = block.parts.map(set => [...set].sort((a, b) => a - b)), known = block.confidences;
    return {parts, operation: operationOf(parts[0].length, parts[1].length),
            confidence: known.length ? known.reduce((sum, c) => sum + c, 0) / known.length : null};
  });
}

/** The pairs of a result of `match` by the indices of parts in `names`, the names of both shapes' parts. */
export function indexedPairs(result, names) {
  const index = names.map(list => new Map(list.map((name, i) => [name, i])));
  return result.pairs.map(([source, target], i) => [
    index[0].get(source), index[1].get(target), result.confidences ? result.confidences[i] : null]);
}

/** For each shape the group of every part: parts that the search took together have one number, others -1. */
export function groupNumbers(result, names) {
  const index = names.map(list => new Map(list.map((name, i) => [name, i])));
  const numbers = names.map(list => list.map(() => -1));
  (result.groups || []).forEach((group, number) => [group.source, group.target].forEach(
      (parts, side) => parts.forEach(name => { numbers[side][index[side].get(name)] = number; })));
  return numbers;
}

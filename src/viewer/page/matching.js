// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

// What a result of `match` says of the parts of two shapes, in the words of the page.

const shortestRange = 3; // least number of parts with consecutive numbers that are written as a range
const mostNouns = 3;     // limit for the nouns on one side of a sentence
const mostRows = 8;      // limit for rows of roles, or of blocks without a role: ten with the rows of parts without counterpart
export const unsure = 0.5; // confidence below which a pair is shown as unsure

/** The value of a fraction in per cent, or an empty text. */
export function percent(fraction) {
  return fraction === null || fraction === undefined ? '' : Math.round(100 * fraction) + ' %';
}

/** An enumeration of names; if there are more than `most`, the last ones are counted. */
export function listed(names, most = 6) {
  if (names.length > most) return names.slice(0, most - 1).join(', ') + ` and ${names.length - most + 1} more`;
  return names.length < 2 ? names.join('') : names.slice(0, -1).join(', ') + ' and ' + names[names.length - 1];
}

/** The names, with ranges in place of several with consecutive numbers: leg_1–4. */
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

// Words for the place or the material of a part, which do not name the part itself
const places = /^(.|[fr][lr]|left|right|front|rear|upper|lower|inner|outer|middle|center|centre|fabric|plastic|metal|wood|leather|steel|chrome)$/i;

// Plain words for terms of modellers and of the role model
const plainNouns = {star: 'star leg', h_stab: 'tailplane', v_stab: 'fin'};
// Nouns that have no plural: their parts are counted
const uncounted = /^(bedding|glazing|lighting|steering|body|interior|trim|upholstery|gear|glass)$/;

/** A noun for a part with a label: its role if the label is the role, or else the last word that is neither place nor material, without a number. */
export function nounOf(label, role = '') {
  if (role && roleText(label.replace(/[\s_.:#-]*\d+$/, '')) === roleText(role)) return roleText(role);
  const words = label.replace(/[\s_.:#-]*\d+$/, '').split(/[_.:-]+/).filter(word => word && !places.test(word));
  const noun = words.length ? words[words.length - 1].replace(/\d+$/, '') || 'part' : label;
  return plainNouns[noun] || noun;
}

function plural(noun) {
  if (/[^s]s$/.test(noun)) return noun; // a plural already
  if (/(ss|x|sh|ch)$/.test(noun)) return noun + 'es';
  if (/[^aeiou]y$/.test(noun)) return noun.slice(0, -1) + 'ies';
  return /(lea|shel)f$/.test(noun) ? noun.slice(0, -1) + 'ves' : noun + 's';
}

/** A number of things: `4 legs`. */
export const counted = (number, noun) => `${number} ${number === 1 ? noun : uncounted.test(noun) ? noun + ' parts' : plural(noun)}`;

/** A role in words. */
export const roleText = role => plainNouns[role] || role.replace(/_/g, ' ');

/** Parts counted by their nouns: `1 column and 5 arms`; if there is one of each, without numbers unless `wantsNumbers`. @param role replaces more than `mostNouns` nouns; may be empty */
export function countedParts(labels, role, wantsNumbers = false) {
  const counts = new Map();
  for (const noun of labels.map(label => nounOf(label, role))) counts.set(noun, (counts.get(noun) || 0) + 1);
  if (counts.size > mostNouns) return counted(labels.length, role ? roleText(role) : 'part');
  const areSingle = !wantsNumbers && counts.size === labels.length;
  return listed([...counts].map(([noun, number]) => areSingle ? noun : counted(number, noun)));
}

/** A sentence on corresponding parts: `4 legs become 1 column and 5 arms`; parts with the same nouns match. @param labels of source and target */
export function sentenceOf(labels, role) {
  const [sources, targets] = labels.map(list => list.length);
  const nounsOf = list => [...new Set(list.map(label => nounOf(label, role)))].sort(), wantsNumbers = labels.some(list => nounsOf(list).length < list.length);
  const isOne = sources === 1 && targets === 1, [from, to] = labels.map(list => isOne ? list[0] : countedParts(list, role, wantsNumbers));
  const [nouns, others] = labels.map(list => nounsOf(list).join());
  const [verb, verbs] = nouns === others ? ['matches', 'match'] : ['becomes', 'become'];
  return `${from} ${sources === 1 ? verb : verbs} ${to}`;
}

/** The operation of a block, with the numbers of its parts unless both are 1. */
export function operationText(block) {
  const [sources, targets] = block.parts.map(parts => parts.length);
  return block.operation + (sources === 1 && targets === 1 ? '' : ` ${sources}:${targets}`);
}

/** Blocks by role, in the order of the blocks: [{role, blocks: [indices]}]; beyond `mostRows`, the last one gathers the smallest. */
export function rowsByRole(blocks) {
  const rows = new Map();
  blocks.forEach(({role}, b) => {
    const key = role || '#' + b;
    if (!rows.has(key)) rows.set(key, {role, blocks: []});
    rows.get(key).blocks.push(b);
  });
  const result = [...rows.values()];
  if (result.length <= mostRows) return result;
  const size = row => row.blocks.reduce((sum, b) => sum + blocks[b].parts[0].length + blocks[b].parts[1].length, 0);
  const kept = new Set([...result].sort((a, b) => size(b) - size(a)).slice(0, mostRows - 1));
  return [...result.filter(row => kept.has(row)),
          {role: 'others', blocks: result.filter(row => !kept.has(row)).flatMap(row => row.blocks)}];
}

/** The operation of a block in words, for one of its parts on side 0, the source, or 1. */
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
 * indices], role, operation, confidence, sure, least}]; the role may be empty, and the confidence null. `sure` has the confidence
 * of the surest pair of each part, `least` is the least of them.
 */
export function indexedBlocks(result, names) {
  const index = indicesOf(names), best = [new Map(), new Map()];
  (result.confidences || []).forEach((confidence, i) => result.pairs[i].forEach((name, side) => {
    const part = index[side].get(name);
    best[side].set(part, Math.max(confidence, best[side].get(part) || 0));
  }));
  return result.blocks.map(block => {
    const parts = [block.source, block.target].map((list, side) => list.map(name => index[side].get(name)));
    const confidence = block.confidence === undefined ? null : block.confidence;
    const sure = parts.map((list, side) => list.map(part => best[side].has(part) ? best[side].get(part) : confidence));
    return {parts, role: block.role || '', operation: block.operation, confidence, sure, least: confidence === null ? null : Math.min(...sure.flat())};
  });
}

// Notes on how a file was read, which do not concern the correspondence, and their texts for readers of the page
const readings = [
  [/^Parts were found by what parts look like/, 'The objects of the file are not its parts; these were found by what parts look like.'],
  [/^Objects (of loose pieces were split|that are not one part each were divided)/, 'Objects of the file that are several parts each were divided.'],
  [/^Pieces end where the material changes/, 'Parts end where the material changes.'],
  [/^The upright axis was taken/, 'Which way is up was estimated, as the file does not say it.'],
  [/^Parts that branch,.* roughly: ([^;]*?)\. Divide .*/, 'These parts branch, and are compared only roughly: $1.'],
  [/^(Faces of fewer than .*)/, '$1'],
];

/**
 * The text of a note for the reader of a page: without files, commands and their options.
 * @param models {file: title} @returns {text, isReading}: whether it is about how the file was read
 */
export function readersNote(note, models) {
  let text = note, of = '';
  for (const [file, title] of Object.entries(models)) if (text.startsWith(file + ': ')) [of, text] = [title + ': ', text.slice(file.length + 2)];
  const reading = readings.find(([pattern]) => pattern.test(text));
  if (reading) return {text: of + reading[0].exec(text)[0].replace(...reading), isReading: true};
  const isOfShell = part => /--\w|`/.test(part);
  const sentences = text.split(/(?<=\.)\s+/).map(sentence => sentence.split(/;\s+/).filter(part => !isOfShell(part)).join('; ')).filter(Boolean);
  return {text: sentences.length ? of + sentences.join(' ').replace(/[.;]?$/, '.') : '', isReading: false};
}

/** For each shape the group of every part: parts that the search took together have one number, others -1. */
export function groupNumbers(result, names) {
  const index = indicesOf(names);
  const numbers = names.map(list => list.map(() => -1));
  (result.groups || []).forEach((group, number) => [group.source, group.target].forEach(
      (parts, side) => parts.forEach(name => { numbers[side][index[side].get(name)] = number; })));
  return numbers;
}

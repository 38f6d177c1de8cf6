// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

// Tests of the viewer's modules that need no picture; test_pages.py opens test_modules.html and reads window.failures.

import {shellWord, storedMatch} from '../../../src/viewer/page/collection_page.js';
import {cssColour, linearColour} from '../../../src/viewer/page/dom.js';
import {extentOf, rolesInOnePiece} from '../../../src/viewer/page/extent.js';
import {bytesOfBase64, morphed, readGlb, valuesAt} from '../../../src/viewer/page/glb.js';
import {countedParts, groupNumbers, indexedBlocks, inWords, listed, nounOf, operationText, percent, readersNote, roleText, rowsByRole, sentenceOf, withRanges} from '../../../src/viewer/page/matching.js';
import {Overlay} from '../../../src/viewer/page/match_view.js';
import {Selection} from '../../../src/viewer/page/selection.js';
import {walkTree} from '../../../src/viewer/page/tree.js';

const failures = [];
let checks = 0;

function equal(got, wanted) {
  ++checks;
  const [a, b] = [got, wanted].map(value => JSON.stringify(value));
  if (a !== b) failures.push(`${new Error().stack.split('\n')[2].trim()}: ${a} is not ${b}`);
}

/** The bytes of a GLB file of a JSON document and a buffer of 32-bit numbers. */
function glb(json, numbers) {
  let text = JSON.stringify(json);
  while (text.length % 4) text += ' ';
  const bytes = new Uint8Array(12 + 8 + text.length + 8 + numbers.byteLength), view = new DataView(bytes.buffer);
  const header = [0x46546C67, 2, bytes.length, text.length, 0x4E4F534A];
  header.forEach((n, i) => view.setUint32(4 * i, n, true));
  bytes.set(new TextEncoder().encode(text), 20);
  view.setUint32(20 + text.length, numbers.byteLength, true);
  view.setUint32(24 + text.length, 0x004E4942, true);
  bytes.set(new Uint8Array(numbers.buffer), 28 + text.length);
  return bytes;
}

// extent.js: a chair of boxes, whose seat and back are one piece, and whose legs continue as armrests
{
  const box = (part, low, high) => {
    const points = Array.from({length: 8}, (_, i) => [0, 1, 2].map(k => (i >> k & 1 ? high : low)[k])).flat();
    const indices = [[0, 2, 6, 4], [1, 5, 7, 3], [0, 4, 5, 1], [2, 3, 7, 6], [0, 1, 3, 2], [4, 6, 7, 5]].flatMap(([a, b, c, d]) => [a, b, c, a, c, d]);
    return {part, mesh: {points: new Float32Array(points), indices}};
  };
  const seat = box(0, [0, .45, 0], [1, .5, 1]), back = part => box(part, [0, .5, 0], [1, 1, .05]), side = x => [
    box(2, [x, 0, .1], [x + .05, .7, .15]), box(2, [x, 0, .85], [x + .05, .7, .9]), box(2, [x, .65, .1], [x + .05, .7, .9])];
  const all = ['seat', 'back', 'armrest', 'leg'], {areas, points} = extentOf([seat, back(0), ...side(0), ...side(.95)]);
  equal([Number(areas[0].toFixed(3)), areas[1], points.length], [3.35, undefined, 4000]);
  equal(rolesInOnePiece(points, ['back', '', 'leg'], all), [['back', ['seat']], ['leg', ['armrest']]]);
  equal(rolesInOnePiece(points, ['seat', '', 'leg'], ['back']), [['seat', ['back']]]);
  equal(rolesInOnePiece(points, ['back', '', 'leg'], ['back', 'leg']), []);
  equal(rolesInOnePiece(extentOf([seat, back(1), ...side(0), ...side(.95)]).points, ['seat', 'back', 'armrest'], all), [['armrest', ['leg']]]);
}

// glb.js
{
  const numbers = new Float32Array([0, 0, 0, 1, 0, 0, 0, 1, 0, /**/ 0, 0, 0, 0, 0, 2, 0, 0, 0, /**/ 0, 1, 3, /**/ 0, 1, 0.5]);
  const accessor = (bufferView, count, type, byteOffset) => ({bufferView, count, type, byteOffset, componentType: 5126});
  const document = {
    scenes: [{name: 'a', nodes: [0]}],
    nodes: [{name: 'shape', children: [1, 2], translation: [1, 2, 3], extras: {layer: 'a'}}, {name: 'part', mesh: 0, extras: {part: 4}}, {mesh: 0}],
    meshes: [{primitives: [{attributes: {POSITION: 0}, material: 0, targets: [{POSITION: 1}], mode: 1}]}],
    materials: [{pbrMetallicRoughness: {baseColorFactor: [1, 0.5, 0, 1]}}],
    accessors: [accessor(0, 3, 'VEC3'), accessor(1, 3, 'VEC3'), accessor(2, 3, 'SCALAR', 0), accessor(2, 3, 'SCALAR', 12)],
    bufferViews: [{byteOffset: 0}, {byteOffset: 36}, {byteOffset: 72}],
    animations: [{extras: {begin: 1, end: 2}, channels: [{sampler: 0, target: {node: 1, path: 'weights'}}],
                  samplers: [{input: 2, output: 3, interpolation: 'LINEAR'}]}],
  };
  const read = readGlb(glb(document, numbers)), [shape] = read.scenes[0].nodes, [part, other] = shape.children, [mesh] = part.meshes;
  equal([shape.name, shape.translation, shape.animation, part.name, part.extras], ['shape', [1, 2, 3], null, 'part', {part: 4}]);
  equal([other.name, other.extras], ['', {layer: 'a'}]);
  equal([mesh.colour, mesh.isLines, mesh.normals, mesh.indices], [[1, 0.5, 0, 1], true, null, null]);
  equal([...mesh.points], [0, 0, 0, 1, 0, 0, 0, 1, 0]);
  equal(read.animation, {extras: {begin: 1, end: 2}, seconds: 3});
  const track = part.animation.weights;
  equal([-1, 0, 0.5, 1, 2, 3, 9].map(time => valuesAt(track, time)[0]), [0, 0, 0.5, 1, 0.75, 0.5, 0.5]);
  equal([0, 0.9, 1, 2.9].map(time => valuesAt({...track, isStep: true}, time)[0]), [0, 0, 1, 1]);
  equal([...morphed(mesh, [0.5])], [0, 0, 0, 1, 0, 1, 0, 1, 0]);
  equal([...mesh.points], [0, 0, 0, 1, 0, 0, 0, 1, 0]);
  equal([...bytesOfBase64('AP+A')], [0, 255, 128]);
  let refused = false;
  try { readGlb(new Uint8Array(20)); } catch (error) { refused = true; }
  equal(refused, true);
}

// match_view.js: a label is on a large part or beside a thin one; there is none if other parts or labels leave no place
{
  const confine = {left: 0, top: 0, width: 400, height: 400}, spots = [{x: 200, y: 200}];
  const place = (partHalf, backgroundFrom, placed = []) => Overlay.prototype.placeOfLabel.call({placed}, {spots, number: 3, confine, shareOf: ({left, right}, number) =>
      number === 3 ? Math.min(1, 2 * partHalf / (right - left)) : Number(left >= 200 + backgroundFrom)}, 20);
  equal(place(50, 60), {left: 180, right: 220, top: 191, bottom: 209});
  equal(place(2, 10), {left: 216, right: 256, top: 191, bottom: 209, from: spots[0]});
  equal([place(2, 300), place(50, 300, [place(50, 60)])], [null, null]);
}

// matching.js
{
  equal([percent(0.934), percent(null), percent(undefined), percent(0)], ['93 %', '', '', '0 %']);
  equal([listed([]), listed(['a']), listed(['a', 'b', 'c'])], ['', 'a', 'a, b and c']);
  equal(listed(['a', 'b', 'c', 'd'], 3), 'a, b and 2 more');
  equal(withRanges(['leg_1', 'leg_2', 'leg_3', 'leg_5', 'seat', 'a#9', 'a#10', 'a#11']), ['leg_1–3', 'leg_5', 'seat', 'a#9–11']);
  equal([withRanges(['a1', 'b2', 'b3']), withRanges([])], [['a1', 'b2', 'b3'], []]);
  equal(['front_left_leg', 'star_1', 'seat frame 2', 'arm_pad_l', 'wheels#3', '7', 'leg_left'].map(label => nounOf(label)), ['leg', 'star leg', 'seat frame', 'pad', 'wheels', '7', 'leg']);
  equal([countedParts(['column', 'star_1', 'star_2'], ''), countedParts(['a_x', 'shelf', 'body', 'box', 'leg'], 'seat_frame'), countedParts(['shelf 1', 'shelf 2'], '')],
        ['1 column and 2 star legs', '5 seat frames', '2 shelves']);
  equal([countedParts(['bar', 'cushion_back'], 'back'), countedParts(['bedding_1', 'bedding_2'], ''), countedParts(['wing_l', 'wing_r'], 'wing')], ['bar and back', '2 bedding parts', '2 wings']);
  equal([sentenceOf([['window 5'], ['window 7']], 'window'), sentenceOf([['body'], ['interior', 'body']], 'body'), sentenceOf([['h stab 1'], ['h stab 1', 'h stab 2']], 'h_stab'), roleText('v_stab')],
        ['window 5 matches window 7', 'body becomes interior and body', '1 h stab matches 2 h stabs', 'fin']);
  equal([sentenceOf([['left_leg', 'right_leg'], ['column', 'star_1', 'star_2']], 'leg'), sentenceOf([['seat'], ['pad']], ''), sentenceOf([['wheels 1', 'wheels 2'], ['wheels 1', 'wheels 2']], '')],
        ['2 legs become 1 column and 2 star legs', 'seat becomes pad', '2 wheels match 2 wheels']);
  equal([nounOf('seat_frame#2', 'seat_frame'), nounOf('seat_frame 2')], ['seat frame', 'frame']);
  const roles = ['leg', 'seat', 'leg', '', ''].map(role => ({role, parts: [[0], [0]]}));
  equal(rowsByRole(roles), [{role: 'leg', blocks: [0, 2]}, {role: 'seat', blocks: [1]}, {role: '', blocks: [3]}, {role: '', blocks: [4]}]);
  const many = rowsByRole(Array.from({length: 30}, (_, i) => ({role: 'role' + i % 20, parts: [[0], [0]]})));
  equal([many.length, many[7].role, many[7].blocks.length], [8, 'others', 16]);
  const files = {'a/b.obj': 'b'};
  const noteOf = note => readersNote(note, files).text;
  equal([noteOf('a/b.obj: Axes are odd; give --up. `parts a/b.obj` says why.'), noteOf('--parts file helps.'), noteOf('a/b.obj: Parts were found by what parts look like, in objects that are none: x. --parts file takes others.')],
        ['b: Axes are odd.', '', 'b: The objects of the file are not its parts; these were found by what parts look like.']);
  const result = {blocks: [{source: ['leg'], target: ['leg'], operation: 'match', confidence: 1},
                           {source: ['back'], target: ['slat 1', 'slat 2'], role: 'back', operation: 'split', confidence: 0.6}],
                  groups: [{source: ['back'], target: ['slat 1', 'slat 2']}]};
  const names = [['leg', 'seat', 'back'], ['slat 1', 'slat 2', 'leg']], blocks = indexedBlocks(result, names);
  const shown = block => [block.parts, block.role, block.operation, block.confidence, block.least];
  equal(blocks.map(shown), [[[[0], [2]], '', 'match', 1, 1], [[[2], [0, 1]], 'back', 'split', 0.6, 0.6]]);
  const [, rated] = indexedBlocks({...result, pairs: [['leg', 'leg'], ['back', 'slat 1'], ['back', 'slat 2']], confidences: [1, 0.4, 0.8]}, names);
  equal([rated.confidence, rated.sure, rated.least], [0.6, [[0.8], [0.4, 0.8]], 0.4]);
  equal(blocks.map(operationText), ['match', 'split 1:2']);
  equal([0, 1].map(side => inWords(blocks[1], side)), ['splits into 2 parts', 'one part splits into this and 1 other part']);
  equal(inWords(blocks[0], 1), 'one part matches one part');
  const [merge] = indexedBlocks({blocks: [{source: ['leg', 'seat', 'back'], target: ['leg'], operation: 'merge'}]}, names);
  equal([merge.confidence, inWords(merge, 0), inWords(merge, 1)], [null, 'merges with 2 other parts into one', '3 parts merge into it']);
  equal(groupNumbers(result, names), [[-1, -1, 0], [0, 0, -1]]);
}

// dom.js, selection.js, tree.js, collection_page.js
{
  equal([cssColour([0, 1, 0.2140411]), cssColour([2, -1, 0, 1])], ['rgb(0, 255, 127)', 'rgb(255, 0, 0)']);
  equal(cssColour(linearColour('#3b8ede')), 'rgb(59, 142, 222)');
  const seen = [], selection = new Selection(key => seen.push(key));
  selection.hover('a');
  selection.hover('a');
  selection.hover(null);
  selection.pin('b');
  selection.hover('c');
  selection.hover(null);
  selection.pin('b');
  equal(seen, ['a', null, 'b', 'c', 'b', null]);
  equal(walkTree(4, [[0, 1, 3], [1, 2, 1], [0, 3, 2]], 0),
        [{shape: 0, parent: -1, depth: 0, distance: null}, {shape: 3, parent: 0, depth: 1, distance: 2}, {shape: 1, parent: 0, depth: 1, distance: 3},
         {shape: 2, parent: 1, depth: 2, distance: 1}]);
  const stored = {operations: ['match', 'split'], maps: {'0,2': [0.1, 0.2, [[[3], [4, 5], 1, 50]]]}};
  equal(storedMatch(stored, 0, 2),
        {blocks: [{parts: [[3], [4, 5]], role: '', confidence: 0.5, operation: 'split'}], energies: [0.1, 0.2]});
  equal(storedMatch(stored, 2, 0),
        {blocks: [{parts: [[4, 5], [3]], role: '', confidence: 0.5, operation: 'merge'}], energies: [0.2, 0.1]});
  equal(storedMatch(stored, 0, 1), null);
  equal([shellWord('a/b-1.obj'), shellWord("it's a $HOME")], ['a/b-1.obj', "'it'\\''s a $HOME'"]);
}

window.failures = failures;
window.checks = checks;

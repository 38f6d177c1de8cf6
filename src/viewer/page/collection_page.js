// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

import {$, addTabs, addWarnings, documentOf, element, setBreakable} from './dom.js';
import {listed, readersNote, roleText} from './matching.js';
import {fillGallery, Pictures} from './gallery.js';
import {addLayerSwitches, glbOf, unsureText} from './match_page.js';
import {MatchView} from './match_view.js';
import {Stage} from './stage.js';
import {fillTree} from './tree.js';

// The page of a collection: a gallery, the spanning tree, and the match of two shapes that one chooses. A part has the
// colour of its cluster everywhere.

const nearShare = 0.75, farShare = 1.25; // near: below this share of the medoid's mean distance; far: above the other

const shown = x => x.toPrecision(3);

/** The operation in the direction from target to source. @param parts number of parts of the target */
function inverseOperation(operation, parts) {
  if (operation === 'merge') return parts === 1 ? 'split' : 'duplicate';
  return operation === 'split' || operation === 'duplicate' ? 'merge' : operation;
}

/** The stored match of two shapes: {energies, blocks: [{parts: [indices, indices], role, operation, confidence}]}, or null. */
export function storedMatch({maps, operations}, a, b) {
  const isSwapped = a > b, map = maps[isSwapped ? `${b},${a}` : `${a},${b}`];
  if (!map) return null;
  const [there, back, stored] = map, blocks = stored.map(([source, target, number, percent]) => ({
    parts: isSwapped ? [target, source] : [source, target], role: '', confidence: percent / 100,
    operation: isSwapped ? inverseOperation(operations[number], target.length) : operations[number]}));
  return {blocks, energies: isSwapped ? [back, there] : [there, back]};
}

/** A path as one types it in a shell. */
export function shellWord(path) {
  return /^[\w@%+=:,./-]+$/.test(path) ? path : "'" + path.replace(/'/g, "'\\''") + "'";
}

export function showCollection() {
  const collection = documentOf('collection'), stored = documentOf('maps'), {labels, total, roles, clusters} = stored;
  const roleOf = (shape, part) => roles[clusters[shape][part]] || '';
  const nodes = glbOf('collection.glb').scenes[0].nodes, shapes = collection.shapes;
  const number = new Map(shapes.map((shape, i) => [shape.name, i])), medoid = number.get(collection.medoid.shape);
  const cards = shapes.map((shape, i) => ({name: shape.name, mark: i === medoid ? '★ most typical' : '', shape: nodes[i]}));
  document.body.classList.add('with-gallery');

  $('h1').textContent = `Collection of ${total} shapes`;
  element('p', (total > shapes.length ? `Shown are ${shapes.length} of them, from all branches of the tree below. ` : '') +
      'Parts that are alike have one colour' + (roles.some(Boolean) ? ': ' + listed([...new Set(roles.filter(Boolean))].map(roleText), 10) : '') +
      '; parts that are like no others are grey. Choose two shapes to see which of their parts correspond.',
      $('#facts'));
  addWarnings($('#facts'), (collection.warnings || []).map(note => readersNote(note, {}).text));
  const openTab = addTabs([['shapes', 'Set'], ['models', 'Pair'], ['list', 'Parts']]);

  const toldDistance = distance => shown(distance) + (distance < nearShare * collection.medoid.mean_distance ? ' (near)' : distance > farShare * collection.medoid.mean_distance ? ' (far)' : '');
  const stage = new Stage($('#stage')), views = [stage.addView(''), stage.addView('')];
  const view = new MatchView(stage, views);
  const told = $('#told');
  let chosen = [];

  function show(indices) {
    views.forEach((v, side) => {
      stage.clear(v);
      v.figure.hidden = side >= indices.length;
      if (v.figure.hidden) return;
      setBreakable(shapes[indices[side]].name, v.caption);
      nodes[indices[side]].children.forEach((node, part) => stage.addNode(v, {...node, name: shapes[indices[side]].parts[part]}, part));
      stage.centre(v);
    });
    const match = indices.length === 2 ? storedMatch(stored, ...indices) : null;
    stage.equalise(views.filter(v => !v.figure.hidden));
    const of = list => [0, 1].map(side => side < indices.length ? list[indices[side]] : null);
    view.show({titles: of(shapes).map(shape => shape ? shape.name : ''), names: of(shapes).map(shape => shape ? shape.parts : []),
               labels: of(labels).map(list => list || []), blocks: match ? match.blocks.map(block => ({...block, least: block.confidence, role: roleOf(indices[0], block.parts[0][0])})) : [], roles: [[], []], groups: [[], []]});
    $('table').hidden = $('#search').hidden = !match;
    told.replaceChildren();
    if (indices.length === 1) element('p', `${shapes[indices[0]].name}: choose another shape.`, told);
    else if (match)
      element('p', `Distance ${toldDistance((match.energies[0] + match.energies[1]) / 2)}: the mean of ${shown(match.energies[0])} from left to right and ${shown(match.energies[1])} back. ` +
              'Grey parts have no counterpart.' + unsureText(match.blocks), told);
    else if (indices.length === 2) {
      element('p', 'This page stores the matches of shapes that are near each other. To match these two, run', told);
      element('code', `shape_correspondence match ${indices.map(i => shellWord(shapes[i].file)).join(' ')} --html match.html`, told);
    }
    stage.resize();
  }

  function choose(i) {
    chosen = chosen.length === 1 && chosen[0] !== i ? [chosen[0], i] : [i];
    buttons.forEach((button, k) => button.classList.toggle('chosen', chosen.includes(k)));
    show(chosen);
  }

  const pictures = new Pictures();
  const chooseAndLook = i => { choose(i); if (chosen.length < 2) return; openTab('models'); $('#stage').scrollIntoView({block: 'nearest'}); };
  const buttons = fillGallery($('#gallery'), cards, pictures, chooseAndLook);
  element('h2', 'Nearest relatives', $('#tree'));
  element('p', `${shapes[medoid].name} is the most typical shape: its distances to the others are the smallest, ${shown(collection.medoid.mean_distance)} on average. ` +
      'Each shape stands below the relative to which its distance is told; together these are the shortest way to join all shapes (a spanning tree).', $('#tree'));
  const edges = collection.spanning_tree.map(({shapes: [a, b], distance}) => [number.get(a), number.get(b), distance]);
  fillTree($('#tree'), cards, edges, medoid, pictures, chooseAndLook, toldDistance);
  show([]);
  const nearest = edges.filter(([a, b]) => storedMatch(stored, a, b) && (a === medoid || b === medoid));
  if (nearest.length) {
    const [a, b] = nearest.reduce((best, edge) => edge[2] < best[2] ? edge : best);
    choose(medoid);
    choose(a === medoid ? b : a);
  }
  addLayerSwitches(stage, $('#tools'), ['surfaces', 'curves and sheets']);
  view.addSwitches($('#tools'));
}

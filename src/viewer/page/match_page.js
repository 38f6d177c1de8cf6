// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

import {BlendPlayer} from './blend_player.js';
import {$, addSwitch, addTabs, addWarnings, documentOf, element, setBreakable} from './dom.js';
import {bytesOfBase64, readGlb} from './glb.js';
import {counted, groupNumbers, indexedBlocks, listed, percent, readersNote, roleText, unsure} from './matching.js';
import {MatchView} from './match_view.js';
import {Stage} from './stage.js';

// The page of a result of `match`, with the blend where there is one.

/** A GLB that the page has for an id. */
export function glbOf(id) {
  return readGlb(bytesOfBase64(document.getElementById(id).textContent));
}

/** Adds all shapes of a GLB, each to a view of its own; every scene has the shapes in the same order. */
function addShapes(stage, glb, views) {
  for (const scene of glb.scenes)
    scene.nodes.forEach((shape, side) => {
      for (const node of shape.children)
        stage.addNode(views[side], node, node.extras.part === undefined ? -1 : node.extras.part);
    });
  // The same surfaces in their own materials cover those in the colours of the match
  const hasMaterials = stage.items.some(item => item.layer === 'materials');
  for (const item of stage.items) item.hasMaterials = hasMaterials;
  views.forEach(view => stage.centre(view));
  stage.equalise(views);
}

const layers = {
  'surfaces': 'The surfaces of the parts, in colours of what corresponds',
  'materials': 'The surfaces in their own colours and textures',
  'curves and sheets': 'What parts are compared by: rods by a curve, plates by a sheet',
  'contacts': 'Where parts touch',
};

/** Switches for the layers that the stage has. */
export function addLayerSwitches(stage, parent, shown) {
  for (const [layer, hint] of Object.entries(layers)) {
    if (!stage.items.some(item => item.layer === layer)) continue;
    stage.setLayer(layer, shown.includes(layer));
    addSwitch(parent, layer, hint, shown.includes(layer), isSet => stage.setLayer(layer, isSet));
  }
}

/** Whether a shape's parts were made of one object of its file. */
function isOnePiece(names) {
  return names.length > 1 && new Set(names.map(name => name.replace(/#\d+$/, ''))).size === 1;
}

/** What the page shows, for those who see it for the first time. */
function answer(result, blocks, names, titles) {
  const roles = [...new Set(blocks.map(block => block.role).filter(Boolean))].map(roleText);
  const sure = blocks.map(block => block.confidence).filter(value => value !== null), mean = sure.reduce((sum, value) => sum + value, 0) / sure.length;
  const what = !blocks.length ? 'No parts correspond.' : 'Parts that correspond have one colour' + (roles.length ? ': ' + listed(roles, 10) : '') +
      (sure.length ? `. They are right with a probability of ${percent(mean)} on average` : '') + '.';
  const missing = [result.unmatched_source, result.unmatched_target].map(
      (list, side) => list.length ? `${list.length} of the ${counted(names[side].length, 'part')} of ${titles[side]}` : '').filter(Boolean);
  return what + (missing.length ? ` Grey parts have no counterpart: ${missing.join(' and ')}.` : '') +
      (blocks.some(block => block.least !== null && block.least < unsure) ? ' What is pale or hatched is unsure.' : '');
}

export function showMatch() {
  const result = documentOf('match'), glb = glbOf('match.glb'), blend = documentOf('blend');
  const stage = new Stage($('#stage')), shapes = glb.scenes[0].nodes, titles = shapes.map(shape => shape.name);
  const views = titles.map(title => stage.addView(title));
  addShapes(stage, glb, views);
  const names = shapes.map(shape => shape.children.filter(n => n.extras.part !== undefined).map(n => n.name));
  const roles = [0, 1].map(side => {
    const known = result.roles ? result.roles[side === 0 ? 'source' : 'target'] : {};
    return names[side].map(name => known[name] || '');
  });
  const view = new MatchView(stage, views), blocks = indexedBlocks(result, names);
  addLayerSwitches(stage, $('#tools'), stage.items.some(i => i.layer === 'surfaces') ? ['surfaces'] : ['curves and sheets']);
  view.show({titles, names, labels: documentOf('labels'), roles, blocks, groups: groupNumbers(result, names)});
  view.addSwitches($('#tools'));
  setBreakable(titles.join(' and '), $('h1'));
  element('p', answer(result, blocks, names, titles), $('#facts'));
  const labels = documentOf('labels'), labelOf = new Map(names.flatMap((list, side) => list.map((name, part) => [name, labels[side][part]])));
  addWarnings($('#facts'), (result.warnings || []).map(note => readersNote(note, {[result.source]: titles[0], [result.target]: titles[1]})
      .replace(/'([^']+)'/g, (quoted, name) => labelOf.get(name) || quoted)));
  views.forEach((one, side) => { if (isOnePiece(names[side])) element('small', 'one piece in its file; its parts were found by their shape', one.caption); });
  addTabs([['models', blend ? 'Film' : 'Models'], ['list', 'Parts']]);
  if (blend) new BlendPlayer(view, blend, glbOf('blend.glb'));
}

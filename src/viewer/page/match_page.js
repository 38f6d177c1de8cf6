// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

import {BlendPlayer} from './blend_player.js';
import {$, addSwitch, addWarnings, documentOf, element} from './dom.js';
import {bytesOfBase64, readGlb} from './glb.js';
import {blocksOf, groupNumbers, indexedPairs} from './matching.js';
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
}

/** Switches for the layers that the stage has. */
export function addLayerSwitches(stage, parent, shown) {
  for (const layer of ['surfaces', 'materials', 'curves and sheets', 'contacts']) {
    if (!stage.items.some(item => item.layer === layer)) continue;
    stage.setLayer(layer, shown.includes(layer));
    addSwitch(parent, layer, shown.includes(layer), isSet => stage.setLayer(layer, isSet));
  }
}

export function showMatch() {
  const result = documentOf('match'), glb = glbOf('match.glb'), blend = documentOf('blend');
  const stage = new Stage($('#stage')), shapes = glb.scenes[0].nodes, titles = shapes.map(shape => shape.name);
  const views = titles.map(title => stage.addView(title));
  addShapes(stage, glb, views);
  const names = shapes.map(shape => shape.children.filter(n => n.extras.part !== undefined).map(n => n.name));
  const roles = result.roles ? [result.roles.source, result.roles.target] : [[], []];
  const view = new MatchView(stage, views);
  addLayerSwitches(stage, $('#tools'), stage.items.some(i => i.layer === 'surfaces') ? ['surfaces'] : ['curves and sheets']);
  view.show({titles, names, roles, blocks: blocksOf(indexedPairs(result, names), names[0].length, names[1].length),
             groups: groupNumbers(result, names)});
  view.addSwitches($('#tools'));
  $('h1').textContent = titles.join(' and ');
  const unmatched = view.blockOf.flat().filter(block => block < 0).length;
  element('p', `${result.pairs.length} pairs of parts, ${unmatched} parts without counterpart` +
          (result.category ? `; category: ${result.category}` : ''), $('#facts'));
  addWarnings($('#facts'), result.warnings);
  if (blend) new BlendPlayer(view, blend, glbOf('blend.glb'));
}

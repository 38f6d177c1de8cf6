// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

import {$, addTabs, addWarnings, cssColour, documentOf, element, linearColour, setBreakable, tip} from './dom.js';
import {addGestures} from './gestures.js';
import {addLayerSwitches, glbOf} from './match_page.js';
import {listed, readersNote, roleText} from './matching.js';
import {Selection} from './selection.js';
import {Stage} from './stage.js';
import {fillTable} from './table.js';

// The page of a structural graph.

const symmetries = {self: '', reflection: 'mirrored', rotation: 'in a ring', translation: 'in a row'};

function kindOf(part) {
  return part.type === 'sheet' ? 'sheet' : part.closed ? 'closed curve' : 'curve';
}

function detailsOf(part, group, touched, labelOf) {
  const labels = names => listed(names.map(name => labelOf.get(name)));
  const {method, repair, residual, coverage, flags, fallback} = part.abstraction || {};
  const lines = [`${kindOf(part)}${method ? `, ${method.replace(/_/g, ' ')}` : ''}`];
  if (group.parts.length > 1)
    lines.push(`${symmetries[group.symmetry] || 'alike'}: ` + labels(group.parts));
  if (touched.length) lines.push('touches ' + labels(touched));
  if (repair && repair !== 'none') lines.push('repaired: ' + repair);
  if (flags && flags.length) lines.push(flags.join(', ').replace(/_/g, ' '));
  if (fallback) lines.push('bounding box, because ' + fallback);
  if (residual !== undefined) lines.push(`residual ${residual.toPrecision(2)}, coverage ${coverage.toPrecision(2)}`);
  return lines;
}

export function showGraph() {
  const graph = documentOf('graph'), glb = glbOf('graph.glb'), stage = new Stage($('#stage'));
  const view = stage.addView(graph.name), shape = glb.scenes[0].nodes[0];
  const {labels, roles, colours} = documentOf('looks'), labelOf = new Map(graph.parts.map((part, i) => [part.name, labels[i]]));
  for (const node of shape.children)
    for (const item of stage.addNode(view, node, node.extras.part === undefined ? -1 : node.extras.part)) {
      if (item.part < 0) continue;
      if (!colours[item.part]) colours[item.part] = cssColour(item.mesh.colour);
      else item.colour.setRGB(...linearColour(colours[item.part]));
    }
  stage.centre(view);
  addLayerSwitches(stage, $('#tools'), ['surfaces', 'curves and sheets', 'contacts']);

  const groupOf = new Map(graph.groups.flatMap((group, g) => group.parts.map(name => [name, g])));
  const touched = new Map(graph.parts.map(part => [part.name, new Set()]));
  for (const {parts: [a, b]} of graph.contacts) { touched.get(a).add(b); touched.get(b).add(a); }
  const told = index => {
    const part = graph.parts[index];
    return [labels[index], [...(roles[index] ? ['role: ' + roleText(roles[index])] : []), ...(labels[index] === part.name ? [] : ['name in the file: ' + part.name]),
                            ...detailsOf(part, graph.groups[groupOf.get(part.name)], [...touched.get(part.name)], labelOf)]];
  };
  let table = null;
  const selection = new Selection(key => {
    stage.light(key === null ? null : item => item.part === key);
    table.light(key === null ? null : new Set([key]));
  });
  const order = graph.parts.map((part, i) => i).sort(
      (a, b) => groupOf.get(graph.parts[a].name) - groupOf.get(graph.parts[b].name) || a - b);
  table = fillTable($('table'), ['part', ...(roles.length ? ['role'] : []), 'kind', 'symmetry'].map(text => ({text})), order.map(i => {
    const part = graph.parts[i], group = graph.groups[groupOf.get(part.name)];
    return {key: i, colour: colours[i], words: [part.name], cells: [{text: labels[i], title: part.name}, ...(roles.length ? [roleText(roles[i])] : []), kindOf(part), group.parts.length > 1 ? symmetries[group.symmetry] : '']};
  }), selection, $('#search'));
  addGestures(stage, (item, x, y) => {
    selection.hover(item ? item.part : null);
    item ? tip.show(x, y, ...told(item.part)) : tip.hide();
  }, (item, x, y) => {
    item ? selection.pin(item.part) : selection.clear();
    selection.pinned === null ? tip.hide() : tip.show(x, y, ...told(item.part));
  });
  setBreakable(graph.name, $('h1'));
  element('p', `${graph.parts.length} parts, ${graph.groups.length} groups, ${graph.contacts.length} contacts`, $('#facts'));
  addWarnings($('#facts'), (graph.warnings || []).map(note => readersNote(note, {}).text));
  addTabs([['models', 'Model'], ['list', 'Parts']]);
}

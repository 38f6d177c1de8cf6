// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

import {$, addTabs, addWarnings, cssColour, documentOf, element, linearColour, setBreakable, tip} from './dom.js';
import {addGestures} from './gestures.js';
import {addLayerSwitches, glbOf} from './match_page.js';
import {counted, listed, readersNote, roleText} from './matching.js';
import {Selection} from './selection.js';
import {Stage} from './stage.js';
import {fillTable} from './table.js';

// The page of a structural graph.

const symmetries = {self: '', reflection: 'mirror images', rotation: 'in a ring', translation: 'in a row'};

const mostNames = 12; // limit for names of parts in a cell or line

function kindOf(part) {
  return part.type === 'sheet' ? 'sheet' : part.closed ? 'closed curve' : 'curve';
}

function detailsOf(part, group, touched, labels) {
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

/** A list that is folded. */
function addList(title, lines) {
  const details = element('details', '', $('#told'));
  element('summary', title, details);
  for (const line of lines) element('p', line, details);
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
  const labelsOf = names => listed(names.map(name => labelOf.get(name)), mostNames);
  const told = index => {
    const part = graph.parts[index];
    return [labels[index], [...(roles[index] ? ['role: ' + roleText(roles[index])] : []), ...(labels[index] === part.name ? [] : ['name in the file: ' + part.name]),
                            ...detailsOf(part, graph.groups[groupOf.get(part.name)], [...touched.get(part.name)], labelsOf)]];
  };
  let table = null;
  const selection = new Selection(key => {
    stage.light(key === null ? null : item => item.part === key);
    table.light(key === null ? null : new Set([key]));
  });
  const order = graph.parts.map((part, i) => i).sort(
      (a, b) => groupOf.get(graph.parts[a].name) - groupOf.get(graph.parts[b].name) || a - b);
  table = fillTable($('table'), ['part', 'kind', 'symmetric with', 'touches'].map(text => ({text})), order.map(i => {
    const part = graph.parts[i], group = graph.groups[groupOf.get(part.name)];
    const others = group.parts.filter(name => name !== part.name);
    return {key: i, colour: colours[i], words: [part.name, roleText(roles[i] || '')], cells: [{text: labels[i], title: part.name}, kindOf(part),
            {text: labelsOf(others), small: others.length ? symmetries[group.symmetry] || 'alike' : ''}, labelsOf([...touched.get(part.name)])]};
  }), selection, $('#search'));
  addGestures(stage, (item, x, y) => {
    selection.hover(item ? item.part : null);
    item ? tip.show(x, y, ...told(item.part)) : tip.hide();
  }, (item, x, y) => {
    item ? selection.pin(item.part) : selection.clear();
    selection.pinned === null ? tip.hide() : tip.show(x, y, ...told(item.part));
  });
  setBreakable(graph.name, $('h1'));
  element('p', `How ${graph.name} is built, as matches see it: each of ${counted(graph.parts.length, 'part')} is a curve if it is long, or a sheet if it is flat (the coloured pipes and plates in the faint surfaces); ` +
      'black lines join parts that touch.', $('#facts'));
  const groups = graph.groups.filter(group => group.parts.length > 1);
  addList(`${counted(groups.length, 'group')} of symmetric parts`, groups.map(group => `${labelsOf(group.parts)}: ${symmetries[group.symmetry] || 'alike'}`));
  addList(counted(graph.contacts.length, 'contact'), graph.contacts.map(({parts}) => labelsOf(parts)));
  addWarnings($('#facts'), (graph.warnings || []).map(note => readersNote(note, {}).text));
  addTabs([['models', 'Model'], ['list', 'Parts']]);
}

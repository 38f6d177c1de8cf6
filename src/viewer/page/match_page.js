// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

import {BlendPlayer} from './blend_player.js';
import {$, addSwitch, addTabs, addWarnings, documentOf, element, setBreakable} from './dom.js';
import {extentOf, rolesInOnePiece} from './extent.js';
import {bytesOfBase64, readGlb} from './glb.js';
import {counted, groupNumbers, indexedBlocks, listed, percent, readersNote, roleText, rowsByRole, unsure} from './matching.js';
import {MatchView} from './match_view.js';
import {Stage} from './stage.js';

// The page of a result of `match`, with the blend where there is one.

const mostNotes = 2; // limit for notes on the correspondence that are shown unfolded

/** The GLB with an id in the page. */
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

/** The text of `percent()` without a place for a line break. */
const percentText = share => percent(share).replace(' ', '\u00a0');

/** The same for a share that is not 0, which is not rounded to 0 %. */
const shareText = share => share < 0.005 ? 'less than 1\u00a0%' : percentText(share);

/** A sentence on parts without counterpart. @param missing such parts, by side @param shares of the surfaces that have one, by side */
function uncovered(missing, names, titles, shares) {
  const rest = [0, 1].filter(side => missing[side].length).map(side => `${missing[side].length} of ${counted(names[side].length, 'part')} of ${titles[side]}, ` +
      `${shareText(1 - shares[side])} of its surface`);
  return rest.length ? ` Grey parts have no counterpart: ${rest.join(', and ')}.` : ' Every part has a counterpart.';
}

/** A sentence on parts that have several roles in one piece (`rolesInOnePiece`); empty if there are none. */
export function inOnePiece(pieces, titles) {
  return pieces.map((list, side) => list.length ? ` In ${titles[side]}, ${list.map(([role, others]) => listed([role, ...others].map(roleText))).join(' seem to be one piece, and so do ')}` +
      (list.length === 1 ? ' seem to be one piece.' : '.') : '').join('');
}

/** A sentence on the pairs that the slider hides; empty if there are none. @param hidden their blocks */
function hiddenText(hidden, least) {
  if (!hidden.length) return '';
  const parts = [0, 1].map(side => hidden.reduce((sum, block) => sum + block.parts[side].length, 0)), roles = [...new Set(hidden.map(block => block.role).filter(Boolean))].map(roleText);
  return ` Hidden, because they are below ${percent(least)}, and drawn faint: ${roles.length ? listed(roles, 10) + ', ' : ''}${counted(parts[0], 'part')} and their ${counted(parts[1], 'counterpart')}.`;
}

/** A sentence with the mean confidence of blocks and the least mean of a row of the table; empty if they have no confidence. */
function sureText(blocks, labels) {
  const rated = blocks.filter(({confidence}) => confidence !== null), mean = of => of.reduce((sum, {confidence}) => sum + confidence, 0) / of.length;
  if (!rated.length) return '';
  const rows = rowsByRole(rated).map(row => ({...row, confidence: mean(row.blocks.map(b => rated[b]))}));
  const last = rows.reduce((least, row) => row.confidence < least.confidence ? row : least), all = percentText(mean(rated));
  const name = last.role ? roleText(last.role) : labels[0][rated[last.blocks[0]].parts[0][0]];
  return ` The program is ${all} sure of this` + (percentText(last.confidence) === all ? ', of all parts alike.' : ` on average, and least of ${name}, ${percentText(last.confidence)}.`);
}

/** The text that explains the page. @param blocks that are shown @param rest, hidden sentences on parts and pairs that are not */
function answer(blocks, labels, rest, hidden) {
  const roles = [...new Set(blocks.map(block => block.role).filter(Boolean))].map(roleText);
  if (!blocks.length) return hidden ? 'All pairs of parts are hidden.' + hidden : 'No parts correspond.';
  return 'Parts of one colour correspond' + (roles.length ? ': ' + listed(roles, 10) : '') + '.' + sureText(blocks, labels) + rest + unsureText(blocks) + hidden;
}

/** A sentence on the meaning of stripes; empty if there are none. */
export function unsureText(blocks) {
  return blocks.some(({least}) => least !== null && least < unsure) ? ` Striped parts are unsure, less than ${percent(unsure)}.` : '';
}

/** What a film shows, and what of the match it leaves out. */
function filmText(blend, titles) {
  if (!blend) return '';
  const left = blend.warnings.filter(warning => / correspond with probability /.test(warning)).length;
  return `Press Play: ${titles[0]} becomes ${titles[1]}.` + (left ? ` ${counted(left, 'less probable pair')} of the match ${left === 1 ? 'is' : 'are'} left out, so that averages differ from its page.` : '') + ' ';
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
  const labels = documentOf('labels'), labelOf = new Map(names.flatMap((list, side) => list.map((name, part) => [name, labels[side][part]])));
  const extents = views.map(of => extentOf(stage.items.filter(({view, layer, part}) => view === of && layer === 'surfaces' && part >= 0)));
  const pieces = [0, 1].map(side => rolesInOnePiece(extents[side].points, roles[side], roles[1 - side]));
  const missing = [result.unmatched_source, result.unmatched_target].map((list, side) => list.map(name => names[side].indexOf(name)));
  const shares = missing.map((list, side) => { // of surfaces, or of parts if there are none
    const sizeOf = part => extents[side].areas.length ? extents[side].areas[part] || 0 : 1, sum = parts => parts.reduce((all, part) => all + sizeOf(part), 0);
    return 1 - sum(list) / (sum(names[side].map((_, part) => part)) || 1);
  });
  view.show({titles, names, labels, roles, blocks, pieces, groups: groupNumbers(result, names)});
  view.addSwitches($('#tools'));
  setBreakable(blend ? `From ${titles[0]} to ${titles[1]}` : titles.join(' and '), $('h1'));
  const facts = element('p', '', $('#facts')), tell = () => {
    const [shown, hidden] = [true, false].map(isShown => blocks.filter(block => view.isSure(block) === isShown));
    facts.textContent = filmText(blend, titles) + answer(shown, labels, uncovered(missing, names, titles, shares), hiddenText(hidden, view.leastConfidence)) + inOnePiece(pieces, titles);
  };
  tell();
  view.listeners.push(tell);
  const notes = (result.warnings || []).map(note => readersNote(note, {[result.source]: titles[0], [result.target]: titles[1]}));
  const told = notes.filter(({text, isReading}) => text && !isReading).map(({text}) => text.replace(/'([^']+)'/g, (quoted, name) => labelOf.get(name) || quoted));
  for (const note of told.slice(0, mostNotes)) element('p', note, $('#facts')).className = 'note';
  const single = titles.filter((_, side) => isOnePiece(names[side])).map(title => `${title} is one piece in its file; its parts were found by their shape.`);
  addWarnings($('#facts'), [...told.slice(mostNotes), ...single, ...notes.filter(note => note.isReading).map(note => note.text)], told.length > mostNotes ? '' : ' on how the files were read');
  addTabs([['models', blend ? 'Film' : 'Models'], ['list', 'Parts']]);
  if (blend) new BlendPlayer(view, blend, glbOf('blend.glb'));
}

// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

import {$, addTabs, cssColour, documentOf, element, setBreakable, tip} from './dom.js';
import {fillGallery, Pictures} from './gallery.js';
import {extentOf, rolesInOnePiece} from './extent.js';
import {addGestures} from './gestures.js';
import {glbOf, inOnePiece} from './match_page.js';
import {counted, percent, roleText} from './matching.js';
import {Selection} from './selection.js';
import {Stage} from './stage.js';
import {fillTable} from './table.js';

// The page of `parts`: which parts models have, what became of their objects, and parts that one joins and divides by clicks.
// What is drawn are units: pieces, if the model has a tree of their unions, or else parts.

export function showParts() {
  const {models} = documentOf('parts'), nodes = glbOf('parts.glb').scenes[0].nodes;
  const stage = new Stage($('#stage')), view = stage.addView('');
  stage.setLayer('surfaces', true);
  setBreakable(models.length === 1 ? models[0].name : `Parts of ${models.length} models`, $('h1'));
  element('p', 'Each colour is a part, as a match takes it. If it should be another one, click it, and join it with others or divide it.', $('#facts'));
  const openTab = addTabs([...(models.length > 1 ? [['shapes', 'Models']] : []), ['models', 'Picture'], ['list', 'Parts']]);
  let model = null, table = null, start = [], into = [], colours = []; // by unit: its original part; the first unit of its present part, whose index is the part's key; its colour
  const marked = new Set(), buttons = {};
  const unitsOf = part => into.map((_, i) => i).filter(i => into[i] === part);
  const firsts = () => into.map((_, i) => i).filter(i => into[i] === i);
  const hasTree = () => model.unions.length > 0;
  const unitOf = k => hasTree() ? k : model.pieces[k][0]; // of a piece; -1: none
  /** Pieces, and unions of them that may be parts, as sets of units; a set comes before all sets that contain it. */
  function candidates() {
    const sets = model.unions.length ? into.map((_, i) => new Set([i])) : [];
    for (const [a, b] of model.unions) sets.push(new Set([...sets[a], ...sets[b]]));
    return sets;
  }
  const isIn = (set, units) => [...set].every(unit => units.has(unit));
  /** The parts that the smallest union larger than a part consists of. */
  function wider(part) {
    const units = new Set(unitsOf(part)), union = candidates().find(set => set.size > units.size && isIn(units, set));
    return union ? new Set([...union].map(unit => into[unit])) : new Set();
  }
  /** The largest unions within a part that are smaller than it. */
  function narrower(part) {
    const units = new Set(unitsOf(part)), result = [];
    for (const set of candidates().reverse())
      if (set.size < units.size && isIn(set, units) && !result.some(one => isIn(set, one))) result.push(set);
    return result;
  }
  /** A part's name, with a number if it is one of several into which a part was divided. */
  function named(part, names) {
    const number = firsts().filter(i => start[i] === start[part]).indexOf(part);
    return names[start[part]] + (number > 0 ? ` (${number + 1})` : '');
  }
  const light = key => {
    const keys = key === null ? new Set(marked) : new Set([key, ...marked]);
    stage.light(keys.size ? item => keys.has(into[item.part]) : null);
    table.light(keys);
  };
  const selection = new Selection(light);
  selection.pin = part => {
    marked.delete(part) || marked.add(part);
    selection.clear();
    update();
  };
  // A reason names pieces; the text for people names the parts that contain them
  const readable = (reason, part) => [...model.list.pieces.keys()].sort((a, b) => model.list.pieces[b].piece.length - model.list.pieces[a].piece.length).reduce((text, k) => {
    const of = unitOf(k) < 0 ? -1 : into[unitOf(k)], {piece} = model.list.pieces[k];
    return of === part ? text.replace(` with ${piece}`, '').replace(piece, 'it') : text.replace(piece, of < 0 ? piece : named(of, model.labels));
  }, reason);
  const told = part => {
    const pieces = model.pieces.filter((_, k) => unitOf(k) >= 0 && into[unitOf(k)] === part), parts = new Set(unitsOf(part).map(i => start[i])), reasons = [...new Set(pieces.map(([,, reason]) => readable(reason, part)).filter(Boolean))];
    const size = Math.max(0, ...pieces.map(piece => piece[1]));
    return {size, reason: (pieces.length > 1 ? counted(pieces.length, 'piece') + (reasons.length ? ': ' + reasons.join('; ') : '') : 'one piece') + (parts.size > 1 ? ', joined by you' : firsts().some(i => i !== part && start[i] === start[part]) ? ', divided by you' : '')};
  };
  addGestures(stage, (item, x, y) => {
    selection.hover(item ? into[item.part] : null);
    item ? tip.show(x, y, named(into[item.part], model.labels), [named(into[item.part], model.parts), told(into[item.part]).reason]) : tip.hide();
  }, item => {
    tip.hide();
    if (item) return selection.pin(into[item.part]);
    marked.clear();
    selection.clear();
    update();
  });

  function update() {
    const [one] = marked, together = marked.size === 1 ? wider(one) : marked;
    buttons.join.disabled = together.size < 2;
    buttons.join.textContent = together.size < 2 ? 'Join' : `Join ${together.size} parts`;
    buttons.join.title = marked.size === 1 ? 'with what it most probably is one part with' : '';
    buttons.join.onclick = () => join(together);
    buttons.divide.hidden = !hasTree();
    buttons.divide.disabled = marked.size !== 1 || narrower(one).length < 2;
    buttons.divide.onclick = () => divide(one);
    buttons.back.disabled = buttons.save.disabled = into.every((part, i) => part === start.indexOf(start[i]));
    buttons.join.classList.toggle('next', marked.size > 1);
    buttons.save.classList.toggle('next', !buttons.save.disabled && marked.size < 2);
  }

  /** @param chosen a part that stays marked */
  function list(chosen) {
    const hasRoles = model.roles.some(Boolean);
    const columns = [{text: 'part'}, ...(hasRoles ? [{text: 'role', kind: 'narrow'}] : []), {text: 'size', kind: 'narrow'}, {text: 'made of'}];
    const rows = firsts().map(part => {
      const {size, reason} = told(part);
      return {key: part, colour: colours[part] || 'none', words: unitsOf(part).map(i => model.parts[start[i]]),
              cells: [{text: named(part, model.labels), title: named(part, model.parts)}, ...(hasRoles ? [roleText(model.roles[start[part]])] : []), {text: percent(size), title: 'of the size of the model'}, reason]};
    });
    table = fillTable($('table'), columns, rows, selection, $('#search'));
    for (const item of stage.items) item.colour.setStyle(colours[into[item.part]]).convertSRGBToLinear();
    marked.clear();
    if (chosen !== undefined) marked.add(chosen);
    selection.clear();
    update();
  }

  const asAtFirst = () => { into = start.map(part => start.indexOf(part)); list(); };

  function join(parts) {
    const first = Math.min(...parts);
    into = into.map(part => parts.has(part) ? first : part);
    list(hasTree() ? first : undefined);
  }

  function divide(part) {
    const units = unitsOf(part);
    for (const set of narrower(part)) for (const unit of set) into[unit] = Math.min(...set);
    for (const i of units) if (into[i] === i && i !== part) colours[i] = `hsl(${(137 * i) % 360}, 55%, 60%)`; // a colour unlike those of neighbours
    list();
  }

  /** The list of pieces as the program reads it. */
  function partsFile() {
    const pieces = model.list.pieces.map(({piece}, k) => ({piece, part: unitOf(k) < 0 ? '' : named(into[unitOf(k)], model.parts)}));
    return JSON.stringify({...model.list, pieces}, null, 1);
  }

  function choose(i) {
    model = models[i];
    cards.forEach((button, k) => button.classList.toggle('chosen', k === i));
    stage.clear(view);
    if (model.unusable) model.unions = model.labels = model.roles = model.pieces = [];
    start = hasTree() ? model.pieces.map(([part]) => part) : model.parts.map((_, part) => part);
    colours = [];
    if (!model.unusable) nodes[i].children.forEach((node, unit) => stage.addNode(view, node, unit).forEach(item => { colours[unit] = cssColour(item.mesh.colour); }));
    stage.centre(view);
    setBreakable(model.name, view.caption);
    $('#told').replaceChildren();
    element('p', model.summary, $('#told'));
    const roles = start.map(part => model.roles[part]), isSeat = roles.includes('seat') || roles.includes('back');
    const whole = isSeat ? rolesInOnePiece(extentOf(stage.items).points, roles, ['seat', 'back', 'armrest', 'leg']) : [];
    if (whole.length) element('p', inOnePiece([whole], [model.name]) + ' The option --parts segments may divide it.', $('#told'));
    const line = element('div', '', $('#told'));
    line.className = 'choices';
    line.hidden = Boolean(model.unusable);
    const add = (name, text, action) => { (buttons[name] = element('button', text, line)).onclick = action; };
    add('join', 'Join');
    add('divide', 'Divide');
    add('back', 'Undo all', asAtFirst);
    add('save', 'Save parts.json', () => {
      const link = element('a', '', document.body);
      Object.assign(link, {href: URL.createObjectURL(new Blob([partsFile()], {type: 'application/json'})), download: model.name + '.parts.json'});
      link.click();
      link.remove();
      if (!$('#told code')) element('code', `shape_correspondence match ${model.name} OTHER --source-parts-from ${model.name}.parts.json`, line.parentNode);
    });
    $('#stage').partsFile = partsFile; // for tests
    const details = element('details', '', $('#told'));
    details.hidden = !model.objects.length;
    element('summary', counted(model.objects.length, 'object') + ' of the file', details);
    for (const [name, decision] of model.objects) element('p', `${name}: ${decision}`, details);
    asAtFirst();
  }

  const cards = models.length < 2 ? [] : fillGallery($('#gallery'), models.map((one, i) => (
      {name: one.name, mark: one.unusable ? 'unusable' : '', shape: one.unusable ? null : nodes[i]})), new Pictures(), i => { choose(i); openTab('models'); });
  if (models.length > 1) document.body.classList.add('with-gallery');
  choose(0);
}

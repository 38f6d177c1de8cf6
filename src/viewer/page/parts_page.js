// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

import {$, addTabs, cssColour, documentOf, element, setBreakable, tip} from './dom.js';
import {fillGallery, Pictures} from './gallery.js';
import {addGestures} from './gestures.js';
import {glbOf} from './match_page.js';
import {counted, percent, roleText} from './matching.js';
import {Selection} from './selection.js';
import {Stage} from './stage.js';
import {fillTable} from './table.js';

// The page of `parts`: which parts models have, what became of their objects, and parts that one joins by clicks.

export function showParts() {
  const {models} = documentOf('parts'), nodes = glbOf('parts.glb').scenes[0].nodes;
  const stage = new Stage($('#stage')), view = stage.addView('');
  stage.setLayer('surfaces', true);
  setBreakable(models.length === 1 ? models[0].name : `Parts of ${models.length} models`, $('h1'));
  element('p', 'Each colour is a part, as a match takes it. If several are one, click them and join them.', $('#facts'));
  const openTab = addTabs([...(models.length > 1 ? [['shapes', 'Models']] : []), ['models', 'Picture'], ['list', 'Parts']]);
  let model = null, table = null, into = [], colours = []; // by part, the part that it is joined into
  const marked = new Set(), buttons = {};
  const joined = part => into.map((_, i) => i).filter(i => into[i] === part);
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
  // A reason names pieces; people know their parts
  const readable = (reason, part) => [...model.list.pieces.keys()].sort((a, b) => model.list.pieces[b].piece.length - model.list.pieces[a].piece.length).reduce((text, k) => {
    const of = model.pieces[k][0] < 0 ? -1 : into[model.pieces[k][0]], {piece} = model.list.pieces[k];
    return of === part ? text.replace(` with ${piece}`, '').replace(piece, 'it') : text.replace(piece, of < 0 ? piece : model.labels[of]);
  }, reason);
  const told = part => {
    const pieces = model.pieces.filter(([of]) => of >= 0 && into[of] === part), reasons = [...new Set(pieces.map(([,, reason]) => readable(reason, part)).filter(Boolean))];
    const size = Math.max(0, ...pieces.map(piece => piece[1]));
    return {size, reason: (pieces.length > 1 ? counted(pieces.length, 'piece') + (reasons.length ? ': ' + reasons.join('; ') : '') : 'one piece') + (joined(part).length > 1 ? ', joined by you' : '')};
  };
  addGestures(stage, (item, x, y) => {
    selection.hover(item ? into[item.part] : null);
    item ? tip.show(x, y, model.labels[into[item.part]], [model.parts[into[item.part]], told(into[item.part]).reason]) : tip.hide();
  }, item => {
    tip.hide();
    if (item) return selection.pin(into[item.part]);
    marked.clear();
    selection.clear();
    update();
  });

  function update() {
    buttons.join.disabled = marked.size < 2;
    buttons.join.textContent = marked.size < 2 ? 'Join' : `Join ${marked.size} parts`;
    buttons.back.disabled = buttons.save.disabled = into.every((part, i) => part === i);
    buttons.join.classList.toggle('next', !buttons.join.disabled);
    buttons.save.classList.toggle('next', !buttons.save.disabled && buttons.join.disabled);
  }

  function list() {
    const hasRoles = model.roles.some(Boolean);
    const columns = [{text: 'part'}, ...(hasRoles ? [{text: 'role', kind: 'narrow'}] : []), {text: 'size', kind: 'narrow'}, {text: 'made of'}];
    const rows = into.map((_, i) => i).filter(i => into[i] === i).map(part => {
      const {size, reason} = told(part);
      return {key: part, colour: colours[part] || 'none', words: joined(part).map(i => model.parts[i]),
              cells: [{text: model.labels[part], title: model.parts[part]}, ...(hasRoles ? [roleText(model.roles[part])] : []), {text: percent(size), title: 'of the size of the model'}, reason]};
    });
    table = fillTable($('table'), columns, rows, selection, $('#search'));
    for (const item of stage.items) item.colour.setStyle(colours[into[item.part]]).convertSRGBToLinear();
    marked.clear();
    selection.clear();
    update();
  }

  function join(parts) {
    const first = Math.min(...parts);
    into = into.map(part => parts.has(part) ? first : part);
    list();
  }

  /** The list of pieces as the program reads it. */
  function partsFile() {
    const pieces = model.list.pieces.map(({piece}, k) => ({piece, part: model.pieces[k][0] < 0 ? '' : model.parts[into[model.pieces[k][0]]]}));
    return JSON.stringify({...model.list, pieces}, null, 1);
  }

  function choose(i) {
    model = models[i];
    cards.forEach((button, k) => button.classList.toggle('chosen', k === i));
    stage.clear(view);
    into = model.parts.map((_, part) => part);
    colours = [];
    if (!model.unusable) nodes[i].children.forEach((node, part) => stage.addNode(view, node, part).forEach(item => { colours[part] = cssColour(item.mesh.colour); }));
    stage.centre(view);
    setBreakable(model.name, view.caption);
    $('#told').replaceChildren();
    element('p', model.summary, $('#told'));
    const line = element('div', '', $('#told'));
    line.className = 'choices';
    line.hidden = Boolean(model.unusable);
    const add = (name, text, action) => { (buttons[name] = element('button', text, line)).onclick = action; };
    add('join', 'Join', () => join(new Set(marked)));
    add('back', 'Undo all', () => { into = model.parts.map((_, part) => part); list(); });
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
    if (model.unusable) model.labels = model.roles = model.pieces = [];
    list();
  }

  const cards = models.length < 2 ? [] : fillGallery($('#gallery'), models.map((one, i) => (
      {name: one.name, mark: one.unusable ? 'unusable' : '', shape: one.unusable ? null : nodes[i]})), new Pictures(), i => { choose(i); openTab('models'); });
  if (models.length > 1) document.body.classList.add('with-gallery');
  choose(0);
}

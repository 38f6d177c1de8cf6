// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

import {$, cssColour, documentOf, element, setBreakable, tip} from './dom.js';
import {fillGallery, Pictures} from './gallery.js';
import {addGestures} from './gestures.js';
import {glbOf} from './match_page.js';
import {Selection} from './selection.js';
import {Stage} from './stage.js';
import {fillTable} from './table.js';

// The page of `parts`: which parts models have, and what became of their objects.

export function showParts() {
  const {models} = documentOf('parts'), nodes = glbOf('parts.glb').scenes[0].nodes;
  const stage = new Stage($('#stage')), view = stage.addView('');
  stage.setLayer('surfaces', true);
  setBreakable(models.length === 1 ? models[0].name : `Parts of ${models.length} models`, $('h1'));
  let table = null, parts = [];
  const selection = new Selection(key => {
    stage.light(key === null ? null : item => item.part === key);
    table.light(key === null ? null : new Set([key]));
  });
  addGestures(stage, (item, x, y) => {
    selection.hover(item ? item.part : null);
    item ? tip.show(x, y, parts[item.part], []) : tip.hide();
  }, (item, x, y) => {
    item ? selection.pin(item.part) : selection.clear();
    selection.pinned === null ? tip.hide() : tip.show(x, y, parts[item.part], []);
  });

  function choose(i) {
    const model = models[i], colours = [];
    buttons.forEach((button, k) => button.classList.toggle('chosen', k === i));
    stage.clear(view);
    parts = model.parts;
    nodes[i].children.forEach((node, part) => stage.addNode(view, node, part).forEach(
        item => { colours[part] = cssColour(item.mesh.colour); }));
    stage.centre(view);
    setBreakable(model.name, view.caption);
    table = fillTable($('table'), [{text: 'part'}], parts.map((name, part) => ({key: part, colour: colours[part] || 'none', cells: [name]})),
                      selection, $('#search'));
    selection.clear();
    $('#told').replaceChildren();
    element('p', model.summary, $('#told'));
    const details = element('details', '', $('#told'));
    element('summary', model.objects.length === 1 ? '1 object' : `${model.objects.length} objects`, details);
    for (const [name, decision] of model.objects) element('p', `${name}: ${decision}`, details);
  }

  const buttons = models.length < 2 ? [] : fillGallery($('#gallery'), models.map((model, i) => (
      {name: model.name, mark: model.unusable ? 'unusable' : '', shape: model.unusable ? null : nodes[i]})), new Pictures(), choose);
  if (models.length > 1) document.body.classList.add('with-gallery');
  choose(0);
}

// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

import {$, addSwitch, cssColour, element, tip} from './dom.js';
import {addGestures} from './gestures.js';
import {cellOf, inWords, listed, operationText, percent} from './matching.js';
import {Selection} from './selection.js';
import {fillTable} from './table.js';

// Two shapes beside each other, and what corresponds: what is chosen in one lights up in the other.

const grey = [0.45, 0.45, 0.45];

/** Lines between counterparts, over the stage. */
class Links {
  constructor(stage) {
    this.stage = stage;
    this.canvas = element('canvas', '', stage.root);
    this.canvas.className = 'links';
  }
  /** @param links [{ends: [[view, part], [view, part]], colour}] */
  draw(links) {
    const box = this.stage.root.getBoundingClientRect(), ratio = Math.min(devicePixelRatio, 2);
    this.canvas.width = box.width * ratio;
    this.canvas.height = box.height * ratio;
    const g = this.canvas.getContext('2d');
    g.scale(ratio, ratio);
    g.lineWidth = 1.5;
    for (const link of links) {
      const [a, b] = link.ends.map(([view, part]) => this.stage.placeOf(view, part));
      if (!a || !b) continue;
      g.strokeStyle = link.colour;
      g.beginPath();
      g.moveTo(a[0] - box.left, a[1] - box.top);
      g.lineTo(b[0] - box.left, b[1] - box.top);
      g.stroke();
    }
  }
}

export class MatchView {
  /** @param views of the stage: source, target, and maybe others whose items have `sides`, [source, target] parts */
  constructor(stage, views) {
    this.stage = stage;
    this.views = views;
    this.links = new Links(stage);
    this.hasLinks = this.hasGroups = false;
    this.leastConfidence = 0;
    this.selection = new Selection(key => this.light(key));
    addGestures(stage, (item, x, y) => this.point(item, x, y), (item, x, y) => this.click(item, x, y));
    stage.afterDrawing = () => this.links.draw(this.shownLinks());
    addEventListener('keydown', event => { if (event.key === 'Escape') this.clear(); });
  }

  /** The switches of the page. */
  addSwitches(parent) {
    addSwitch(parent, 'links', 'Lines between corresponding parts', false, isSet => { this.hasLinks = isSet; this.stage.redraw(); });
    if (this.match.groups.some(numbers => numbers.some(n => n >= 0)))
      addSwitch(parent, 'groups', 'One colour for the symmetric parts that were matched together', false,
                isSet => { this.hasGroups = isSet; this.colour(); this.light(this.selection.key); });
    if (!this.match.blocks.some(block => block.confidence !== null)) return;
    const label = element('label', 'hide pairs below ', parent), slider = element('input', '', label), told = element('output', '0 %', label);
    label.title = 'Hides what corresponds less surely';
    Object.assign(slider, {type: 'range', min: 0, max: 1, step: 0.05, value: 0, ariaLabel: 'least confidence that is shown'});
    slider.oninput = () => {
      this.leastConfidence = Number(slider.value);
      told.textContent = percent(this.leastConfidence);
      this.colour();
    };
  }

  /**
   * @param match {titles, names, labels, blocks, roles, groups, colourOf(side, part)}: lists by side; `labels` are the names as
   * people read them; `roles` may hold empty lists; the colours are in linear light; without `colourOf` a part has the
   * colour of its meshes
   */
  show(match) {
    this.match = match;
    this.blockOf = match.names.map(list => list.map(() => -1));
    match.blocks.forEach((block, b) => block.parts.forEach(
        (parts, side) => parts.forEach(part => { this.blockOf[side][part] = b; })));
    this.own = match.names.map((list, side) => list.map((_, part) => this.ownColour(side, part)));
    const hasRoles = match.blocks.some(block => block.role), hasConfidence = match.blocks.some(block => block.confidence !== null);
    const columns = [...(hasRoles ? [{text: 'role', kind: 'narrow'}] : []), ...match.titles.map(text => ({text})),
                     {text: 'operation', kind: 'narrow minor'}, ...(hasConfidence ? [{text: 'confidence', kind: 'narrow'}] : [])];
    const first = hasRoles ? 1 : 0; // column of the source
    const row = (key, colour, role, sides, others) => {
      const labels = sides.map((parts, side) => parts.map(part => match.labels[side][part]));
      const result = {key, colour, words: sides.flatMap((parts, side) => parts.map(part => match.names[side][part])).concat(...labels),
                      cells: [...(hasRoles ? [role] : []), ...labels.map(list => cellOf(list) || '–'), ...others].slice(0, columns.length)};
      if (sides.some(parts => parts.length > 1)) {
        result.parts = [];
        sides.forEach((parts, side) => {
          result.parts[first + side] = parts.map((part, i) => ({name: labels[side][i], key: side + ':' + part}));
        });
      }
      return result;
    };
    const rows = match.blocks.map((block, b) => row(
        'b' + b, cssColour(this.own[0][block.parts[0][0]]), block.role, block.parts, [operationText(block), percent(block.confidence)]));
    match.names.forEach((list, side) => {
      const parts = list.map((_, part) => part).filter(part => this.blockOf[side][part] < 0), sides = [[], []];
      sides[side] = parts;
      if (parts.length) rows.push(row('none' + side, cssColour(grey), '', sides, ['none', '']));
    });
    this.table = fillTable($('table'), columns, rows, this.selection, $('#search'));
    this.colour();
    this.selection.clear();
  }

  ownColour(side, part) {
    if (this.match.colourOf) return this.match.colourOf(side, part);
    const item = this.stage.items.find(i => i.view === this.views[side] && i.part === part);
    return item ? item.mesh.colour : grey;
  }

  isSure(block) { return block.confidence === null || block.confidence >= this.leastConfidence; }

  /** Parts of a group have the colour of its first one; what is not sure enough is grey. */
  colour() {
    const {blocks, groups} = this.match, first = new Map();
    groups.forEach((numbers, side) => numbers.forEach((n, part) => {
      if (n >= 0 && !first.has(n) && this.blockOf[side][part] >= 0) first.set(n, this.own[side][part]);
    }));
    const colourOf = (side, part) => {
      const block = blocks[this.blockOf[side][part]], group = (groups[side] || [])[part];
      if (block && !this.isSure(block)) return grey;
      return this.hasGroups && first.has(group) && block ? first.get(group) : this.own[side][part];
    };
    for (const item of this.stage.items) {
      if (item.part < 0 || item.layer === 'materials') continue;
      item.colour.setRGB(...colourOf(...this.placeOfItem(item)).slice(0, 3));
    }
    const colours = new Map(blocks.map((block, b) => ['b' + b, cssColour(colourOf(0, block.parts[0][0]))]));
    [0, 1].forEach(side => colours.set('none' + side, cssColour(grey)));
    this.table.paint(colours);
    this.table.hide(new Set(blocks.flatMap((block, b) => this.isSure(block) ? [] : ['b' + b])));
    this.stage.redraw();
  }

  /** The key of what a part belongs to: of its block, or of all parts without counterpart. */
  keyOf(side, part) {
    const block = this.blockOf[side][part];
    return block >= 0 ? 'b' + block : 'none' + side;
  }

  /** The side and the part that an item shows; of what is in between, that of the source if it has one. */
  placeOfItem(item) {
    if (!item.sides) return [this.views.indexOf(item.view), item.part];
    return item.sides[0] >= 0 ? [0, item.sides[0]] : [1, item.sides[1]];
  }

  /** All keys that light up with one; that of a single part, SIDE:PART, is alone. */
  keysWith(key) {
    const keys = new Set([key]);
    if (!this.hasGroups) return keys;
    const groups = new Set();
    const each = visit => this.match.groups.forEach((numbers, side) => numbers.forEach(
        (n, part) => { if (n >= 0) visit(n, this.keyOf(side, part)); }));
    each((n, own) => { if (own === key) groups.add(n); });
    each((n, own) => { if (groups.has(n)) keys.add(own); });
    return keys;
  }

  light(key) {
    const keys = key === null ? null : this.keysWith(key);
    this.lit = keys;
    this.stage.light(keys && (item => {
      if (item.part < 0) return false;
      const place = this.placeOfItem(item);
      return keys.has(this.keyOf(...place)) || keys.has(place.join(':'));
    }));
    if (this.table) this.table.light(keys);
  }

  /** What pointing at an item, or choosing it, lights: its block, or itself if it has no counterpart. */
  keyOfItem(item) {
    const place = this.placeOfItem(item);
    return this.blockOf[place[0]][place[1]] >= 0 ? this.keyOf(...place) : place.join(':');
  }

  point(item, x, y) {
    this.selection.hover(item ? this.keyOfItem(item) : null);
    item ? tip.show(x, y, ...this.told(item)) : tip.hide();
  }

  click(item, x, y) {
    if (!item) return this.clear();
    this.selection.pin(this.keyOfItem(item));
    this.selection.pinned === null ? tip.hide() : tip.show(x, y, ...this.told(item));
  }

  clear() {
    tip.hide();
    this.selection.clear();
  }

  /** The title and the lines of the tip of a part. */
  told(item) {
    const {names, labels, roles, titles, blocks} = this.match;
    const [side, part] = this.placeOfItem(item), block = blocks[this.blockOf[side][part]], lines = [];
    if (roles[side][part]) lines.push('role: ' + roles[side][part]);
    if (!block) return [names[side][part], lines.concat('no counterpart')];
    lines.push(inWords(block, side));
    lines.push(`in ${titles[1 - side]}: ` + listed(block.parts[1 - side].map(p => labels[1 - side][p])));
    if (block.confidence !== null) lines.push('confidence: ' + percent(block.confidence));
    return [names[side][part], lines];
  }

  /** With the switch all links, else none. Of what is chosen, if something is. */
  shownLinks() {
    if (!this.match || !this.hasLinks) return [];
    return this.match.blocks.flatMap((block, b) => (this.lit && !this.lit.has('b' + b)) || !this.isSure(block) ? [] :
        block.parts[0].flatMap(source => block.parts[1].map(target => ({
          ends: [[this.views[0], source], [this.views[1], target]], colour: cssColour(this.own[0][source])}))));
  }
}

// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

import {$, addSwitch, cssColour, element, linearColour, tip} from './dom.js';
import {addGestures} from './gestures.js';
import {countedParts, inWords, listed, operationText, percent, roleText, rowsByRole, sentenceOf, unsure, withRanges} from './matching.js';
import {Selection} from './selection.js';
import {fillTable} from './table.js';

// Two shapes beside each other: the parts that correspond to those chosen in one shape light up in the other.

const grey = [0.45, 0.45, 0.45];
const hiddenOpacity = 0.25; // of pairs that the slider hides
const spare = ['#c77d1e', '#2f7fc1', '#a3559e', '#3f9c6d'].map(linearColour); // for pairs whose parts have no colour of their own
const leastChroma = 0.02; // difference of channels up to which a colour counts as grey
const leastLabelled = 14, leastChosen = 4, leastView = 170; // pixels: side of the least square that gets a label, the same if it is chosen, least side of a view
const labelHeight = 18, farthestLabel = 90, labelStep = 8; // pixels
const labelShare = 0.6; // least share of a label's area that is over its own part if the label is placed there

/** Labels of parts and lines between counterparts, over the stage. */
export class Overlay {
  constructor(stage) {
    this.stage = stage;
    this.canvas = element('canvas', '', stage.root);
    this.canvas.className = 'links';
  }
  /**
   * The box of a label: on its part if it fits there, or else on the background, as near as possible; null if it would cover
   * another label everywhere. @param half half of the label's width
   */
  placeOfLabel({spots, number, shareOf, confine}, half) {
    const boxAt = (x, y) => ({left: x - half, right: x + half, top: y - labelHeight / 2, bottom: y + labelHeight / 2});
    const isClear = box => box.left >= confine.left && box.right <= confine.left + confine.width && box.top >= confine.top && box.bottom <= confine.top + confine.height &&
        this.placed.every(other => box.right < other.left || box.left > other.right || box.bottom + 2 < other.top || box.top - 2 > other.bottom);
    const on = spots.map(({x, y}) => boxAt(x, y)).find(box => isClear(box) && shareOf(box, number) >= labelShare);
    if (on) return on;
    const [{x, y}] = spots;
    for (let far = labelStep; far <= farthestLabel; far += labelStep)
      for (let turn = 0; turn < 8; ++turn) {
        const [dx, dy] = [Math.cos(turn * Math.PI / 4), Math.sin(turn * Math.PI / 4)];
        const box = boxAt(x + dx * (far + half), y + dy * (far + labelHeight / 2));
        if (isClear(box) && shareOf(box, -1) === 1) return {...box, from: spots[0]};
      }
    return null;
  }
  /** @param links [{ends: [[view, part], [view, part]], colour}] @param labels as of `shownLabels()` */
  draw(links, labels) {
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
    const style = getComputedStyle(document.body);
    g.font = '600 12px system-ui, sans-serif';
    g.textAlign = 'center';
    g.textBaseline = 'middle';
    this.placed = [];
    const [paper, ink] = ['--paper', '--ink'].map(name => style.getPropertyValue(name));
    g.lineWidth = 1;
    g.strokeStyle = ink;
    for (const label of labels) {
      const half = g.measureText(label.text).width / 2 + 6, place = this.placeOfLabel(label, half);
      if (!place) continue;
      this.placed.push({...place, text: label.text});
      if (place.from) { // a line to the part
        const {x, y} = place.from;
        g.beginPath();
        g.moveTo(x - box.left, y - box.top);
        g.lineTo(Math.max(place.left, Math.min(place.right, x)) - box.left, Math.max(place.top, Math.min(place.bottom, y)) - box.top);
        g.stroke();
      }
      g.globalAlpha = 0.85;
      g.fillStyle = paper;
      g.fillRect(place.left - box.left, place.top - box.top, 2 * half, labelHeight);
      g.globalAlpha = 1;
      g.fillStyle = ink;
      g.fillText(label.text, place.left + half - box.left, place.top + labelHeight / 2 - box.top);
    }
  }
}

export class MatchView {
  /** @param views of the stage: source, target, and maybe others whose items have `sides`, [source, target] parts */
  constructor(stage, views) {
    this.stage = stage;
    this.views = this.labelled = views;
    this.listeners = []; // called when the slider has hidden or shown pairs
    this.overlay = new Overlay(stage);
    this.hasLinks = this.hasGroups = false;
    this.hasLabels = true;
    this.leastConfidence = 0;
    this.selection = new Selection(key => this.light(key));
    addGestures(stage, (item, x, y) => this.point(item, x, y), (item, x, y) => this.click(item, x, y));
    stage.labels = () => this.shownLabels(); // for tests
    stage.afterDrawing = () => this.overlay.draw(this.shownLinks(), this.shownLabels());
    addEventListener('keydown', event => { if (event.key === 'Escape') this.clear(); });
  }

  /** The switches of the page. */
  addSwitches(parent) {
    addSwitch(parent, 'labels', 'What parts are', true, isSet => { this.hasLabels = isSet; this.stage.redraw(); });
    addSwitch(parent, 'links', 'Lines between corresponding parts', false, isSet => { this.hasLinks = isSet; this.stage.redraw(); });
    if (this.groupsJoinBlocks())
      addSwitch(parent, 'groups', 'Symmetric parts that were matched together have one colour, and are chosen together', false,
                isSet => { this.hasGroups = isSet; this.colour(); this.light(this.selection.key); });
    if (!this.match.blocks.some(block => block.confidence !== null)) return;
    const label = element('label', 'hide pairs below ', parent), slider = element('input', '', label), told = element('output', '0 %', label);
    label.title = 'Hides what corresponds less surely';
    Object.assign(slider, {type: 'range', min: 0, max: 1, step: 0.05, value: 0, ariaLabel: 'least confidence that is shown'});
    slider.oninput = () => {
      this.leastConfidence = Number(slider.value);
      told.textContent = percent(this.leastConfidence);
      $('#show > summary').textContent = this.leastConfidence ? 'Show (filtered)' : 'Show';
      this.colour();
      for (const listener of this.listeners) listener();
    };
  }

  /** Whether symmetric parts that were matched together are in several blocks. */
  groupsJoinBlocks() {
    const blockOfGroup = new Map();
    return this.match.groups.some((numbers, side) => numbers.some((n, part) => {
      const block = this.blockOf[side][part];
      if (n < 0 || block < 0) return false;
      if (!blockOfGroup.has(n)) blockOfGroup.set(n, block);
      return blockOfGroup.get(n) !== block;
    }));
  }

  /**
   * @param match {titles, names, labels, blocks, roles, groups, pieces, colourOf(side, part)}: lists by side; `labels` are the names as
   * people read them; `roles` may hold empty lists; `pieces`, which may be missing, has roles that are one piece with others
   * (`rolesInOnePiece`); colours are in linear light; without `colourOf` a part has the colour of its meshes
   */
  show(match) {
    this.match = match;
    this.blockOf = match.names.map(list => list.map(() => -1));
    match.blocks.forEach((block, b) => block.parts.forEach(
        (parts, side) => parts.forEach(part => { this.blockOf[side][part] = b; })));
    this.own = match.names.map((list, side) => list.map((_, part) => this.ownColour(side, part)));
    this.rows = rowsByRole(match.blocks);
    this.rowOf = match.blocks.map((_, b) => this.rows.findIndex(row => row.blocks.includes(b)));
    this.fillTable();
    this.colour();
    this.selection.clear();
  }

  fillTable() {
    const {match} = this, hasRoles = match.blocks.some(block => block.role), hasConfidence = match.blocks.some(block => block.confidence !== null);
    const columns = [...(hasRoles ? [{text: 'role', kind: 'narrow'}] : []), {text: match.titles.join(' → '), span: 2}, ...(hasConfidence ? [{text: 'how sure', kind: 'narrow'}] : [])];
    const labelsOf = sides => sides.map((parts, side) => parts.map(part => match.labels[side][part]));
    const cells = (role, middle, last) => [...(hasRoles ? [role] : []), ...middle, ...(hasConfidence ? [last] : [])];
    const sure = ({confidence, least}) => ({text: percent(confidence), small: least < confidence && percent(least) !== percent(confidence) ? `least ${percent(least)}` : '',
                                            title: 'The probability that a pair of parts is right: on average, and that of the surest pair of the least sure part'});
    const part = (side, index) => index === undefined ? '' : {text: match.labels[side][index], title: match.names[side][index], key: side + ':' + index};
    const parts = sides => Array.from({length: Math.max(...sides.map(list => list.length))}, (_, i) => (
        {cells: cells('', sides.map((list, side) => part(side, list[i])), ''), words: sides.map((list, side) => list[i] === undefined ? '' : match.names[side][list[i]])}));
    const row = (key, role, sides, block, below) => {
      const labels = labelsOf(sides), title = (block.operation ? operationText({...block, parts: sides}) + ': ' : '') + labels.map(list => withRanges(list).join(', ') || 'nothing').join(' → ');
      const small = block.text ? '' : [0, 1].filter(side => this.withOthers(side, role) !== roleText(role)).map(side => `${match.titles[side]}: ${this.withOthers(side, role)} in one piece`).join('; ');
      return {key, colour: cssColour(grey), cells: cells(roleText(role), [{text: block.text || sentenceOf(labels, role), title, small, span: 2}], sure(block)), rows: below};
    };
    const ofBlock = b => row('b' + b, '', match.blocks[b].parts, match.blocks[b], parts(match.blocks[b].parts));
    const rows = this.rows.map(({role, blocks}, r) => {
      if (blocks.length === 1) return row('b' + blocks[0], match.blocks[blocks[0]].role, match.blocks[blocks[0]].parts, match.blocks[blocks[0]], parts(match.blocks[blocks[0]].parts));
      const all = blocks.map(b => match.blocks[b]), sides = [0, 1].map(side => all.flatMap(block => block.parts[side])), known = all.filter(block => block.confidence !== null);
      const summed = known.length ? {confidence: known.reduce((sum, block) => sum + block.confidence, 0) / known.length, least: Math.min(...known.map(block => block.least))} : {confidence: null};
      return row('r' + r, role, sides, summed, blocks.map(ofBlock));
    });
    match.names.forEach((list, side) => {
      const sides = [[], []];
      sides[side] = list.map((_, index) => index).filter(index => this.blockOf[side][index] < 0);
      if (!sides[side].length) return;
      rows.push(row('none' + side, '', sides, {confidence: null, text: `${sides[side].length === 1 ? labelsOf(sides)[side][0] : countedParts(labelsOf(sides)[side], '')} without counterpart in ${match.titles[1 - side]}`}, parts(sides)));
    });
    this.table = fillTable($('table'), columns, rows, this.selection, $('#search'));
  }

  /** A role in words, together with the roles that are one piece with it in the shape of this side. */
  withOthers(side, role) {
    const piece = ((this.match.pieces || [])[side] || []).find(([one]) => one === role);
    return listed((piece ? [role, ...piece[1]] : [role]).map(roleText));
  }

  ownColour(side, part) {
    if (this.match.colourOf) return this.match.colourOf(side, part);
    const item = this.stage.items.find(i => i.view === this.views[side] && i.part === part);
    return item ? item.mesh.colour : grey;
  }

  isSure(block) { return block.confidence === null || block.confidence >= this.leastConfidence; }

  /** The one colour of all parts of a block, on both sides. */
  colourOfBlock(b) {
    const all = this.match.blocks[b].parts.flatMap((parts, side) => parts.map(part => this.own[side][part].slice(0, 3)));
    return all.find(colour => Math.max(...colour) - Math.min(...colour) > leastChroma) || spare[b % spare.length];
  }

  /** Colours items and rows: parts of a group have the colour of its first part; those without counterpart are grey, hidden ones also faint. */
  colour() {
    const {blocks, groups} = this.match, first = new Map();
    groups.forEach((numbers, side) => numbers.forEach((n, part) => {
      if (n >= 0 && !first.has(n) && this.blockOf[side][part] >= 0) first.set(n, this.colourOfBlock(this.blockOf[side][part]));
    }));
    const isUnsure = block => block.confidence !== null && block.confidence < unsure;
    const isUnsurePart = (block, side, part) => isUnsure(block) || (block.sure?.[side][block.parts[side].indexOf(part)] ?? 1) < unsure;
    const colourOf = (side, part) => {
      const b = this.blockOf[side][part], group = (groups[side] || [])[part];
      if (b < 0) return blocks.length ? grey : this.own[side][part];
      if (!this.isSure(blocks[b])) return grey;
      return this.hasGroups && first.has(group) ? first.get(group) : this.colourOfBlock(b);
    };
    for (const item of this.stage.items) {
      if (item.part < 0 || item.layer === 'materials') continue;
      const place = this.placeOfItem(item), block = blocks[this.blockOf[place[0]][place[1]]];
      item.colour.setRGB(...colourOf(...place).slice(0, 3));
      item.hatch = block && this.isSure(block) && isUnsurePart(block, ...place) ? 1 : 0;
      item.opacity = block && !this.isSure(block) ? hiddenOpacity : 1;
    }
    const colours = new Map(), hatched = new Set(), partly = new Set(), ofBlock = b => cssColour(colourOf(0, blocks[b].parts[0][0]));
    blocks.forEach((block, b) => { colours.set('b' + b, ofBlock(b)); if (block.least !== null && block.least < unsure) (isUnsure(block) ? hatched : partly).add('b' + b); });
    this.rows.forEach((row, r) => {
      colours.set('r' + r, ofBlock(row.blocks[0]));
      if (row.blocks.some(b => blocks[b].least !== null && blocks[b].least < unsure)) (row.blocks.every(b => isUnsure(blocks[b])) ? hatched : partly).add('r' + r);
    });
    [0, 1].forEach(side => colours.set('none' + side, cssColour(grey)));
    this.table.paint(colours, hatched, partly);
    const isHidden = b => !this.isSure(blocks[b]);
    this.table.hide(new Set([...blocks.flatMap((_, b) => isHidden(b) ? ['b' + b] : []), ...this.rows.flatMap((row, r) => row.blocks.every(isHidden) ? ['r' + r] : [])]));
    this.stage.redraw();
  }

  /** The key of the block that a part belongs to, or of all parts of this side without counterpart. */
  keyOf(side, part) {
    const block = this.blockOf[side][part];
    return block >= 0 ? 'b' + block : 'none' + side;
  }

  /** The side and the part that an item shows; for an in-between shape, the part of the source if there is one. */
  placeOfItem(item) {
    if (!item.sides) return [this.views.indexOf(item.view), item.part];
    return item.sides[0] >= 0 ? [0, item.sides[0]] : [1, item.sides[1]];
  }

  /** All keys that light up together with a key; that of a single part, SIDE:PART, lights up alone. */
  keysWith(key) {
    const keys = new Set([key]);
    if (key[0] === 'r') for (const b of this.rows[Number(key.slice(1))].blocks) keys.add('b' + b);
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

  /** The key that lights up when an item is pointed at or chosen: of its block, or of its part if that has no counterpart. */
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
    if (roles[side][part]) lines.push('role: ' + this.withOthers(side, roles[side][part]));
    if (names[side][part] !== labels[side][part]) lines.push('name in the file: ' + names[side][part]);
    if (!block) return [labels[side][part], lines.concat('no counterpart')];
    lines.push(`${inWords(block, side)} (${operationText(block)})`);
    lines.push(`in ${titles[1 - side]}: ` + listed(block.parts[1 - side].map(p => labels[1 - side][p])));
    if (block.confidence !== null) lines.push('confidence: ' + percent(block.confidence) + (block.least < block.confidence ? `, of its least sure part ${percent(block.least)}` : ''));
    return [labels[side][part], lines];
  }

  /** The links to draw, if they are switched on: of the chosen blocks, or of all blocks if nothing is chosen. */
  shownLinks() {
    if (!this.match || !this.hasLinks) return [];
    return this.match.blocks.flatMap((block, b) => (this.lit && !this.lit.has('b' + b)) || !this.isSure(block) ? [] :
        block.parts[0].flatMap(source => block.parts[1].map(target => ({
          ends: [[this.views[0], source], [this.views[1], target]], colour: cssColour(this.own[0][source])}))));
  }

  /**
   * The labels to draw, [{x, y, text, spots, number, shareOf, confine}]: for each row of the table its role, or else a part's label, at
   * the place in the window where it is seen best, with what `Overlay` needs to place it; none for what is small or faded
   */
  shownLabels() {
    if (!this.match || !this.hasLabels) return [];
    const rowOf = item => {
      if (item.part < 0) return -1;
      const [side, part] = this.placeOfItem(item), b = this.blockOf[side][part];
      return b >= 0 && this.isSure(this.match.blocks[b]) && (!this.lit || this.lit.has('b' + b) || this.lit.has(side + ':' + part)) ? this.rowOf[b] : -1;
    };
    const least = this.lit ? leastChosen : leastLabelled;
    return this.labelled.flatMap(view => {
      const confine = this.stage.boxOf(view), side = Math.max(0, this.views.indexOf(view));
      if (view.figure.hidden || Math.min(confine.width, confine.height) < leastView) return [];
      const {places, shareOf} = this.stage.seenPlaces(view, rowOf);
      const text = row => { const {role, blocks: [b]} = this.rows[row]; return role ? this.withOthers(side, role) : this.match.labels[side][this.match.blocks[b].parts[side][0]]; };
      return [...places].filter(([, {area}]) => area >= least * least).sort((a, b) => b[1].area - a[1].area).map(
          ([number, {spots}]) => ({...spots[0], text: text(number), spots, number, shareOf, confine}));
    });
  }
}

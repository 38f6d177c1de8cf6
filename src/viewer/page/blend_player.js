// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

import {$, cssColour, element, setBreakable} from './dom.js';
import {morphed, valuesAt} from './glb.js';
import {counted, percent, roleText} from './matching.js';

// A film in which the source becomes the target and the target the source again, with a slider and a bar for each role.

const secondsOfBlend = 4, secondsOfRest = 0.8; // at either end

export class BlendPlayer {
  /** @param match the MatchView of the page */
  constructor(match, blend, glb) {
    const {stage, views} = match;
    this.stage = stage;
    this.match = match;
    this.view = stage.addView('in between');
    this.view.figure.className = 'between';
    match.labelled = [this.view];
    match.listeners.push(() => this.fade());
    stage.root.classList.add('film');
    [this.begin, this.end] = [glb.animation.extras.begin, glb.animation.extras.end];
    for (const root of glb.scenes[0].nodes)
      for (const node of root.children.length ? root.children : [root])
        for (const item of stage.addNode(this.view, node, 0)) {
          item.sides = node.extras.parts;
          item.tracks = root.animation;
        }
    match.colour();
    this.addControls(blend);
    this.pose(0);
    const size = box => box.getSize(new THREE.Vector3()).length(), source = new THREE.Box3();
    for (const item of stage.items)
      if (item.view === this.view && !item.isHidden) source.expandByObject(item.object);
    stage.centre(this.view, size(views[0].bounds) / (size(source) || 1));
    stage.resize();
    matchMedia('(prefers-reduced-motion: reduce)').matches ? this.pose(0.5) : this.play();
  }

  addControls(blend) {
    const root = $('#player');
    root.hidden = false;
    this.bars = element('div', '', root);
    this.bars.className = 'bars';
    this.button = element('button', 'Play', this.bars);
    this.button.className = 'next';
    this.button.onclick = () => this.isPlaying ? this.stop() : this.play();
    const line = element('div', '', this.bars), ends = element('div', '', line);
    ends.className = 'ends';
    for (const title of this.match.match.titles) setBreakable(title, element('small', '', ends));
    this.slider = element('input', '', line);
    Object.assign(this.slider, {type: 'range', min: 0, max: 1, step: 0.001, value: 0, ariaLabel: 'time of the blend'});
    this.slider.oninput = () => { this.stop(); this.pose(Number(this.slider.value)); };
    this.rows = this.rowsOf(blend);
    for (const row of this.rows) {
      const {text, colour, tasks} = row;
      row.name = element('span', text, this.bars);
      const box = element('span', '', this.bars), bar = element('b', '', box), begin = Math.min(...tasks.map(task => task.begin));
      bar.style.left = 100 * begin + '%';
      bar.style.width = Math.max(0.5, 100 * (Math.max(...tasks.map(task => task.end)) - begin)) + '%';
      bar.style.background = colour;
      row.bar = bar;
      box.title = tasks.map(task => this.told(task)).join('\n');
    }
  }

  /** The tasks of each row of the table, and those of parts without counterpart. */
  rowsOf(blend) {
    const {match: {names, labels}, blockOf, rowOf, rows, own} = this.match, result = new Map();
    for (const task of blend.tasks) {
      const places = [task.source, task.target].map((name, side) => names[side].indexOf(name)), side = places[0] >= 0 ? 0 : 1;
      const block = places[side] >= 0 ? blockOf[side][places[side]] : -1, row = block >= 0 ? rowOf[block] : side === 0 ? 'goes' : 'comes';
      if (!result.has(row)) result.set(row, {tasks: [], blocks: block >= 0 ? rows[row].blocks : [], colour: block >= 0 ? cssColour(own[side][places[side]]) : '#888',
                                             text: block < 0 ? '' : roleText(rows[row].role) || labels[side][places[side]]});
      result.get(row).tasks.push(task);
    }
    for (const [key, row] of result)
      if (!row.text) row.text = `${counted(row.tasks.length, 'part')} ${key === 'goes' ? 'vanish' : 'grow'}${row.tasks.length > 1 ? '' : key === 'goes' ? 'es' : 's'}`;
    return [...result].sort((a, b) => (typeof a[0] === 'string') - (typeof b[0] === 'string') || a[0] - b[0]).map(([, row]) => row);
  }

  /** Draws those rows faint whose pairs are hidden by the slider of confidence. */
  fade() {
    const {match, match: {match: {blocks}}} = this;
    for (const {name, bar, blocks: own} of this.rows) {
      const isFaint = own.length > 0 && !own.some(b => match.isSure(blocks[b]));
      for (const box of [name, bar]) box.classList.toggle('faint', isFaint);
    }
  }

  told(task) {
    const {names, labels} = this.match.match;
    const named = [task.source, task.target].map((name, side) => labels[side][names[side].indexOf(name)] || name).filter(Boolean).join(' → ');
    return `${named} ${task.what}: ${task.reason}`;
  }

  /** Shows the shape at a time from 0, the source, to 1. */
  pose(t) {
    this.time = t;
    this.slider.value = t;
    this.bars.style.setProperty('--t', t);
    const {titles} = this.match.match;
    this.view.caption.textContent = t <= 0 ? titles[0] : t >= 1 ? titles[1] : `in between, ${percent(t)}`;
    const seconds = this.begin + t * (this.end - this.begin);
    for (const item of this.stage.items) {
      if (item.view !== this.view || !item.tracks) continue;
      const {scale, weights} = item.tracks;
      item.isHidden = scale !== null && valuesAt(scale, seconds)[0] === 0;
      if (weights === null || item.isHidden) continue;
      const position = item.object.geometry.attributes.position;
      position.array = morphed(item.mesh, valuesAt(weights, seconds));
      position.needsUpdate = true;
      item.object.geometry.boundingSphere = null;
    }
    this.stage.redraw();
  }

  play() {
    this.isPlaying = true;
    this.button.textContent = 'Pause';
    const period = secondsOfBlend + secondsOfRest;
    let last = performance.now(), clock = this.time >= 1 ? period : this.time * secondsOfBlend + secondsOfRest * (this.time > 0); // from an end, the film rests first
    const step = now => {
      if (!this.isPlaying) return;
      clock = (clock + Math.min(0.1, (now - last) / 1000)) % (2 * period); // a slow browser shows the whole film, slowly
      last = now;
      const t = Math.max(0, Math.min(1, (clock % period - secondsOfRest) / secondsOfBlend)), next = clock < period ? t : 1 - t;
      if (next !== this.time) this.pose(next);
      requestAnimationFrame(step);
    };
    requestAnimationFrame(step);
  }

  stop() {
    this.isPlaying = false;
    this.button.textContent = 'Play';
  }
}

// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

import {$, element} from './dom.js';
import {morphed, valuesAt} from './glb.js';

// A third view between source and target, in which the one becomes the other, with a slider and the tasks as bars.

const secondsOfBlend = 4;

/** The parts of a task. */
function taskName(task) {
  return [task.source, task.target].filter(Boolean).join(' → ');
}

export class BlendPlayer {
  /** @param match the MatchView of the page */
  constructor(match, blend, glb) {
    const {stage, views} = match;
    this.stage = stage;
    this.view = stage.addView('in between');
    views[0].figure.after(this.view.figure);
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
    stage.root.classList.add('three');
    stage.resize();
    this.pose(0.5); // so that the first sight is a shape in between
  }

  addControls(blend) {
    const root = $('#player'), line = element('div', '', root);
    root.hidden = false;
    this.button = element('button', 'play', line);
    this.button.onclick = () => this.isPlaying ? this.stop() : this.play();
    this.slider = element('input', '', line);
    Object.assign(this.slider, {type: 'range', min: 0, max: 1, step: 0.001, value: 0, ariaLabel: 'time of the blend'});
    this.slider.oninput = () => { this.stop(); this.pose(Number(this.slider.value)); };
    const tasks = element('details', '', root), bars = element('div', '', tasks);
    tasks.prepend(element('summary', `${blend.tasks.length} tasks`, tasks));
    bars.className = 'bars';
    for (const task of blend.tasks) {
      const reason = task.task === 'exchange' ? ': none has a counterpart, and they are in the same place'
        : task.obstacle === 'unlike' ? ': too unlike its counterpart'
          : task.obstacle ? `: no map onto its counterpart, as it would be ${task.obstacle}` : '';
      element('span', `${task.task}: ${taskName(task)}`, bars).title = taskName(task) + reason;
      const bar = element('b', '', element('span', '', bars));
      bar.className = task.task;
      bar.style.left = 100 * task.begin + '%';
      bar.style.width = Math.max(0.5, 100 * (task.end - task.begin)) + '%';
    }
    this.bars = bars;
  }

  /** Shows the shape at a time from 0, the source, to 1. */
  pose(t) {
    this.time = t;
    this.slider.value = t;
    this.bars.style.setProperty('--t', t);
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
    this.button.textContent = 'pause';
    let last = performance.now(), t = this.time >= 1 ? 0 : this.time;
    const step = now => {
      if (!this.isPlaying) return;
      t = Math.min(1, t + (now - last) / 1000 / secondsOfBlend);
      last = now;
      this.pose(t);
      t < 1 ? requestAnimationFrame(step) : this.stop();
    };
    requestAnimationFrame(step);
  }

  stop() {
    this.isPlaying = false;
    this.button.textContent = 'play';
  }
}

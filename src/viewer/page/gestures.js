// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

// Mouse, fingers and keys on a stage. Drag and arrows turn; wheel, pinch, + and - zoom; right button, shift or two fingers
// move; a double click and Home go back. Callbacks get what is pointed at and clicked.

const radiansPerPixel = 0.008, zoomPerPixel = 0.001, steepest = 1.55;
const pixelsPerKey = 12, zoomPerKey = 1.1;
const stillPixels = 6; // a pointer that moves less is still: a click, not a drag

function middleOf(points) {
  return [0, 1].map(k => points.reduce((sum, p) => sum + p[k], 0) / points.length);
}

/** @param point (item or null, x, y) is called when the mouse hovers, @param click when it clicks or a finger taps */
export function addGestures(stage, point, click) {
  const root = stage.root, down = new Map();
  let moved = 0, pending = 0;

  function turn(dx, dy) {
    stage.pose.yaw -= dx * radiansPerPixel;
    stage.pose.pitch = Math.max(-steepest, Math.min(steepest, stage.pose.pitch + dy * radiansPerPixel));
  }
  function move(dx, dy) {
    const view = stage.views.find(v => !v.figure.hidden), step = stage.seenHeight / view.figure.clientHeight;
    stage.pose.x += dx * step;
    stage.pose.y -= dy * step;
  }
  function zoom(factor) { stage.pose.zoom = Math.max(0.05, Math.min(5, stage.pose.zoom * factor)); }

  function drag(event) {
    const before = [...down.values()], old = down.get(event.pointerId), now = [event.clientX, event.clientY];
    down.set(event.pointerId, now);
    const [dx, dy] = [now[0] - old[0], now[1] - old[1]];
    moved += Math.hypot(dx, dy);
    if (moved < stillPixels) return;
    if (down.size === 2) {
      const after = [...down.values()], apart = points => Math.hypot(points[0][0] - points[1][0], points[0][1] - points[1][1]);
      if (apart(after) > 0) zoom(apart(before) / apart(after));
      move(...middleOf(after).map((c, k) => c - middleOf(before)[k]));
    } else if (event.buttons === 1 && !event.shiftKey) turn(dx, dy);
    else move(dx, dy);
    point(null);
    stage.redraw();
  }

  root.addEventListener('pointerdown', event => {
    if (event.target.closest('button, input, label, a')) return;
    if (!down.size) moved = 0;
    down.set(event.pointerId, [event.clientX, event.clientY]);
    try { root.setPointerCapture(event.pointerId); } catch (error) { /* a pointer that a script made */ }
  });
  root.addEventListener('pointermove', event => {
    if (down.has(event.pointerId)) return drag(event);
    if (event.pointerType !== 'mouse' || pending) return;
    pending = requestAnimationFrame(() => {
      pending = 0;
      point(stage.itemAt(event.clientX, event.clientY), event.clientX, event.clientY);
    });
  });
  root.addEventListener('pointerup', event => {
    if (!down.delete(event.pointerId)) return;
    if (!down.size && moved < stillPixels && event.button === 0)
      click(stage.itemAt(event.clientX, event.clientY), event.clientX, event.clientY);
  });
  root.addEventListener('pointercancel', event => down.delete(event.pointerId));
  root.addEventListener('pointerleave', event => { // a finger leaves when it is lifted; what it tapped stays
    if (event.pointerType === 'mouse' && !down.size) point(null);
  });
  root.addEventListener('contextmenu', event => event.preventDefault());
  root.addEventListener('keydown', event => {
    const step = {ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, -1], ArrowDown: [0, 1]}[event.key];
    if (step) turn(...step.map(s => s * pixelsPerKey));
    else if (event.key === '+' || event.key === '=') zoom(1 / zoomPerKey);
    else if (event.key === '-') zoom(zoomPerKey);
    else if (event.key === 'Home') stage.goHome();
    else return;
    event.preventDefault();
    stage.redraw();
  });
  root.addEventListener('dblclick', () => stage.goHome());
  root.addEventListener('wheel', event => {
    event.preventDefault();
    zoom(Math.exp(event.deltaY * zoomPerPixel));
    stage.redraw();
  }, {passive: false});
}

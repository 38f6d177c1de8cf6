// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

import {element, setBreakable} from './dom.js';
import {litScene, newRenderer, objectOf, placeCamera, pointsToFit} from './stage.js';

const pixels = 224;

/** Small pictures of shapes by one renderer, each drawn when it first comes into sight; none without WebGL. */
export class Pictures {
  constructor() {
    this.renderer = newRenderer(document.createElement('canvas'));
    this.waiting = new Map();
    if (!this.renderer) return;
    this.renderer.setSize(pixels, pixels, false);
    this.renderer.setClearColor(0xffffff, 0);
    this.sight = new IntersectionObserver(entries => {
      for (const entry of entries) {
        if (!entry.isIntersecting || !this.waiting.has(entry.target)) continue;
        this.draw(this.waiting.get(entry.target), entry.target);
        this.waiting.delete(entry.target);
        this.sight.unobserve(entry.target);
      }
    }, {rootMargin: '200px'});
  }

  /** @param shape node of a GLB whose children are parts */
  add(canvas, shape) {
    if (!this.renderer) return;
    this.waiting.set(canvas, shape);
    this.sight.observe(canvas);
  }

  draw(shape, canvas) {
    const scene = litScene(), group = new THREE.Group(), camera = new THREE.PerspectiveCamera();
    for (const node of shape.children) for (const mesh of node.meshes) group.add(objectOf(mesh));
    scene.add(group);
    const bounds = new THREE.Box3().setFromObject(group);
    group.position.copy(bounds.getCenter(new THREE.Vector3())).negate();
    placeCamera(camera, pointsToFit(group), 1);
    this.renderer.render(scene, camera);
    canvas.width = canvas.height = pixels;
    canvas.getContext('2d').drawImage(this.renderer.domElement, 0, 0);
    for (const object of group.children) { object.geometry.dispose(); object.material.dispose(); }
  }
}

/**
 * A button with a picture for each shape.
 * @param cards [{name, mark (may be empty), shape (a node of a GLB, or null)}] @returns the buttons
 */
export function fillGallery(root, cards, pictures, choose) {
  return cards.map((card, i) => {
    const button = element('button', '', root);
    button.title = card.name;
    button.className = card.mark ? 'marked' : '';
    const canvas = element('canvas', '', button);
    if (card.shape) pictures.add(canvas, card.shape);
    if (card.mark) element('em', card.mark, button);
    setBreakable(card.name, element('span', '', button));
    button.onclick = () => choose(i);
    return button;
  });
}

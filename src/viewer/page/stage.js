// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

import {element, setBreakable} from './dom.js';

// Shapes side by side under one camera, on one canvas. It draws items: {view, part, layer, mesh, colour, ...};
// `part` is the index of the part in its shape, or -1. Without WebGL nothing is drawn, and all else works.

const fieldOfView = 28; // degrees
const focalLength = 1 / Math.tan(fieldOfView * Math.PI / 360); // over half the height of the picture
const home = {yaw: 0.5, pitch: 0.3, zoom: 1, x: 0, y: 0};
const stackedGain = 1.1; // gain in size from which two views are put one below the other
const fadedOpacity = 0.1, overlaidOpacity = 0.3;
const largestRatio = 1.25; // ratio of sizes up to which shapes are drawn to the same scale
const groundPixels = 96, shadowTriangles = 12000; // side of the picture of the ground, soft by its few pixels; limit for triangles that cast a shadow
const hatching = `if (hatch > 0. && mod(gl_FragCoord.x + gl_FragCoord.y, 12.) < 4.) gl_FragColor.rgb = mix(gl_FragColor.rgb, vec3(1.), .6);`;
const fittedPoints = 3000; // limit for the points by which the camera's distance is found
const radiansPerSecond = 0.35; // speed of `turnSlowly()`
const isDark = matchMedia('(prefers-color-scheme: dark)');
const lightOfLines = 0.6; // their grey level in dark mode
const mostSpots = 40; // about as many spots of each thing are returned by `seenPlaces()`
const otherThing = 254; // number in `seenPlaces()` of items that are no thing
const noPoints = {points: [], middle: {x: 0, y: 0}};

function geometryOf(mesh) {
  const geometry = new THREE.BufferGeometry();
  geometry.setAttribute('position', new THREE.BufferAttribute(mesh.points, 3));
  if (mesh.normals) geometry.setAttribute('normal', new THREE.BufferAttribute(mesh.normals, 3));
  if (mesh.coordinates) geometry.setAttribute('uv', new THREE.BufferAttribute(mesh.coordinates, 2));
  if (mesh.colours) geometry.setAttribute('color', new THREE.BufferAttribute(mesh.colours, 3));
  if (mesh.indices) geometry.setIndex(new THREE.BufferAttribute(mesh.indices, 1));
  return geometry;
}

const wrapOf = name => ({clamp: THREE.ClampToEdgeWrapping, mirror: THREE.MirroredRepeatWrapping, repeat: THREE.RepeatWrapping})[name];

/** Puts a texture on a material as soon as its picture is decoded, once for all materials that have it. */
function addTexture(material, texture, onLoad) {
  texture.picture = texture.picture || createImageBitmap(new Blob([texture.bytes], {type: texture.type}));
  texture.picture.then(picture => {
    material.map = new THREE.Texture(picture);
    [material.map.wrapS, material.map.wrapT] = texture.wrap.map(wrapOf);
    material.map.encoding = THREE.sRGBEncoding;
    material.map.flipY = false;
    material.map.needsUpdate = material.needsUpdate = true;
    onLoad();
  }, () => {}); // a damaged picture: the colour alone
}

/** The object that draws a mesh of a GLB. Without normals it is shaded flat. `onLoad` is called when its texture is there. */
export function objectOf(mesh, onLoad = () => {}) {
  const colour = new THREE.Color(...mesh.colour.slice(0, 3)), geometry = geometryOf(mesh);
  if (mesh.isLines) {
    const lines = new THREE.LineSegments(geometry, new THREE.LineBasicMaterial({color: colour, depthTest: false}));
    lines.renderOrder = 1; // over all else
    return lines;
  }
  const material = new THREE.MeshPhongMaterial(
      {color: colour, side: THREE.DoubleSide, flatShading: !mesh.normals, shininess: 8, specular: 0x111111,
       vertexColors: mesh.colours ? THREE.VertexColors : THREE.NoColors});
  material.userData.hatch = {value: 0};
  material.onBeforeCompile = shader => {
    shader.uniforms.hatch = material.userData.hatch;
    shader.fragmentShader = 'uniform float hatch;\n' + shader.fragmentShader.replace('#include <dithering_fragment>', hatching);
  };
  if (mesh.texture && mesh.coordinates) addTexture(material, mesh.texture, onLoad);
  return new THREE.Mesh(geometry, material);
}

/** A scene with its light, which comes from behind the eye. */
export function litScene() {
  const scene = new THREE.Scene(), sun = new THREE.DirectionalLight(0xffffff, 0.55);
  sun.position.set(0.4, 0.7, 1);
  scene.add(new THREE.HemisphereLight(0xffffff, 0x8890a0, 0.62), sun);
  return scene;
}

/** Calls `visit(x, y)` for the cells of the ground that are in a triangle or contain its corners. @param corners [x, y] of each, in cells */
function visitCells(corners, visit) {
  const [a, b, c] = corners, area = (b[0] - a[0]) * (c[1] - a[1]) - (c[0] - a[0]) * (b[1] - a[1]);
  const range = k => [Math.max(0, Math.floor(Math.min(a[k], b[k], c[k]))), Math.min(groundPixels - 1, Math.floor(Math.max(a[k], b[k], c[k])))];
  const [left, right] = range(0), [top, bottom] = range(1), cross = (p, q, x, y) => ((q[0] - p[0]) * (y - p[1]) - (x - p[0]) * (q[1] - p[1])) * Math.sign(area);
  for (const [x, y] of corners) visit(Math.floor(x), Math.floor(y));
  for (let y = top; y <= bottom; ++y)
    for (let x = left; x <= right; ++x)
      if (cross(a, b, x + 0.5, y + 0.5) >= 0 && cross(b, c, x + 0.5, y + 0.5) >= 0 && cross(c, a, x + 0.5, y + 0.5) >= 0) visit(x, y);
}

/** Paints the ground under a group with its soft shadow, darker below parts near the ground. @param {min, max} bounds of the group @param width of the ground */
function paintGround(canvas, group, {min, max}, width) {
  const g = canvas.getContext('2d'), n = groundPixels, scale = n / width, meshes = [], p = new THREE.Vector3();
  let shadow = new Float32Array(n * n);
  group.traverse(object => { if (object.isMesh && object.geometry.index && !object.userData.item.isHidden) meshes.push(object); });
  const step = Math.max(1, Math.ceil(meshes.reduce((sum, mesh) => sum + mesh.geometry.index.count / 3, 0) / shadowTriangles));
  for (const {geometry: {index, attributes}, matrixWorld} of meshes)
    for (let t = 0; t + 2 < index.count; t += 3 * step) {
      let low = 1;
      const corners = [0, 1, 2].map(k => {
        p.fromBufferAttribute(attributes.position, index.getX(t + k)).applyMatrix4(matrixWorld);
        low = Math.min(low, (p.y - min.y) / (max.y - min.y || 1));
        return [n / 2 + scale * (p.x - (min.x + max.x) / 2), n / 2 + scale * (p.z - (min.z + max.z) / 2)];
      });
      const dark = 0.1 + 0.4 * Math.pow(1 - low, 4);
      visitCells(corners, (x, y) => { if (x >= 0 && y >= 0 && x < n && y < n) shadow[y * n + x] = Math.max(shadow[y * n + x], dark); });
    }
  for (let pass = 0; pass < 4; ++pass) { // means of five cells, along x and y in turn
    const stride = pass % 2 ? n : 1, before = shadow;
    shadow = before.map((_, i) => [-2, -1, 0, 1, 2].reduce((sum, k) => sum + (before[i + k * stride] || 0), 0) / 5);
  }
  canvas.width = canvas.height = n;
  const image = g.createImageData(n, n);
  for (let i = 0; i < n * n; ++i) {
    const far = Math.min(1, 2 * Math.hypot(i % n / n - 0.5, Math.floor(i / n) / n - 0.5)), ground = 0.1 * (1 - far * far);
    const alpha = shadow[i] + ground * (1 - shadow[i]), grey = alpha ? 128 * ground * (1 - shadow[i]) / alpha : 0;
    image.data.set([grey, grey, grey, 255 * alpha], 4 * i);
  }
  g.putImageData(image, 0, 0);
}

const numberMaterials = new Map();

/** The material that draws a number as a colour, for `seenPlaces()`. */
function numberMaterial(number) {
  if (!numberMaterials.has(number))
    numberMaterials.set(number, new THREE.MeshBasicMaterial({color: new THREE.Color((number + 1) / 255, 0, 0), side: THREE.DoubleSide}));
  return numberMaterials.get(number);
}

/** A renderer, or null without WebGL. */
export function newRenderer(canvas) {
  if (!document.createElement('canvas').getContext('webgl')) return null;
  const renderer = new THREE.WebGLRenderer({canvas, antialias: true, alpha: true});
  renderer.gammaOutput = true;
  renderer.gammaFactor = 2.2;
  return renderer;
}

/** The rotation from the directions of the scene to those of the camera. */
function turnTo(pose) {
  return new THREE.Matrix4().makeRotationX(pose.pitch).multiply(new THREE.Matrix4().makeRotationY(-pose.yaw));
}

/** Points of a group in the directions that the camera has at first, relative to the middle of their bounding box; and this middle. */
export function pointsToFit(group) {
  const meshes = [], result = [];
  group.updateMatrixWorld(true);
  group.traverse(object => { if (object.geometry) meshes.push(object); });
  const count = mesh => mesh.geometry.attributes.position.count, turn = turnTo(home);
  const step = Math.max(1, Math.ceil(meshes.reduce((sum, mesh) => sum + count(mesh), 0) / fittedPoints));
  for (const mesh of meshes)
    for (let i = 0; i < count(mesh); i += step)
      result.push(new THREE.Vector3().fromBufferAttribute(mesh.geometry.attributes.position, i)
                      .applyMatrix4(mesh.matrixWorld).applyMatrix4(turn));
  const middle = new THREE.Box3().setFromPoints(result).getCenter(new THREE.Vector3()).setZ(0);
  return {points: result.map(p => p.sub(middle)), middle};
}

/** The distance of the camera from which all points are in view. */
function distanceTo(points, aspect) {
  let fit = 1e-6;
  for (const p of points) fit = Math.max(fit, p.z + focalLength * Math.max(Math.abs(p.x) / aspect, Math.abs(p.y)));
  return 1.06 * fit; // a margin
}

/** Puts a camera so that it sees all points around `middle` (`pointsToFit`) when they are turned as at first. */
export function placeCamera(camera, {points, middle}, aspect, pose = home) {
  const distance = distanceTo(points, aspect) * pose.zoom;
  const size = Math.max(1e-6, ...points.map(p => p.length()));
  camera.fov = fieldOfView;
  camera.aspect = aspect;
  camera.near = Math.max(distance - 2 * size, 0.01 * distance);
  camera.far = distance + 2 * size;
  const back = new THREE.Matrix4().getInverse(turnTo(pose));
  camera.quaternion.setFromRotationMatrix(back);
  camera.position.set(middle.x - pose.x, middle.y - pose.y, distance).applyMatrix4(back);
  camera.updateProjectionMatrix();
  camera.updateMatrixWorld();
  return 2 * distance / focalLength; // the height that the camera sees
}

export class Stage {
  /** @param root of the views; the canvas covers it */
  constructor(root) {
    this.root = root;
    root.stage = this; // for scripts in the console, and for tests
    this.canvas = document.createElement('canvas');
    root.prepend(this.canvas);
    this.renderer = newRenderer(this.canvas);
    if (this.renderer) {
      this.renderer.autoClear = false;
      this.renderer.setPixelRatio(Math.min(devicePixelRatio, 2));
    } else element('p', 'The shapes are drawn by WebGL, which this browser does not offer.', root).className = 'missing';
    this.views = [];
    this.items = [];
    this.layers = new Set();
    this.pose = {...home};
    this.seenHeight = 1;
    this.isLit = null; // function of an item; null: nothing is lit, so nothing fades
    this.afterDrawing = () => {};
    new ResizeObserver(() => { this.resize(); this.draw(); }).observe(root);
    isDark.addEventListener('change', () => this.redraw());
  }

  /** Adds a view with a caption. */
  addView(caption) {
    const box = document.createElement('figure'), text = document.createElement('figcaption');
    setBreakable(caption, text);
    box.append(text);
    this.root.append(box);
    const shape = new THREE.Group(), scene = litScene();
    const picture = document.createElement('canvas');
    const ground = new THREE.Mesh(new THREE.PlaneBufferGeometry(1, 1), new THREE.MeshBasicMaterial(
        {map: new THREE.CanvasTexture(picture), transparent: true, depthWrite: false}));
    ground.rotation.x = -Math.PI / 2;
    ground.renderOrder = -1;
    ground.visible = false;
    scene.add(shape, ground);
    const view = {ground, index: this.views.length, figure: box, caption: text, scene, shape, bounds: new THREE.Box3(), toFit: noPoints,
                  camera: new THREE.PerspectiveCamera()};
    this.views.push(view);
    return view;
  }

  /** Adds the meshes of a node of a GLB to a view. */
  addNode(view, node, part, moved = [0, 0, 0]) {
    return node.meshes.map(mesh => {
      const object = objectOf(mesh, () => this.redraw()), layer = mesh.extras.layer || node.extras.layer || 'surfaces';
      object.position.set(...moved);
      view.shape.add(object);
      const item = {view, part, layer, object, mesh, node, colour: object.material.color.clone()};
      object.userData.item = item;
      this.items.push(item);
      return item;
    });
  }

  /** Removes all items of a view. */
  clear(view) {
    for (const object of [...view.shape.children]) {
      object.geometry.dispose();
      object.material.dispose();
      view.shape.remove(object);
    }
    this.items = this.items.filter(item => item.view !== view);
    view.toFit = noPoints;
    view.ground.visible = false;
    view.shape.position.set(0, 0, 0);
    view.shape.scale.set(1, 1, 1);
  }

  /** Scales the shape of a view and moves its middle to the origin. */
  centre(view, scale = 1) {
    view.shape.position.set(0, 0, 0);
    view.shape.scale.setScalar(scale);
    view.shape.updateMatrixWorld(true);
    view.bounds.setFromObject(view.shape);
    view.shape.position.copy(view.bounds.getCenter(new THREE.Vector3())).negate();
    view.shape.updateMatrixWorld(true);
    view.bounds.setFromObject(view.shape);
    view.toFit = pointsToFit(view.shape);
    this.layGround(view);
    this.resize();
  }

  /** Puts ground with a soft shadow below the shape of a view. */
  layGround(view) {
    const {min, max} = view.bounds, width = 1.7 * Math.max(max.x - min.x, max.z - min.z);
    view.ground.visible = width > 0 && isFinite(width);
    if (!view.ground.visible) return;
    paintGround(view.ground.material.map.image, view.shape, view.bounds, width);
    view.ground.material.map.needsUpdate = true;
    view.ground.scale.set(width, width, 1);
    view.ground.position.set((min.x + max.x) / 2, min.y - 0.001 * width, (min.z + max.z) / 2);
  }

  /** Draws shapes of clearly different sizes equally large, and says so. */
  equalise(views) {
    const size = view => view.bounds.getSize(new THREE.Vector3()).length(), largest = Math.max(...views.map(size));
    for (const view of views) {
      const ratio = largest / (size(view) || largest);
      if (ratio <= largestRatio) continue;
      this.centre(view, ratio);
      element('small', ` (drawn ${Number(ratio.toPrecision(2))} times larger)`, view.caption);
    }
  }

  /** Turns the shapes until somebody touches them. */
  turnSlowly() {
    if (matchMedia('(prefers-reduced-motion: reduce)').matches) return;
    let isTurning = true, last = performance.now();
    for (const kind of ['pointerdown', 'wheel', 'keydown']) this.root.addEventListener(kind, () => { isTurning = false; }, {once: true, passive: true});
    const step = now => {
      if (!isTurning) return;
      this.pose.yaw += Math.min(0.1, (now - last) / 1000) * radiansPerSecond;
      last = now;
      this.redraw();
      requestAnimationFrame(step);
    };
    requestAnimationFrame(step);
  }

  setLayer(layer, isShown) {
    isShown ? this.layers.add(layer) : this.layers.delete(layer);
    this.redraw();
  }

  /** Lights the items that a function picks, and fades the rest; null: neither. */
  light(isLit) {
    this.isLit = isLit;
    this.redraw();
  }

  goHome() {
    Object.assign(this.pose, home);
    this.redraw();
  }

  redraw() {
    if (!this.frame) this.frame = requestAnimationFrame(() => { this.frame = 0; this.draw(); });
  }

  resize() {
    if (!this.renderer) return;
    const {clientWidth: width, clientHeight: height} = this.root, points = this.views.flatMap(view => view.toFit.points);
    if (this.views.length === 2) // beside each other, unless they are much larger one below the other
      this.root.classList.toggle('stacked', 2 * stackedGain * distanceTo(points, 2 * width / height) <
                                            distanceTo(points, width / height / 2));
    const size = this.renderer.getSize(new THREE.Vector2());
    if (size.x !== width || size.y !== height) this.renderer.setSize(width, height, false);
    this.redraw();
  }

  dress(item) {
    const material = item.object.material;
    const isCovered = item.layer === 'surfaces' && this.layers.has('materials') && item.hasMaterials;
    item.object.visible = this.layers.has(item.layer) && !item.isHidden && !isCovered;
    const isOverlaid = ['surfaces', 'materials'].includes(item.layer) && this.layers.has('curves and sheets');
    const isFaded = this.isLit !== null && !this.isLit(item);
    const opacity = (isOverlaid ? overlaidOpacity : 1) * (isFaded ? fadedOpacity : 1) * (item.opacity || 1);
    item.mesh.isLines && isDark.matches ? material.color.setScalar(lightOfLines) : material.color.copy(item.colour);
    material.transparent = opacity < 1;
    material.depthWrite = opacity === 1;
    material.opacity = opacity;
    if (material.userData.hatch) material.userData.hatch.value = item.hatch || 0;
    if (material.emissive) material.emissive.copy(item.colour).multiplyScalar(this.isLit && !isFaded ? 0.25 : 0);
  }

  draw() {
    const whole = this.canvas.getBoundingClientRect();
    if (!this.renderer || !whole.width || !whole.height) return;
    for (const item of this.items) this.dress(item);
    this.renderer.setScissorTest(false);
    this.renderer.setClearColor(0xffffff, 0);
    this.renderer.clear();
    this.renderer.setScissorTest(true);
    const shown = this.views.filter(view => !view.figure.hidden), points = shown.flatMap(view => view.toFit.points);
    for (const view of shown) {
      const box = this.boxOf(view);
      if (box.width <= 0 || box.height <= 0) continue;
      const corner = [box.left - whole.left, whole.bottom - box.top - box.height, box.width, box.height];
      this.seenHeight = placeCamera(view.camera, {points, middle: view.toFit.middle}, box.width / box.height, this.pose);
      this.renderer.setViewport(...corner);
      this.renderer.setScissor(...corner);
      this.renderer.render(view.scene, view.camera);
    }
    this.afterDrawing();
  }

  /** Where in the window a view is drawn: above its caption. */
  boxOf(view) {
    const {left, top, width, height} = view.figure.getBoundingClientRect();
    return {left, top, width, height: height - view.caption.offsetHeight - 4};
  }

  viewAt(x, y) {
    return this.views.find(view => {
      const box = view.figure.getBoundingClientRect();
      return !view.figure.hidden && x >= box.left && x < box.right && y >= box.top && y < box.bottom;
    });
  }

  /** The item at a place of the window, the nearest one to the eye; or null. */
  itemAt(x, y) {
    const view = this.viewAt(x, y);
    if (!view) return null;
    const box = this.boxOf(view), ray = new THREE.Raycaster();
    ray.setFromCamera({x: 2 * (x - box.left) / box.width - 1, y: 1 - 2 * (y - box.top) / box.height}, view.camera);
    const objects = view.shape.children.filter(o => o.visible && o.userData.item.part >= 0);
    const [hit] = ray.intersectObjects(objects);
    return hit ? hit.object.userData.item : null;
  }

  /**
   * Where things, such as rows of the table, are seen in a view.
   * @param numberOf function: the number of an item's thing, from 0 to 253, or -1
   * @returns {places, shareOf}: `places` has, by number, {spots: [{x, y}], area}: points of the window where the thing is seen, the first
   * one well inside, and its area in pixels; `shareOf(box, number)` is the share of a box {left, right, top, bottom} of the window that
   * shows the thing; -1: the background
   */
  seenPlaces(view, numberOf) {
    const box = this.boxOf(view), places = new Map();
    if (!this.renderer || box.width <= 0 || box.height <= 0) return {places, shareOf: () => 0};
    const width = 160, height = Math.max(1, Math.round(width * box.height / box.width)), scale = box.width / width;
    view.numbers = view.numbers || new THREE.WebGLRenderTarget(width, height);
    view.numbers.setSize(width, height);
    const seen = this.items.filter(item => item.view === view && item.object.visible), lines = seen.filter(item => !item.object.isMesh);
    const items = seen.filter(item => item.object.isMesh), saved = items.map(item => item.object.material), numbers = items.map(numberOf);
    items.forEach((item, i) => { item.object.material = numberMaterial(numbers[i] < 0 ? otherThing : numbers[i]); });
    for (const item of lines) item.object.visible = false;
    view.ground.material.visible = false;
    this.renderer.gammaOutput = false; // numbers, no light
    this.renderer.setRenderTarget(view.numbers);
    this.renderer.setClearColor(0, 0);
    this.renderer.clear();
    this.renderer.render(view.scene, view.camera);
    const pixels = new Uint8Array(4 * width * height);
    this.renderer.readRenderTargetPixels(view.numbers, 0, 0, width, height, pixels);
    this.renderer.setRenderTarget(null);
    this.renderer.gammaOutput = true;
    view.ground.material.visible = true;
    items.forEach((item, i) => { item.object.material = saved[i]; });
    for (const item of lines) item.object.visible = true;
    const cells = new Map(), at = i => pixels[4 * i] - 1;
    for (let i = width + 1; i < width * (height - 1) - 1; ++i) {
      const number = at(i);
      if (number >= 0 && number < otherThing) cells.has(number) ? cells.get(number).push(i) : cells.set(number, [i]);
    }
    for (const [number, list] of cells) { // the pixels deepest inside, and of these the one nearest to the middle
      const isInside = i => [-width, -1, 1, width].every(step => at(i + step) === number);
      let inner = list;
      for (let inside = inner.filter(isInside), kept; inside.length; inside = inner.filter(i => kept.has(i - width) && kept.has(i + width) && kept.has(i - 1) && kept.has(i + 1))) {
        inner = inside;
        kept = new Set(inner);
      }
      const [mx, my] = [i => i % width, i => Math.floor(i / width)].map(of => list.reduce((sum, i) => sum + of(i), 0) / list.length);
      const far = i => Math.hypot(i % width - mx, Math.floor(i / width) - my), best = inner.reduce((a, b) => far(b) < far(a) ? b : a);
      const step = Math.ceil(list.length / mostSpots), spots = [best, ...list.filter((_, k) => k % step === 0)].map(
          i => ({x: box.left + (i % width + 0.5) * scale, y: box.top + box.height - (Math.floor(i / width) + 0.5) * scale}));
      places.set(number, {spots, area: list.length * scale * scale});
    }
    const shareOf = ({left, right, top, bottom}, number) => {
      let all = 0, those = 0;
      for (let y = Math.floor((box.top + box.height - bottom) / scale); y <= (box.top + box.height - top) / scale; ++y)
        for (let x = Math.floor((left - box.left) / scale); x <= (right - box.left) / scale; ++x) {
          ++all;
          those += Number(x >= 0 && y >= 0 && x < width && y < height && at(y * width + x) === number);
        }
      return those / all;
    };
    return {places, shareOf};
  }

  /** Where the middle of a part is in the window. */
  placeOf(view, part) {
    const bounds = new THREE.Box3();
    for (const item of this.items)
      if (item.view === view && item.part === part && item.object.visible) bounds.expandByObject(item.object);
    if (bounds.isEmpty()) return null;
    const p = bounds.getCenter(new THREE.Vector3()).project(view.camera), box = this.boxOf(view);
    return [box.left + (p.x + 1) / 2 * box.width, box.top + (1 - p.y) / 2 * box.height];
  }
}

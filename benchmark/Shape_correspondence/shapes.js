// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later
// Scenes of three.js for the pictures of the manual: a shape on a ground with a soft shadow.
'use strict';

const SMOOTH = Math.cos(40 * Math.PI / 180); // neighbours that are turned by less have common normals

/** @returns a renderer of width x height pixels */
function makeRenderer(width, height) {
  const renderer = new THREE.WebGLRenderer({antialias: true});
  renderer.setSize(width, height);
  renderer.shadowMap.enabled = true;
  renderer.shadowMap.type = THREE.PCFSoftShadowMap;
  renderer.gammaOutput = true; // revision 111
  renderer.gammaFactor = 2.2;
  renderer.setClearColor(0xffffff);
  return renderer;
}

/** @param flat nine coordinates for each triangle */
function geometryOf(flat) {
  const facets = [], at = new Map(), normals = new Float32Array(flat.length);
  const key = i => flat[i] + ',' + flat[i + 1] + ',' + flat[i + 2];
  for (let i = 0; i < flat.length; i += 9) {
    const [a, b, c] = [0, 3, 6].map(k => new THREE.Vector3(flat[i + k], flat[i + k + 1], flat[i + k + 2]));
    const normal = b.sub(a).cross(c.sub(a));
    facets.push([normal, normal.clone().normalize()]);
    for (const k of [0, 3, 6]) at.has(key(i + k)) ? at.get(key(i + k)).push(i / 9) : at.set(key(i + k), [i / 9]);
  }
  for (let i = 0; i < flat.length; i += 3) {
    const own = facets[Math.floor(i / 9)][1], sum = new THREE.Vector3();
    for (const f of at.get(key(i))) if (own.dot(facets[f][1]) > SMOOTH) sum.add(facets[f][0]);
    sum.normalize().toArray(normals, i);
  }
  const geometry = new THREE.BufferGeometry();
  geometry.setAttribute('position', new THREE.BufferAttribute(new Float32Array(flat), 3));
  geometry.setAttribute('normal', new THREE.BufferAttribute(normals, 3));
  return geometry;
}

/** @param parts {colour, triangles}, of a shape about 1 high that stands at y = 0 */
function sceneOf(parts) {
  const scene = new THREE.Scene();
  for (const part of parts) {
    const color = new THREE.Color(part.colour).convertSRGBToLinear();
    const mesh = new THREE.Mesh(geometryOf(part.triangles), new THREE.MeshStandardMaterial({color, roughness: 0.7, side: THREE.DoubleSide}));
    mesh.castShadow = mesh.receiveShadow = true;
    scene.add(mesh);
  }
  const ground = new THREE.Mesh(new THREE.PlaneBufferGeometry(9, 9), new THREE.ShadowMaterial({opacity: 0.25}));
  ground.rotation.x = -Math.PI / 2;
  ground.position.y = -0.002;
  ground.receiveShadow = true;
  const sun = new THREE.DirectionalLight(0xffffff, 1.5);
  sun.position.set(0.9, 2.6, 1.9);
  sun.castShadow = true;
  sun.shadow.mapSize.set(1024, 1024);
  sun.shadow.radius = 3;
  sun.shadow.bias = -0.001;
  Object.assign(sun.shadow.camera, {left: -1.2, right: 1.2, top: 1.4, bottom: -1.2});
  scene.add(ground, sun, new THREE.HemisphereLight(0xffffff, 0x999999, 1.1));
  return scene;
}

/** An orthographic camera that sees all of a shape, at the bottom of a picture of these proportions. */
function fittedCamera(parts, proportions, turn, tilt, margin) {
  const camera = new THREE.OrthographicCamera(-1, 1, 1, -1, 0.1, 20);
  camera.position.set(5 * Math.sin(turn) * Math.cos(tilt), 5 * Math.sin(tilt), 5 * Math.cos(turn) * Math.cos(tilt));
  camera.lookAt(0, 0, 0);
  camera.updateMatrixWorld();
  const seen = new THREE.Box3(), p = new THREE.Vector3();
  for (const {triangles} of parts)
    for (let i = 0; i < triangles.length; i += 3) seen.expandByPoint(p.fromArray(triangles, i).applyMatrix4(camera.matrixWorldInverse));
  const size = seen.getSize(new THREE.Vector3());
  const height = Math.max(size.y, size.x / proportions) * (1 + margin), middle = (seen.min.x + seen.max.x) / 2;
  camera.left = middle - height * proportions / 2;
  camera.right = middle + height * proportions / 2;
  camera.bottom = seen.min.y - height * margin / 2;
  camera.top = camera.bottom + height;
  camera.updateProjectionMatrix();
  return camera;
}

/** Draws cells {column, row, parts} of a grid. @returns a data URL */
function drawGrid(cells, columns, rows, width, height, turn, tilt) {
  const canvas = document.createElement('canvas'), renderer = makeRenderer(width, height);
  [canvas.width, canvas.height] = [columns * width, rows * height];
  const pen = canvas.getContext('2d', {alpha: false});
  pen.fillStyle = '#fff';
  pen.fillRect(0, 0, canvas.width, canvas.height);
  for (const {column, row, parts} of cells) {
    const scene = sceneOf(parts);
    renderer.render(scene, fittedCamera(parts, width / height, turn, tilt, 0.06));
    pen.drawImage(renderer.domElement, column * width, row * height);
    scene.traverse(thing => thing.geometry && thing.geometry.dispose());
  }
  return canvas.toDataURL('image/webp', 0.9);
}

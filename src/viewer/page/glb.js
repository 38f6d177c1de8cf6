// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

// Reads binary glTF 2.0 as far as the package writes it: triangles and lines, colours, textures, morph targets,
// animations.

/** The bytes of a text in base64. */
export function bytesOfBase64(text) {
  return Uint8Array.from(atob(text), c => c.charCodeAt(0));
}

const numberOfComponents = {SCALAR: 1, VEC2: 2, VEC3: 3, VEC4: 4};
const arrayOfType = {5121: Uint8Array, 5123: Uint16Array, 5125: Uint32Array, 5126: Float32Array};
const white = [1, 1, 1, 1];
const lines = 1; // mode of a primitive
const wrapOfNumber = {33071: 'clamp', 33648: 'mirror', 10497: 'repeat'};

function chunks(bytes) {
  const view = new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength);
  if (view.getUint32(0, true) !== 0x46546C67) throw new Error('This is no binary glTF.');
  const result = {};
  for (let at = 12; at < bytes.length;) {
    const size = view.getUint32(at, true), type = view.getUint32(at + 4, true);
    result[type] = bytes.slice(at + 8, at + 8 + size); // a copy, so that its numbers are aligned
    at += 8 + size;
  }
  return {json: JSON.parse(new TextDecoder().decode(result[0x4E4F534A])), binary: result[0x004E4942]};
}

/**
 * The scenes of a file: [{name, nodes: [node]}]. A node is {name, extras, translation, children, meshes, animation}; its
 * extras are those of its parent if it has none. A mesh is {extras, colour: [r, g, b, a] in linear light, points,
 * normals (may be null), indices, isLines, targets, coordinates, colours, texture}, the last three null where there are
 * none; a texture {bytes, type, wrap: [u, v]}; `animation` is null or {weights, scale}, each null or {times, values, isStep}. `animation` of the result: {extras,
 * seconds}.
 */
export function readGlb(bytes) {
  const {json, binary} = chunks(bytes);
  const numbers = index => {
    const accessor = json.accessors[index], view = json.bufferViews[accessor.bufferView];
    return new arrayOfType[accessor.componentType](binary.buffer, view.byteOffset + (accessor.byteOffset || 0),
                                                   accessor.count * numberOfComponents[accessor.type]);
  };
  const animations = (json.animations || [])[0];
  const tracks = (json.nodes || []).map(() => null);
  for (const channel of animations ? animations.channels : []) {
    const sampler = animations.samplers[channel.sampler];
    const track = {times: numbers(sampler.input), values: numbers(sampler.output),
                   isStep: sampler.interpolation === 'STEP'};
    const node = channel.target.node;
    tracks[node] = tracks[node] || {weights: null, scale: null};
    tracks[node][channel.target.path] = track;
  }
  const textures = (json.textures || []).map(({source, sampler}) => {
    const image = json.images[source], view = json.bufferViews[image.bufferView], wrap = json.samplers[sampler];
    return {bytes: binary.subarray(view.byteOffset, view.byteOffset + view.byteLength), type: image.mimeType,
            wrap: [wrap.wrapS, wrap.wrapT].map(number => wrapOfNumber[number])};
  });
  const textureOf = material => {
    const texture = json.materials[material].pbrMetallicRoughness.baseColorTexture;
    return texture ? textures[texture.index] : null;
  };
  const attribute = (primitive, name) =>
      primitive.attributes[name] === undefined ? null : numbers(primitive.attributes[name]);
  const mesh = primitive => ({
    extras: primitive.extras || {},
    colour: json.materials[primitive.material].pbrMetallicRoughness.baseColorFactor || white,
    points: numbers(primitive.attributes.POSITION),
    normals: attribute(primitive, 'NORMAL'),
    coordinates: attribute(primitive, 'TEXCOORD_0'),
    colours: attribute(primitive, 'COLOR_0'),
    texture: textureOf(primitive.material),
    indices: primitive.indices === undefined ? null : numbers(primitive.indices),
    isLines: primitive.mode === lines,
    targets: (primitive.targets || []).map(target => numbers(target.POSITION)),
  });
  const node = (index, inherited) => {
    const n = json.nodes[index], extras = n.extras || inherited;
    return {name: n.name || '', extras, translation: n.translation || [0, 0, 0],
            children: (n.children || []).map(child => node(child, extras)),
            meshes: n.mesh === undefined ? [] : json.meshes[n.mesh].primitives.map(mesh), animation: tracks[index]};
  };
  const seconds = tracks.reduce((most, t) => Math.max(most, ...[t && t.weights, t && t.scale].map(
      track => track ? track.times[track.times.length - 1] : 0)), 0);
  return {scenes: json.scenes.map(scene => ({name: scene.name || '', nodes: scene.nodes.map(root => node(root, {}))})),
          animation: {extras: (animations && animations.extras) || {}, seconds}};
}

/** The values of a track at a time: between keys linear, or, if it goes in steps, those of the last key. */
export function valuesAt(track, time) {
  const {times, values} = track, width = values.length / times.length;
  let key = 0;
  while (key + 1 < times.length && times[key + 1] <= time) ++key;
  const at = k => values.subarray(k * width, (k + 1) * width);
  if (track.isStep || key + 1 === times.length || time <= times[0]) return at(key);
  const share = (time - times[key]) / (times[key + 1] - times[key]);
  return at(key).map((v, i) => v + share * (at(key + 1)[i] - v));
}

/** The points of a mesh with morph targets, which are differences to the points at rest. */
export function morphed(mesh, weights) {
  const result = mesh.points.slice();
  weights.forEach((weight, target) => {
    if (weight === 0) return;
    const difference = mesh.targets[target];
    for (let i = 0; i < result.length; ++i) result[i] += weight * difference[i];
  });
  return result;
}

#!/usr/bin/env python3
# Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
# SPDX-License-Identifier: GPL-3.0-or-later
"""Makes the moving picture of README.md: two chairs with the roles of their parts, and the one turning into the other.

  readme_animation.py PROGRAM DATA OUT.webp [--browser chromium] [--three three.min.js]

A browser without a window draws the frames with three.js; this script makes them one animated WebP.
"""
import argparse
import base64
import json
import os
import re
import struct
import subprocess
import tempfile

from picture import BROWSER_FLAGS, read_model

PAIR = "chair_four_legged", "chair_swivel"
COLOURS = {"back": "#2f91f2", "seat": "#b7cb30", "seat_frame": "#f8a96e", "leg": "#dc5b90"}  # further roles get OTHER
OTHER, UNMATCHED = "#734f9a", "#b4b4b8"
STEPS = 24  # from one chair to the other
WIDTH, HEIGHT = 1000, 380
STILL, MOVING = 1200, 80  # milliseconds of a frame
QUALITY = 0.8

PAGE = """<!DOCTYPE html><meta charset="utf-8"><body><script src="file://%(three)s"></script><script src="shapes.js"></script><script>
const [width, height, scale] = [%(width)d, %(height)d, 2];
const renderer = new THREE.WebGLRenderer({antialias: true});
renderer.setSize(width * scale, height * scale);
renderer.shadowMap.enabled = true;
renderer.shadowMap.type = THREE.PCFSoftShadowMap;
renderer.outputEncoding = THREE.sRGBEncoding;
renderer.setClearColor(0xffffff);
renderer.setScissorTest(true);

// Normals of corners: means over the triangles at a point that are turned by less than 40 degrees
function geometry(flat) {
  const result = new THREE.BufferGeometry(), normals = new Float32Array(flat.length), at = new Map();
  const facets = [];
  for (let i = 0; i < flat.length; i += 9) {
    const [a, b, c] = [0, 3, 6].map(k => new THREE.Vector3(flat[i + k], flat[i + k + 1], flat[i + k + 2]));
    const n = b.sub(a).cross(c.sub(a));
    facets.push([n, n.clone().normalize()]);
    for (const k of [0, 3, 6]) {
      const key = flat.slice(i + k, i + k + 3).join();
      at.has(key) ? at.get(key).push(i / 9) : at.set(key, [i / 9]);
    }
  }
  for (let i = 0; i < flat.length; i += 3) {
    const own = facets[Math.floor(i / 9)][1], sum = new THREE.Vector3();
    for (const f of at.get(flat.slice(i, i + 3).join())) if (own.dot(facets[f][1]) > 0.766) sum.add(facets[f][0]);
    sum.normalize().toArray(normals, i);
  }
  result.setAttribute('position', new THREE.BufferAttribute(new Float32Array(flat), 3));
  result.setAttribute('normal', new THREE.BufferAttribute(normals, 3));
  return result;
}

function scene_of(parts) {
  const scene = new THREE.Scene();
  for (const part of parts) {
    const colour = new THREE.Color(part.colour).convertSRGBToLinear();
    const mesh = new THREE.Mesh(geometry(part.triangles), new THREE.MeshStandardMaterial({color: colour, roughness: 0.7, side: THREE.DoubleSide}));
    mesh.castShadow = mesh.receiveShadow = true;
    scene.add(mesh);
  }
  const ground = new THREE.Mesh(new THREE.PlaneBufferGeometry(9, 9), new THREE.ShadowMaterial({opacity: 0.18}));
  ground.rotation.x = -Math.PI / 2;
  ground.position.y = -0.002;
  ground.receiveShadow = true;
  const sun = new THREE.DirectionalLight(0xffffff, 1.25);
  sun.position.set(0.9, 2.6, 1.9);
  sun.castShadow = true;
  sun.shadow.mapSize.set(2048, 2048);
  sun.shadow.radius = 6;
  sun.shadow.bias = -0.001;
  Object.assign(sun.shadow.camera, {left: -1.2, right: 1.2, top: 1.4, bottom: -1.2});
  scene.add(ground, sun, new THREE.HemisphereLight(0xffffff, 0xcccccc, 0.95));
  return scene;
}

const camera = new THREE.PerspectiveCamera(24, 1, 0.1, 20);
function look(wide, turn) {
  camera.aspect = wide / height;
  camera.position.set(3.2 * Math.sin(turn), 1.35, 3.2 * Math.cos(turn));
  camera.lookAt(0, 0.5, 0);
  camera.updateProjectionMatrix();
  camera.updateMatrixWorld();
}

function draw(scene, left, wide, turn) {
  look(wide, turn);
  renderer.setViewport(left * scale, 0, wide * scale, height * scale);
  renderer.setScissor(left * scale, 0, wide * scale, height * scale);
  renderer.render(scene, camera);
}

const canvas = document.createElement('canvas');
[canvas.width, canvas.height] = [width, height];
const pen = canvas.getContext('2d', {alpha: false});
const scenes = frames.map(scene_of);

// A column of names beside a chair, with lines to the parts
function label(parts, left, wide, column, side) {
  const found = new Map();
  for (const part of parts.filter(p => p.role)) {
    const p = new THREE.Vector3(...part.middle).project(camera);
    const x = left + (p.x + 1) / 2 * wide, y = (1 - p.y) / 2 * height;
    const known = found.get(part.role);
    if (!known || side * x > side * known.x) found.set(part.role, {x, y, colour: part.colour});
  }
  const names = [...found].sort((a, b) => a[1].y - b[1].y);
  let low = 0;
  pen.font = '600 17px sans-serif';
  pen.textAlign = side > 0 ? 'left' : 'right';
  pen.textBaseline = 'middle';
  for (const [role, {x, y, colour}] of names) {
    const row = low = Math.max(y, low + 30);
    pen.strokeStyle = '#555';
    pen.lineWidth = 1;
    pen.beginPath();
    pen.moveTo(column - side * 5, row);
    pen.lineTo(x, y);
    pen.stroke();
    pen.fillStyle = '#333';
    pen.beginPath();
    pen.arc(x, y, 3, 0, 7);
    pen.fill();
    pen.fillStyle = colour;
    pen.fillRect(side > 0 ? column : column - 14, row - 7, 14, 14);
    pen.fillStyle = '#222';
    pen.fillText(role.replace('_', ' '), column + side * 20, row);
  }
}

const out = [], last = frames.length - 1, margin = 140, wide = (width - 2 * margin) / 3, still = 0.62;
for (let i = 0; i < 2 * last; ++i) {
  const step = i <= last ? i : 2 * last - i, turn = still + 0.16 * Math.sin(Math.PI * i / last);
  draw(scenes[0], margin, wide, still);
  draw(scenes[step], margin + wide, wide, turn);
  draw(scenes[last], margin + 2 * wide, wide, still);
  pen.drawImage(renderer.domElement, 0, 0, width, height);
  pen.fillStyle = '#fff';
  pen.fillRect(0, 0, margin, height);
  pen.fillRect(width - margin, 0, margin, height);
  look(wide, still);
  label(frames[0], margin, wide, margin - 12, -1);
  label(frames[last], margin + 2 * wide, wide, width - margin + 12, 1);
  out.push(canvas.toDataURL('image/webp', %(quality)g));
}
document.body.textContent = out.join('\\n');
</script>"""


def role_colours(blocks):
    """Roles of source parts and of target parts, by name."""
    return [{part: block.get("role", "") for block in blocks for part in block[side]} for side in ("source", "target")]


def shape(parts, role_of):
    result = []
    for name, triangles in parts:
        role = role_of(name)
        flat = [round(x, 4) for triangle in triangles for point in triangle for x in point]
        middle = [(min(flat[i::3]) + max(flat[i::3])) / 2 for i in range(3)]
        result.append({"role": role, "colour": COLOURS.get(role, OTHER) if role else UNMATCHED, "triangles": flat, "middle": middle})
    return result


def shapes(program, data, work):
    """The shapes from the one chair to the other, in a page's form."""
    models = [os.path.join(data, name) for name in PAIR]
    match, folder = os.path.join(work, "match.json"), os.path.join(work, "frames")
    subprocess.run([program, "match", *models, "--json", match, "--quiet"], check=True)
    subprocess.run([program, "blend", *models, "--match", match, "-o", folder, "--frames", str(STEPS + 1), "--size", "same", "--quiet"], check=True)
    with open(match) as file:
        of_source, of_target = role_colours(json.load(file)["blocks"])

    def role_of(name):
        a, _, b = name.partition("~")
        return of_source.get(a) or of_target.get(b or a) or ""
    return [shape(read_model(os.path.join(folder, name)), role_of) for name in sorted(os.listdir(folder))]


def chunk(kind, data):
    return kind + struct.pack("<I", len(data)) + data + b"\0" * (len(data) % 2)


def three_bytes(number):
    return struct.pack("<I", number)[:3]


def animated(frames, milliseconds):
    """One WebP file of many."""
    size = three_bytes(WIDTH - 1) + three_bytes(HEIGHT - 1)
    body = chunk(b"VP8X", b"\x02\0\0\0" + size) + chunk(b"ANIM", b"\xff" * 4 + b"\0\0")
    for frame, duration in zip(frames, milliseconds):
        at = frame.index(b"VP8 ")
        body += chunk(b"ANMF", b"\0" * 6 + size + three_bytes(duration) + b"\x02" + frame[at:])
    return b"RIFF" + struct.pack("<I", len(body) + 4) + b"WEBP" + body


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("program")
    parser.add_argument("data")
    parser.add_argument("out")
    parser.add_argument("--browser", default="chromium")
    parser.add_argument("--three", default="/usr/share/javascript/three/three.min.js")
    args = parser.parse_args()
    with tempfile.TemporaryDirectory() as work:
        with open(os.path.join(work, "shapes.js"), "w") as file:
            file.write("const frames = " + json.dumps(shapes(os.path.abspath(args.program), args.data, work)) + ";")
        page = os.path.join(work, "page.html")
        with open(page, "w") as file:
            file.write(PAGE % {"three": args.three, "width": WIDTH, "height": HEIGHT, "quality": QUALITY})
        done = subprocess.run([args.browser, *BROWSER_FLAGS, "--dump-dom", "--timeout=600000", "file://" + page], capture_output=True, text=True, check=True)
    frames = [base64.b64decode(data) for data in re.findall(r"data:image/webp;base64,([\w+/=]+)", done.stdout)]
    durations = [STILL if i in (0, STEPS) else MOVING for i in range(len(frames))]
    with open(args.out, "wb") as file:
        file.write(animated(frames, durations))
    print(f"{args.out}: {len(frames)} frames, {os.path.getsize(args.out)} bytes")


if __name__ == "__main__":
    main()

#!/usr/bin/env python3
# Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
# SPDX-License-Identifier: GPL-3.0-or-later
"""Makes the moving picture of README.md: two chairs with the roles of their parts, and the one turning into the other.

  readme_animation.py PROGRAM DATA OUT.webp [--browser chromium]

A browser without a window draws the frames with three.js; this script makes them one animated WebP.
"""
import argparse
import json
import os
import struct
import subprocess
import tempfile

from picture import GREY, colours_of_roles, hexadecimal, read_model, rendered

PAIR = "chair_four_legged", "chair_swivel"
STEPS = 24  # from one chair to the other
WIDTH, HEIGHT = 1000, 380
STILL, MOVING = 1200, 80  # milliseconds of a frame that shows one of the two chairs, and of others
QUALITY = 0.8

SCRIPT = """
const scale = 2, renderer = makeRenderer(width * scale, height * scale);
renderer.setScissorTest(true);
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
const scenes = frames.map(sceneOf);

// In the coordinates of the camera, the visible point of a part that is next to the middle of all of them; none if it is hidden
function visiblePoint(parts, scene, index) {
  const meshes = scene.children.slice(0, parts.length), ray = new THREE.Raycaster(), list = parts[index].triangles, points = [], middle = new THREE.Vector3();
  for (let i = 0; i < list.length; i += 9) {
    const p = new THREE.Vector3(...[0, 1, 2].map(k => (list[i + k] + list[i + 3 + k] + list[i + 6 + k]) / 3)).project(camera);
    ray.setFromCamera(p, camera);
    const hits = ray.intersectObjects(meshes);
    if (hits.length && hits[0].object === meshes[index]) points.push(p);
  }
  points.forEach(p => middle.addScaledVector(p, 1 / points.length));
  return points.sort((a, b) => a.distanceTo(middle) - b.distanceTo(middle))[0];
}

// The points of all parts with a role, as label() takes them
function anchors(parts, scene) {
  look(wide, still);
  return parts.map((part, i) => ({...part, at: part.role && visiblePoint(parts, scene, i)})).filter(part => part.at);
}

// A column of names beside a chair, with lines to the parts
function label(parts, left, wide, column, side) {
  const found = new Map();
  for (const part of parts) {
    const p = part.at;
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
const ends = [0, last].map(frame => anchors(frames[frame], scenes[frame]));
for (let i = 0; i < 2 * last; ++i) {
  const step = i <= last ? i : 2 * last - i, turn = still + 0.16 * Math.sin(Math.PI * i / last);
  draw(scenes[0], margin, wide, still);
  draw(scenes[step], margin + wide, wide, turn);
  draw(scenes[last], margin + 2 * wide, wide, still);
  pen.drawImage(renderer.domElement, 0, 0, width, height);
  pen.fillStyle = '#fff';
  pen.fillRect(0, 0, margin, height);
  pen.fillRect(width - margin, 0, margin, height);
  label(ends[0], margin, wide, margin - 12, -1);
  label(ends[1], margin + 2 * wide, wide, width - margin + 12, 1);
  out.push(canvas.toDataURL('image/webp', quality));
}
document.body.textContent = out.join('\\n');
"""


def roles_of(blocks):
    """Roles of source parts and of target parts, by name."""
    return [{part: block.get("role", "") for block in blocks for part in block[side]} for side in ("source", "target")]


def shape(parts, role_of, colours):
    result = []
    for name, triangles in parts:
        role = role_of(name)
        flat = [round(x, 4) for triangle in triangles for point in triangle for x in point]
        result.append({"role": role, "colour": hexadecimal(colours[role] if role else GREY), "triangles": flat})
    return result


def shapes(program, data, work):
    """The shapes from one chair to the other, as SCRIPT takes them."""
    models = [os.path.join(data, name) for name in PAIR]
    match, folder = os.path.join(work, "match.json"), os.path.join(work, "frames")
    subprocess.run([program, "match", *models, "--json", match, "--quiet"], check=True)
    subprocess.run([program, "blend", *models, "--match", match, "-o", folder, "--frames", str(STEPS + 1), "--size", "same", "--quiet"], check=True)
    with open(match) as file:
        of_source, of_target = roles_of(json.load(file)["blocks"])

    def role_of(name):
        a, _, b = name.partition("~")
        return of_source.get(a) or of_target.get(b or a) or ""
    roles = sorted({*of_source.values(), *of_target.values()})
    colours = dict(zip(roles, colours_of_roles(roles)))
    return [shape(read_model(os.path.join(folder, name)), role_of, colours) for name in sorted(os.listdir(folder))]


def chunk(kind, data):
    return kind + struct.pack("<I", len(data)) + data + b"\0" * (len(data) % 2)


def three_bytes(number):
    return struct.pack("<I", number)[:3]


def animated(frames, milliseconds):
    """An animated WebP file of single ones. \\param milliseconds duration of each frame"""
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
    args = parser.parse_args()
    with tempfile.TemporaryDirectory() as work:
        data = {"frames": shapes(os.path.abspath(args.program), args.data, work), "width": WIDTH, "height": HEIGHT, "quality": QUALITY}
        frames = rendered(SCRIPT, data, args.browser)
    durations = [STILL if i in (0, STEPS) else MOVING for i in range(len(frames))]
    with open(args.out, "wb") as file:
        file.write(animated(frames, durations))
    print(f"{args.out}: {len(frames)} frames, {os.path.getsize(args.out)} bytes")


if __name__ == "__main__":
    main()

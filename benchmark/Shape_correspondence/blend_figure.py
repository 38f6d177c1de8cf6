#!/usr/bin/env python3
# Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
# SPDX-License-Identifier: GPL-3.0-or-later
"""Draws the frames of a blend side by side, as in the manual:

  blend_figure.py PROGRAM SOURCE TARGET OUT.png [--frames 7] [--options "--abstraction boxes"]

A part and what it becomes have one colour; what vanishes or grows is grey. Needs nothing but Python.
"""
import argparse
import colorsys
import math
import os
import shlex
import struct
import subprocess
import tempfile
import zlib

WIDTH, HEIGHT, TURN, TILT = 170, 210, math.radians(32), math.radians(18)


def read_parts(file):
    """[(name, triangles)], a triangle three points."""
    points, parts = [], []
    for line in open(file):
        word, *rest = line.split()
        if word == "v":
            points.append(tuple(map(float, rest)))
        elif word == "o":
            parts.append((rest[0], []))
        elif word == "f":
            parts[-1][1].append([points[int(corner) - 1] for corner in rest])
    return parts


def seen(p):
    """x to the right, y up, z to the eye."""
    x, z = p[0] * math.cos(TURN) - p[2] * math.sin(TURN), p[0] * math.sin(TURN) + p[2] * math.cos(TURN)
    return x, p[1] * math.cos(TILT) - z * math.sin(TILT), p[1] * math.sin(TILT) + z * math.cos(TILT)


def colour(name, known):
    if name.startswith("~") or name.endswith("~"):
        return 0.72, 0.72, 0.72
    hue = known.setdefault(name, len(known)) * 0.618034 % 1
    return colorsys.hsv_to_rgb(hue, 0.55, 0.95)


def draw(picture, depth, left, triangle, scale, low, rgb):
    a, b, c = ((left + WIDTH / 2 + scale * p[0], HEIGHT - 8 - scale * (p[1] - low), p[2]) for p in triangle)
    (u, v, w), (x, y, z) = ([q[i] - p[i] for i in range(3)] for p, q in ((triangle[0], triangle[1]), (triangle[0], triangle[2])))
    normal = (v * z - w * y, w * x - u * z, u * y - v * x)
    length = math.hypot(*normal)
    area = (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])
    if length == 0 or abs(area) < 1e-9:
        return
    light = 0.45 + 0.55 * abs(0.3 * normal[0] + 0.6 * normal[1] + 0.74 * normal[2]) / length
    shade = bytes(int(255 * min(1, light * channel)) for channel in rgb)
    xs, ys = (a[0], b[0], c[0]), (a[1], b[1], c[1])
    for row in range(max(0, math.ceil(min(ys) - 0.5)), min(HEIGHT - 1, math.floor(max(ys) - 0.5)) + 1):
        for column in range(max(left, math.ceil(min(xs) - 0.5)), min(left + WIDTH - 1, math.floor(max(xs) - 0.5)) + 1):
            px, py = column + 0.5, row + 0.5
            s = ((px - a[0]) * (c[1] - a[1]) - (py - a[1]) * (c[0] - a[0])) / area
            t = ((b[0] - a[0]) * (py - a[1]) - (b[1] - a[1]) * (px - a[0])) / area
            if s < 0 or t < 0 or s + t > 1:
                continue
            at = a[2] + s * (b[2] - a[2]) + t * (c[2] - a[2])
            if at > depth[row].get(column, -math.inf):
                depth[row][column] = at
                picture[row][3 * column:3 * column + 3] = shade


def write_png(file, rows, width):
    def chunk(kind, data):
        return struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))
    with open(file, "wb") as out:
        out.write(b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", struct.pack(">IIBBBBB", width, len(rows), 8, 2, 0, 0, 0)) +
                  chunk(b"IDAT", zlib.compress(b"".join(b"\0" + bytes(row) for row in rows), 9)) + chunk(b"IEND", b""))


def draw_frames(folder, out):
    """Draws the frames in a folder of OBJ files, the first one the source and the last one the target."""
    shapes = [read_parts(os.path.join(folder, name)) for name in sorted(os.listdir(folder))]
    known, names = {}, {}
    for name, _ in shapes[1]:  # the ends have the parts' own names
        source, _, target = name.partition("~")
        if source and target:
            names.setdefault(("source", source), source)
            names.setdefault(("target", target), names[("source", source)])
    width = WIDTH * len(shapes)
    picture = [bytearray(b"\xff" * 3 * width) for _ in range(HEIGHT)]
    for number, parts in enumerate(shapes):
        triangles = [(name, [seen(p) for p in triangle]) for name, of_part in parts for triangle in of_part]
        xs = [p[0] for _, triangle in triangles for p in triangle]
        ys = [p[1] for _, triangle in triangles for p in triangle]
        scale = min((WIDTH - 10) / (max(xs) - min(xs)), (HEIGHT - 16) / (max(ys) - min(ys)))
        middle, low, depth = (max(xs) + min(xs)) / 2, min(ys), [{} for _ in range(HEIGHT)]
        side = "source" if number == 0 else "target" if number == len(shapes) - 1 else ""
        for name, triangle in triangles:
            fades = name.startswith("~") or name.endswith("~")
            source = names.get((side, name), "~") if side else name if fades else name.partition("~")[0]
            draw(picture, depth, number * WIDTH, [(p[0] - middle, p[1], p[2]) for p in triangle], scale, low, colour(source, known))
    write_png(out, picture, width)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("program")
    parser.add_argument("source")
    parser.add_argument("target")
    parser.add_argument("out")
    parser.add_argument("--frames", type=int, default=7)
    parser.add_argument("--options", default="")
    args = parser.parse_args()
    with tempfile.TemporaryDirectory() as scratch:
        frames = os.path.join(scratch, "frames")
        subprocess.run([args.program, "blend", args.source, args.target, "-o", frames, "--frames", str(args.frames), "--quiet",
                        *shlex.split(args.options)], check=True)
        draw_frames(frames, args.out)


if __name__ == "__main__":
    main()

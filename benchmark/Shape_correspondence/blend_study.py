#!/usr/bin/env python3
# Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
# SPDX-License-Identifier: GPL-3.0-or-later
"""Blends pairs of shapes and measures what people see of the blends.

  blend_study.py PROGRAM OUT --pairs FILE --data FOLDER... [--only WORD,WORD] [--cache FOLDER] [--match FOLDER] [--glb] [--measure-only]

FILE has a line for each pair: category, source, target. A shape is FOLDER/SHAPE or FOLDER/CATEGORY/SHAPE. Makes OUT/NN_SOURCE_TARGET with
nine frames, a .json, and a .png that shows them. Prints a table as Markdown, and medians. morphs: share of the matched area of both shapes whose
part has a task that ends as another part; matched: share of the area. jump: the largest change between two of the nine frames, as the share of
the pixels covered in either frame of which one is empty; colour: likewise, or another part is seen. loose: the widest gap that has to be
bridged to join all parts, over the height, more than at the ends. crowd: the longest time for which an old part and a new one are in one place,
that is, share CROWDED of the smaller one's box, in the frame of either end. bent: the largest angle in degrees by which a part that is straight
or flat at its ends is bent, or leans more than its ends, in a frame in which it has grown by half. CPU: seconds in one thread. kB: size of the animation (with --glb).
"""
import argparse
import glob
import json
import os
import resource
import shutil
import statistics
import struct
import subprocess
import sys
import zlib

import numpy as np

SIZE = 200  # pixels of a frame's side
TURN, TILT = np.radians(32), np.radians(18)  # direction of view, in radians
FRAMES = 9
SAMPLES = 4  # number of sample points of a triangle for each pixel of its area
CROWDED = 0.4  # least share of the smaller box that both have in common
LARGE, SLENDER, FLAT, STRAIGHT = 0.02, 6, 6, 2  # parts measured for bending: least share of the area, least ratios of extents, largest bend at the ends in degrees


def read_obj(file):
    """[(name, array of triangles, each three points)]."""
    points, parts = [], []
    with open(file) as lines:
        for line in lines:
            if line.startswith("v "):
                points.append([float(word) for word in line.split()[1:4]])
            elif line.startswith("o "):
                parts.append((line[2:].strip(), []))
            elif line.startswith("f "):
                parts[-1][1].append([int(word.split("/")[0]) - 1 for word in line.split()[1:]])
    points = np.array(points)
    return [(name, points[np.array(faces)]) for name, faces in parts if faces]


def area(triangles):
    return np.linalg.norm(np.cross(triangles[:, 1] - triangles[:, 0], triangles[:, 2] - triangles[:, 0]), axis=1) / 2


def eye():
    c, s, d, e = np.cos(TURN), np.sin(TURN), np.cos(TILT), np.sin(TILT)
    return np.array([[c, 0, -s], [-s * e, d, -c * e], [s * d, e, c * d]])


def render(parts, low, scale):
    """The number of the part at each pixel, or -1, and the brightness."""
    view, all_pixels, depths, numbers, lights = eye(), [], [], [], []
    generator = np.random.default_rng(0)
    for number, (_, triangles) in enumerate(parts):
        seen = (triangles @ view.T - low) * scale
        normals = np.cross(seen[:, 1] - seen[:, 0], seen[:, 2] - seen[:, 0])
        lengths = np.linalg.norm(normals, axis=1)
        count = np.minimum(np.ceil(SAMPLES * lengths / 2).astype(int) + 2, 4 * SIZE * SIZE)
        of = np.repeat(np.arange(len(seen)), count)
        a, b = generator.random(len(of)), generator.random(len(of))
        flipped = a + b > 1
        a[flipped], b[flipped] = 1 - a[flipped], 1 - b[flipped]
        points = seen[of, 0] + a[:, None] * (seen[of, 1] - seen[of, 0]) + b[:, None] * (seen[of, 2] - seen[of, 0])
        light = 0.35 + 0.65 * np.abs(normals @ np.array([0.35, 0.6, 0.72])) / np.maximum(lengths, 1e-12)
        x, y = np.clip(points[:, 0].astype(int), 0, SIZE - 1), np.clip(SIZE - 1 - points[:, 1].astype(int), 0, SIZE - 1)
        all_pixels.append(y * SIZE + x)
        depths.append(points[:, 2])
        numbers.append(np.full(len(of), number))
        lights.append(light[of])
    pixels, depths = np.concatenate(all_pixels), np.concatenate(depths)
    order = np.lexsort((depths, pixels))
    last = order[np.append(pixels[order][1:] != pixels[order][:-1], True)]
    part, brightness = np.full(SIZE * SIZE, -1), np.ones(SIZE * SIZE)
    part[pixels[last]], brightness[pixels[last]] = np.concatenate(numbers)[last], np.concatenate(lights)[last]
    return part.reshape(SIZE, SIZE), brightness.reshape(SIZE, SIZE)


def colour(key):
    hue = (key * 0.618034) % 1
    return np.clip(np.abs((hue + np.array([0, 2 / 3, 1 / 3])) % 1 * 6 - 3) - 1, 0, 1) * 0.6 + 0.3


def write_png(file, picture):
    height, width, _ = picture.shape
    rows = b"".join(b"\0" + row.tobytes() for row in (255 * np.clip(picture, 0, 1)).astype(np.uint8))
    chunk = lambda kind, data: struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))
    with open(file, "wb") as out:
        out.write(b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", struct.pack(">2I5B", width, height, 8, 2, 0, 0, 0)) +
                  chunk(b"IDAT", zlib.compress(rows)) + chunk(b"IEND", b""))


def morphing(frames, tasks):
    """The share of the area of both shapes that is matched, and the share of the matched area that morphs."""
    of_part = [{name: area(triangles).sum() for name, triangles in frames[end]} for end in (0, -1)]
    total, matched, morphs = 0, 0, 0
    for areas, side in zip(of_part, ("source", "target")):
        whole = sum(areas.values())
        kinds = {}
        for task in tasks:
            if side in task:
                kinds.setdefault(task[side], []).append(task)
        for name, part_area in areas.items():
            some = kinds.get(name, [])
            is_morph = any(task["task"] in ("morph", "split", "merge") for task in some)
            total += part_area / whole
            if is_morph or any("obstacle" in task for task in some):
                matched += part_area / whole
            if is_morph:
                morphs += part_area / whole
    return matched / total, morphs / matched if matched else 1


def times_of(task):
    return task.get("begin", 0), task.get("end", 1)


def crowd(frames, tasks):
    """The longest time for which an old part and a new part are in one place."""
    boxes = []
    for end in (0, -1):
        points = np.concatenate([triangles.reshape(-1, 3) for _, triangles in frames[end]])
        low, size = points.min(0), np.maximum(np.ptp(points, 0), 1e-9)
        relative = lambda triangles: ((triangles.reshape(-1, 3) - low) / size)
        boxes.append({name: (relative(t).min(0) - 0.02, relative(t).max(0) + 0.02) for name, t in frames[end]})
    longest = 0
    for old in tasks:
        for new in tasks:
            if old["task"] != "shrink" or new["task"] != "grow":
                continue
            (a, b), (c, d) = boxes[0][old["source"]], boxes[1][new["target"]]
            common = np.prod(np.clip(np.minimum(b, d) - np.maximum(a, c), 0, None))
            if common > CROWDED * min(np.prod(b - a), np.prod(d - c)):
                longest = max(longest, times_of(old)[1] - times_of(new)[0])
    return longest


def axes_of(triangles):
    """Middle, principal axes (rows, the longest first) and extents of a surface."""
    weights, middles = area(triangles), triangles.mean(1)
    if weights.sum() <= 0:
        return None
    middle = np.average(middles, axis=0, weights=weights)
    spread = np.einsum("t,tij,tik->jk", weights, triangles - middle, triangles - middle)
    axes = np.linalg.eigh(spread)[1][:, ::-1].T
    return middle, axes, np.maximum(np.ptp(triangles.reshape(-1, 3) @ axes.T, 0), 1e-9)


def angle(a, b):
    return np.degrees(np.arccos(np.clip(abs(a @ b) / max(np.linalg.norm(a) * np.linalg.norm(b), 1e-12), 0, 1)))


def slices(triangles, middle, axis, count=4):
    """Middles of slices of a surface across an axis."""
    generator = np.random.default_rng(0)
    weights = area(triangles)
    chosen = generator.choice(len(triangles), 2000, p=weights / weights.sum())
    a, b = generator.random((2, 2000))
    a, b = np.where(a + b > 1, 1 - a, a), np.where(a + b > 1, 1 - b, b)
    t = triangles[chosen]
    points = t[:, 0] + a[:, None] * (t[:, 1] - t[:, 0]) + b[:, None] * (t[:, 2] - t[:, 0]) - middle
    at = points @ axis
    borders = np.linspace(at.min(), at.max(), count + 1)[1:-1]
    of = np.searchsorted(borders, at)
    return [(points[of == i].min(0) + points[of == i].max(0)) / 2 for i in range(count) if (of == i).sum() > 5]


def bend(triangles, found):
    """The largest angle between directions from slice to slice, along the length of a rod or, of a plate, out of its plane."""
    middle, axes, extents = found
    worst = 0
    for along in range(1 if extents[0] > SLENDER * extents[1] else 2):
        places = slices(triangles, middle, axes[along])
        steps = np.diff(places, axis=0)
        if along == 1 or extents[0] <= SLENDER * extents[1]:  # only bending out of the plane counts
            steps = np.outer(steps @ axes[along], axes[along]) + np.outer(steps @ axes[2], axes[2])
        worst = max([worst] + [angle(a, b) for a, b in zip(steps[:-1], steps[1:])])
    return worst


def bent(frames, tasks):
    """The largest bend or lean of a part that is straight at its ends, and the name of the part."""
    ends = []
    for end in (0, -1):
        found = {name: (triangles, axes_of(triangles)) for name, triangles in frames[end]}
        whole = sum(area(triangles).sum() for triangles, _ in found.values())
        is_straight = lambda t, axes: axes is not None and (
            axes[2][0] > SLENDER * axes[2][1] or axes[2][1] > FLAT * axes[2][2]) and bend(t, axes) < STRAIGHT
        ends.append({name: (axes, area(t).sum() / whole, bend(t, axes)) for name, (t, axes) in found.items()
                     if area(t).sum() > LARGE * whole and is_straight(t, axes)})
    worst, which = 0, ""
    for frame in frames[1:-1]:
        whole = sum(area(triangles).sum() for _, triangles in frame)
        for name, triangles in frame:
            names = name.split("~")
            at = [end[part] for end, part in zip(ends, names) if part in end]
            if len(at) < sum(part != "" for part in names) or area(triangles).sum() / whole < max(a[1] for a in at) / 2:
                continue
            found = axes_of(triangles)
            principal = 0 if all(a[0][2][0] > SLENDER * a[0][2][1] for a in at) else 2  # the length, or the normal
            to_ends = [angle(found[1][principal], a[0][1][principal]) for a in at]
            lean = (sum(to_ends) - angle(at[0][0][1][principal], at[-1][0][1][principal])) / len(at)
            value = max(bend(triangles, found) - max(a[2] for a in at), lean)
            if value > worst:
                worst, which = value, name
    return worst, which


def measure(folder, picture):
    frames = [read_obj(file) for file in sorted(glob.glob(os.path.join(folder, "*.obj")))]
    with open(folder + ".json") as file:
        document = json.load(file)
    tasks = document["tasks"]
    to_key = [{}, {}]  # numbers of colours; a part and its counterpart have the same
    for task in tasks:
        names = [task.get("source"), task.get("target")]
        key = next((to_key[i][name] for i, name in enumerate(names) if name in to_key[i]), len(to_key[0]) + len(to_key[1]))
        for known, name in zip(to_key, names):
            if name:
                known.setdefault(name, key)

    def key_of(frame, name):
        a, _, b = (name, "", "") if frame == 0 else ("", "", name) if frame == FRAMES - 1 else name.partition("~")
        return to_key[0].get(a, to_key[1].get(b, -1))
    view = eye()
    points = np.concatenate([(triangles @ view.T).reshape(-1, 3) for frame in frames for _, triangles in frame])
    low, high = points.min(0), points.max(0)
    scale = 0.94 * SIZE / max((high - low)[:2])
    low = (low + high) / 2 - 0.5 * SIZE / scale
    images = []
    for i, frame in enumerate(frames):
        part, light = render(frame, low, scale)
        keys = np.array([key_of(i, name) for name, _ in frame] + [-2])
        images.append((keys[part], light))
    sheet, jump, visible = np.ones((SIZE, SIZE * len(images), 3)), 0, 0
    for i, (keys, light) in enumerate(images):
        picture_i = np.ones((SIZE, SIZE, 3))
        for key in np.unique(keys):
            if key > -2:
                picture_i[keys == key] = colour(key) if key >= 0 else 0.7
        sheet[:, i * SIZE:(i + 1) * SIZE] = picture_i * light[:, :, None]
        if i:
            before, union = images[i - 1][0], (images[i - 1][0] > -2) | (keys > -2)
            jump = max(jump, ((before > -2) != (keys > -2)).sum() / union.sum())
            visible = max(visible, (before != keys).sum() / union.sum())
    if picture:
        write_png(folder + ".png", sheet)
    matched, morphs = morphing(frames, tasks)
    worst, which = bent(frames, tasks)
    if worst > 5:
        print(f"{os.path.basename(folder)}: {which} is bent", file=sys.stderr)
    return {"matched": matched, "morphs": morphs, "jump": jump, "colour": visible,
            "loose": max(frame["quality"]["apart"] for frame in document["frames"]), "crowd": crowd(frames, tasks), "bent": worst}


def find_model(folders, category, shape):
    for folder in folders:
        for path in (os.path.join(folder, shape), os.path.join(folder, category, shape)):
            if os.path.isdir(path):
                return path
    return None


def blend(args, models, name):
    """Makes the frames and, with --glb, the animation. Returns processor seconds for the frames, and kilobytes of the animation."""
    folder = os.path.join(args.out, name)
    shutil.rmtree(folder, ignore_errors=True)
    command = [args.program, "blend", *models, "-q", "--threads", "1"]
    if args.cache:
        command += ["--cache", args.cache]
    if args.match:
        command += ["--match", os.path.join(args.match, name + ".json")]
    used = lambda: sum(resource.getrusage(resource.RUSAGE_CHILDREN)[:2])
    before = used()
    subprocess.run(command + ["-o", folder, "--frames", str(FRAMES), "--json", folder + ".json"], check=True)
    seconds = used() - before
    if not args.glb:
        return {"CPU": seconds}
    subprocess.run(command + ["-o", folder + ".glb"], check=True)
    return {"CPU": seconds, "kB": os.path.getsize(folder + ".glb") / 1000}


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("program")
    parser.add_argument("out")
    parser.add_argument("--pairs", required=True)
    parser.add_argument("--data", nargs="+", required=True)
    parser.add_argument("--only", default="")
    parser.add_argument("--cache")
    parser.add_argument("--match")
    parser.add_argument("--measure-only", action="store_true")
    parser.add_argument("--glb", action="store_true")
    args = parser.parse_args()
    os.makedirs(args.out, exist_ok=True)
    with open(args.pairs) as file:
        pairs = [line.split() for line in file if line.strip() and not line.startswith("#")]
    rows = []
    for number, (category, source, target) in enumerate(pairs):
        name = f"{number:02}_{source}_{target}"
        models = [find_model(args.data, category, shape) for shape in (source, target)]
        if None in models or not any(word in name for word in args.only.split(",")):
            continue
        made = {} if args.measure_only else blend(args, models, name)
        row = {**measure(os.path.join(args.out, name), True), **made}
        if not rows:
            print("| blend | " + " | ".join(row) + " |\n|---|" + "---|" * len(row))
        rows.append(row)
        print(f"| {name} | " + " | ".join(f"{value:.2f}" for value in row.values()) + " |", flush=True)
    for label, of in (("median", statistics.median), ("mean", statistics.mean)):
        print(f"| {label} of {len(rows)} | " + " | ".join(f"{of(row[key] for row in rows):.2f}" for key in rows[0]) + " |")


if __name__ == "__main__":
    main()

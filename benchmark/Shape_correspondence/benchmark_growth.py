#!/usr/bin/env python3
# Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
# SPDX-License-Identifier: GPL-3.0-or-later
"""Measures how time and memory grow with the numbers of parts, triangles and shapes.

  benchmark_growth.py BUILD_FOLDER [--parts 30,100,300,1000] [--triangles 1000,10000,100000,1000000] [--shapes 50,200,1000] [--limit 300]

Racks have equal slats, and boards have pegs that all differ. Two of each number of parts are matched by every method. A ball of triangles on
a box is abstracted. All pairs of generated shapes are matched in one thread. Prints processor seconds and megabytes, and for each column the
exponent of a power law: the slope of a least squares line through the logarithms of the times above 0.05 s. What takes longer than the limit
(in seconds) is left out.
"""
import argparse
import math
import os
import random
import resource
import subprocess
import tempfile

METHODS = {"default": [], "exact": ["--search", "exact"], "beam": ["--search", "beam"]}
SHORTEST = 0.05  # seconds: the least time that counts for a power law


def write_box(out, count, name, low, high):
    """Appends a box to an OBJ file that has `count` boxes."""
    out.write(f"o {name}\n")
    for corner in range(8):
        out.write("v " + " ".join(f"{(high if corner >> axis & 1 else low)[axis]:.6f}" for axis in range(3)) + "\n")
    for face in ((0, 2, 3, 1), (4, 5, 7, 6), (0, 1, 5, 4), (2, 6, 7, 3), (0, 4, 6, 2), (1, 3, 7, 5)):
        out.write("f " + " ".join(str(8 * count + corner + 1) for corner in face) + "\n")


def write_slats(path, slats, seed):
    height = 4 + seed
    with open(path, "w") as out:
        write_box(out, 0, "bottom", (0, 0, 0), (slats, 1, 1))
        write_box(out, 1, "top", (0, height, 0), (slats, height + 1, 1))
        for i in range(slats):
            write_box(out, i + 2, f"slat_{i}", (i + 0.3, 1, 0.4), (i + 0.5, height, 0.6))


def write_pegs(path, pegs, seed):
    drawn = random.Random(seed)
    with open(path, "w") as out:
        write_box(out, 0, "board", (0, 0, 0), (pegs, 1, 1))
        for i in range(pegs):
            width, height, depth = drawn.uniform(0.1, 0.8), math.exp(drawn.uniform(0, 3)), drawn.uniform(0.1, 0.8)
            write_box(out, i + 1, f"peg_{i}", (i + 0.5 - width / 2, 1, 0.5 - depth / 2), (i + 0.5 + width / 2, 1 + height, 0.5 + depth / 2))


def measured(command, limit):
    """Processor seconds and megabytes of a command; None if it takes too long or fails."""
    process = subprocess.Popen(command, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL,
                               preexec_fn=lambda: resource.setrlimit(resource.RLIMIT_CPU, (limit, limit)))
    _, status, used = os.wait4(process.pid, 0)
    return (used.ru_utime + used.ru_stime, used.ru_maxrss / 1024) if status == 0 else None


def exponent(times):
    """Exponent of the power law of times, pairs of a number and seconds; None if fewer than two times count."""
    points = [(math.log(parts), math.log(seconds)) for parts, seconds in times if seconds >= SHORTEST]
    if len(points) < 2:
        return None
    mean = [sum(point[axis] for point in points) / len(points) for axis in (0, 1)]
    return sum((x - mean[0]) * (y - mean[1]) for x, y in points) / sum((x - mean[0]) ** 2 for x, _ in points)


def write_ball(path, triangles):
    rings = round(math.sqrt(triangles / 4))
    around = 2 * rings
    with open(path, "w") as out:
        write_box(out, 0, "box", (-1, -3, -1), (1, -1.5, 1))
        out.write("o ball\nv 0 1.5 0\nv 0 -1.5 0\n")
        for ring in range(1, rings):
            polar = math.pi * ring / rings
            for k in range(around):
                x, z = math.cos(2 * math.pi * k / around), math.sin(2 * math.pi * k / around)
                out.write(f"v {math.sin(polar) * x:.7f} {1.5 * math.cos(polar):.7f} {0.8 * math.sin(polar) * z:.7f}\n")
        vertex = lambda ring, k: 11 + (ring - 1) * around + k % around  # after the box and the poles
        for k in range(around):
            out.write(f"f 9 {vertex(1, k + 1)} {vertex(1, k)}\nf 10 {vertex(rings - 1, k)} {vertex(rings - 1, k + 1)}\n")
            for ring in range(1, rings - 1):
                out.write(f"f {vertex(ring, k)} {vertex(ring, k + 1)} {vertex(ring + 1, k + 1)} {vertex(ring + 1, k)}\n")


def table(name, columns, rows):
    """A table of measurements with their exponents. \\param rows pairs of a number and its measurements; may be a generator"""
    lines = [f"| {name} | " + " | ".join(columns) + " |", "|---" * (len(columns) + 1) + "|"]
    times = [[] for _ in columns]
    for number, row in rows:
        for of_column, used in zip(times, row):
            if used:
                of_column.append((number, used[0]))
        lines.append(f"| {number} | " + " | ".join("%.2f s, %.0f MB" % used if used else "-" for used in row) + " |")
    grown = [exponent(of_column) for of_column in times]
    return "\n".join(lines + ["| exponent | " + " | ".join("-" if e is None else f"{e:.1f}" for e in grown) + " |", ""])


def graph(program, model, output, limit):
    return measured([program, "graph", model, "--up", "y", "--parts", "file", "--quiet", "--threads", "1", "-o", output], limit)


def parts_rows(program, write, numbers, limit):
    for parts in numbers:
        with tempfile.TemporaryDirectory() as folder:
            graphs, row = [], []
            for seed in (1, 2):
                model = os.path.join(folder, f"{seed}.obj")
                graphs.append(os.path.join(folder, f"{seed}.json"))
                write(model, parts, seed)
                row = [graph(program, model, graphs[-1], limit)]
            match = [program, "match", *graphs, "--quiet", "--threads", "1", "--json", os.path.join(folder, "found.json")]
            yield parts, row + [measured(match + options, limit) for options in METHODS.values()]


def triangles_rows(program, numbers, limit):
    for triangles in numbers:
        with tempfile.TemporaryDirectory() as folder:
            model = os.path.join(folder, "ball.obj")
            write_ball(model, triangles)
            yield triangles, [graph(program, model, os.path.join(folder, "graph.json"), limit)]


def shapes_rows(program, generator, numbers, limit):
    for shapes in numbers:
        with tempfile.TemporaryDirectory() as folder:
            graphs = os.path.join(folder, "graphs")
            subprocess.run([generator, str(shapes), graphs], check=True, stdout=subprocess.DEVNULL)
            command = [program, "collection", graphs, "--quiet", "--threads", "1", "--store", os.path.join(folder, "store"),
                       "--json", os.path.join(folder, "all.json"), "--html", os.path.join(folder, "all.html")]
            yield shapes, [measured(command, limit)]


def tables(build, parts, triangles, shapes, limit):
    program = os.path.join(build, "shape_correspondence")
    generator = os.path.join(build, "benchmark", "Shape_correspondence", "generate_collection")
    for name, write in (("slats", write_slats), ("pegs", write_pegs)):
        yield table(name, ["graph"] + list(METHODS), parts_rows(program, write, parts, limit))
    yield table("triangles", ["graph"], triangles_rows(program, triangles, limit))
    yield table("shapes", ["collection, all pairs, with page"], shapes_rows(program, generator, shapes, limit))


def numbers(text):
    return [int(word) for word in text.split(",") if word]


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("build")
    parser.add_argument("--parts", type=numbers, default=[30, 100, 300, 1000])
    parser.add_argument("--triangles", type=numbers, default=[1000, 10000, 100000, 1000000])
    parser.add_argument("--shapes", type=numbers, default=[50, 200, 1000])
    parser.add_argument("--limit", type=int, default=300)
    args = parser.parse_args()
    for text in tables(args.build, args.parts, args.triangles, args.shapes, args.limit):
        print(text, flush=True)


if __name__ == "__main__":
    main()

#!/usr/bin/env python3
# Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
# SPDX-License-Identifier: GPL-3.0-or-later
"""Measures how time and memory grow with the number of parts.

  benchmark_growth.py PROGRAM [--parts 30,100,300,1000] [--limit 100]

Racks have equal slats, and boards have pegs that all differ. Two of each number of parts are matched by every method. Prints processor
seconds and megabytes, and for each column the exponent of a power law: the slope of a least squares line through the logarithms of the
times above 0.05 s. What takes longer than the limit (in seconds) is left out.
"""
import argparse
import math
import os
import random
import resource
import subprocess
import tempfile

METHODS = {"default": [], "exact": ["--search", "exact"], "beam": ["--search", "beam"]}
SHORTEST = 0.05  # seconds that a power law is fitted to


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
    """Processor seconds and megabytes of a command; none if it takes too long or fails."""
    process = subprocess.Popen(command, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL,
                               preexec_fn=lambda: resource.setrlimit(resource.RLIMIT_CPU, (limit, limit)))
    _, status, used = os.wait4(process.pid, 0)
    return (used.ru_utime + used.ru_stime, used.ru_maxrss / 1024) if status == 0 else None


def exponent(times):
    """Of the pairs of number of parts and seconds; none if there are fewer than two."""
    points = [(math.log(parts), math.log(seconds)) for parts, seconds in times if seconds >= SHORTEST]
    if len(points) < 2:
        return None
    mean = [sum(point[axis] for point in points) / len(points) for axis in (0, 1)]
    return sum((x - mean[0]) * (y - mean[1]) for x, y in points) / sum((x - mean[0]) ** 2 for x, _ in points)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("program")
    parser.add_argument("--parts", default="30,100,300,1000")
    parser.add_argument("--limit", type=int, default=100)
    args = parser.parse_args()
    columns = ["graph"] + list(METHODS)
    for name, write in (("slats", write_slats), ("pegs", write_pegs)):
        print(f"| {name} | " + " | ".join(columns) + " |\n" + "|---" * (len(columns) + 1) + "|")
        times = {column: [] for column in columns}
        for parts in map(int, args.parts.split(",")):
            with tempfile.TemporaryDirectory() as folder:
                graphs, used = [], {}
                for seed in (1, 2):
                    model = os.path.join(folder, f"{seed}.obj")
                    graphs.append(os.path.join(folder, f"{seed}.json"))
                    write(model, parts, seed)
                    used["graph"] = measured([args.program, "graph", model, "--up", "y", "--parts", "file", "--quiet", "-o", graphs[-1]], args.limit)
                for method, options in METHODS.items():
                    used[method] = measured([args.program, "match", *graphs, "--quiet", *options, "--json", os.path.join(folder, "found.json")], args.limit)
            for column in columns:
                if used[column]:
                    times[column].append((parts, used[column][0]))
            print(f"| {parts} | " + " | ".join("%.2f s, %.0f MB" % used[column] if used[column] else "-" for column in columns) + " |", flush=True)
        grown = {column: exponent(times[column]) for column in columns}
        print("| exponent | " + " | ".join("%.1f" % grown[column] if grown[column] is not None else "-" for column in columns) + " |\n")


if __name__ == "__main__":
    main()

#!/usr/bin/env python3
# Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
# SPDX-License-Identifier: GPL-3.0-or-later
"""Measures abstraction and search, and writes the manual's page on performance.

  performance.py BUILD_FOLDER doc/Shape_correspondence/Performance.md [--shapes 8] [--note TEXT]

Some shapes of every category of `generate_models --benchmark` are abstracted by the program and matched by `benchmark_search`; both must be
built. With the usual eight shapes a category it takes ten minutes. The note stands beside the machine's name, such as "other
programs ran at the same time".
"""
import argparse
import datetime
import glob
import math
import os
import statistics
import subprocess
import sys
import tempfile
import time

import benchmark_growth

PAGE = """# Performance

Measured by `benchmark/Shape_correspondence/performance.py`, which writes this page, on {machine}, {date}. {note}

The shapes are generated, {shapes} of each category (`generate_models --benchmark`). Everything runs in one thread, unless threads are named.

## Abstraction

The table has processor seconds of the command `graph` for one shape: reading, repair, remeshing, curves and sheets, symmetry groups and contacts. Of parts that are
copies of each other, only one is abstracted. `--cache` stores graphs, so that a shape is abstracted once.

{abstraction}
## Search

The table has milliseconds for one pair of shapes whose graphs are known. The methods are the default, exact search, and the beam search of the paper. Both searches run in both
directions, and their times include the tables of energies. All pairs within a category were measured, each three times, of which the fastest counts. The columns "95 %" have 95th
percentiles.

{search}
The tables of both searches take about a third longer than with the version of 24 November 2026 (on the same graphs of chairs and tables: instructions 1.17, seconds 1.3; exact
search itself is as fast as before). That version had vector instructions written by hand. They are plain loops now, which compilers translate for several instruction sets: 270 lines fewer,
and the same results on every system. Curves that are compared as sheets no longer have a case of their own.

## Growth

The time of a match grows with the number n of parts about as n to the power of

{growth}
The exponents are those of a least squares line through the logarithms, where n is the geometric mean of the two shapes' numbers of parts.

How far that goes is measured by `benchmark_growth.py`: racks of equal slats, boards with pegs that all differ, a ball of triangles on a box, and sets of
shapes. The tables have processor seconds and memory, and the exponents of power laws. A dash stands for more than {limit} seconds.

{large}
## A Pair from Files

The command `match` takes {cold} seconds for the chairs {pair}, in as many threads as the machine has cores, and {warm} seconds with
`--cache` once their graphs are known. These are wall-clock times, medians of three and of nine runs. Models are read each time.
"""
LIMIT = 300  # seconds for a measurement of growth
METHODS = ["default", "exact search", "beam search"]


def run(command):
    """The output of a command that must succeed, and its processor seconds."""
    with tempfile.TemporaryFile("w+") as output:
        process = subprocess.Popen(command, stdout=output, stderr=subprocess.PIPE)
        errors = process.stderr.read()
        _, status, usage = os.wait4(process.pid, 0)
        process.returncode = os.waitstatus_to_exitcode(status)
        if process.returncode != 0:
            sys.exit(f"performance.py: {' '.join(command)}: {errors.decode()}")
        output.seek(0)
        return output.read(), usage.ru_utime + usage.ru_stime


def machine():
    """The processor's name and the number of cores."""
    name = "an unknown processor"
    if os.path.exists("/proc/cpuinfo"):
        with open("/proc/cpuinfo") as file:
            name = next((line.split(":")[1].strip() for line in file if line.startswith("model name")), name)
    return f"{name}, {os.cpu_count()} cores"


def quantile(values, share):
    values = sorted(values)
    return values[min(len(values) - 1, int(share * len(values)))]


def text(value):
    return f"{value:.3g}" if value < 100 else f"{value:.0f}"


def table(heads, rows):
    lines = [heads, ["---"] * len(heads), *rows]
    return "".join("| " + " | ".join(row) + " |\n" for row in lines)


def measure_abstraction(program, shapes, graphs):
    """Writes graphs. Returns the table, and the files of the graphs by category."""
    rows, files = [], {}
    for category, folders in shapes.items():
        seconds, parts = [], []
        os.makedirs(os.path.join(graphs, category))
        for folder in folders:
            file = os.path.join(graphs, category, os.path.basename(folder) + ".json")
            _, used = run([program, "graph", os.path.join(folder, "parts"), "--threads", "1", "-o", file])
            seconds.append(used)
            parts.append(len(os.listdir(os.path.join(folder, "parts"))))
            files.setdefault(category, []).append(file)
        rows.append([category, text(statistics.median(parts)), text(statistics.median(seconds)), text(max(seconds))])
    return table(["category", "parts, median", "seconds, median", "most"], rows), files


def measure_search(benchmark, files):
    """By category, a list with the numbers of parts of each pair and the milliseconds of each method."""
    result = {}
    for category, graphs in files.items():
        lines = [line.split() for line in run([benchmark, "--pairs", "--repeats", "3", *graphs])[0].splitlines()]
        result[category] = [[float(cell) for cell in line[1:]] for line in lines if line[:1] == ["pair"]]
    return result


def search_table(pairs):
    rows = []
    for category, found in [*pairs.items(), ("all", [pair for found in pairs.values() for pair in found])]:
        cells = [category, str(len(found))]
        for method in range(len(METHODS)):
            times = [pair[2 + method] for pair in found]
            cells += [text(statistics.median(times)), text(quantile(times, 0.95))]
        rows.append(cells)
    heads = ["category", "pairs"]
    for method in METHODS:
        heads += [f"{method}, median", "95 %"]
    return table(heads, rows)


def exponent(sizes, times):
    """The slope of a least squares line through the logarithms of sizes and times."""
    x, y = [math.log(size) for size in sizes], [math.log(time) for time in times]
    mean_x, mean_y = statistics.mean(x), statistics.mean(y)
    return sum((a - mean_x) * (b - mean_y) for a, b in zip(x, y)) / sum((a - mean_x) ** 2 for a in x)


def growth_table(pairs):
    found = [pair for of_category in pairs.values() for pair in of_category]
    sizes = [math.sqrt(pair[0] * pair[1]) for pair in found]
    return table(METHODS, [[f"{exponent(sizes, [pair[2 + method] for pair in found]):.1f}"
                            for method in range(len(METHODS))]])


def pair_seconds(program, chairs, caches):
    """Wall-clock seconds of a match without and with known graphs: medians of three and of nine. \\param caches folder for caches"""
    def seconds(cache):
        begin = time.monotonic()
        run([program, "match", *[os.path.join(chair, "parts") for chair in chairs], "--cache", os.path.join(caches, cache)])
        return time.monotonic() - begin
    return (statistics.median(seconds(cache) for cache in ("first", "second", "third")),
            statistics.median(seconds("first") for _ in range(9)))


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("build")
    parser.add_argument("page")
    parser.add_argument("--shapes", type=int, default=8, help="of each category, at least 2")
    parser.add_argument("--note", default="", help="a sentence on what else the machine did")
    args = parser.parse_args()
    program = os.path.join(args.build, "shape_correspondence")
    benchmarks = os.path.join(args.build, "benchmark", "Shape_correspondence")
    with tempfile.TemporaryDirectory() as work:
        models = os.path.join(work, "models")
        run([os.path.join(benchmarks, "generate_models"), "--benchmark", models])
        shapes = {category: sorted(glob.glob(os.path.join(models, category, "*")))[:args.shapes]
                  for category in sorted(os.listdir(models))}
        abstraction, files = measure_abstraction(program, shapes, os.path.join(work, "graphs"))
        pairs = measure_search(os.path.join(benchmarks, "benchmark_search"), files)
        chairs = shapes["chair"][:2]
        cold, warm = pair_seconds(program, chairs, os.path.join(work, "cache"))
    large = "\n".join(benchmark_growth.tables(args.build, [30, 100, 300, 1000], [1000, 10000, 100000, 1000000], [50, 200, 1000], LIMIT))
    page = PAGE.format(machine=machine(), date=datetime.date.today().strftime("%B %Y"), note=args.note,
                       shapes=args.shapes, abstraction=abstraction, search=search_table(pairs),
                       growth=growth_table(pairs), pair=" and ".join(f"`{os.path.basename(c)}`" for c in chairs),
                       cold=text(cold), warm=text(warm), limit=LIMIT, large=large)
    with open(args.page, "w") as file:
        file.write(page)


if __name__ == "__main__":
    main()

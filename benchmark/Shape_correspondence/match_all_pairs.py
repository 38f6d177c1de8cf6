#!/usr/bin/env python3
# Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
# SPDX-License-Identifier: GPL-3.0-or-later
"""Matches all pairs of shapes within each category of a folder of labelled shapes with the program, and sums up.

  match_all_pairs.py PROGRAM DATA OUT [--graphs] [--category chair,table] [--options "--search exact"] [--jobs 2]

DATA holds CATEGORY/SHAPE/parts; results go to OUT/CATEGORY/A--B.json, the log of a failed match beside it. With --graphs every
shape is turned into a structural graph once (OUT/graphs) and the graphs are matched: the same pairs in a fraction of the time.
Ends with exit status 1 if a match failed or is incomplete.
"""
import argparse
import concurrent.futures
import itertools
import json
import os
import shlex
import statistics
import subprocess
import sys

PHASES = ("read", "abstraction", "structure", "search")


def run(command, log):
    done = subprocess.run(command, stdin=subprocess.DEVNULL, capture_output=True, text=True)
    if done.returncode:
        with open(log, "w") as file:
            file.write(f"exit status {done.returncode}\n{done.stdout}{done.stderr}")
    return done.returncode


def shapes_of(data, category):
    folder = os.path.join(data, category)
    return [s for s in sorted(os.listdir(folder)) if os.path.isdir(os.path.join(folder, s, "parts"))]


def make_graph(args, category, shape):
    out = os.path.join(args.out, "graphs", category, shape + ".json")
    os.makedirs(os.path.dirname(out), exist_ok=True)
    model = os.path.join(args.data, category, shape, "parts")
    return run([args.program, "graph", model, "-o", out, "--quiet", "--threads", "1"], out + ".log")


def match(args, category, a, b):
    out = os.path.join(args.out, category, f"{a}--{b}.json")
    os.makedirs(os.path.dirname(out), exist_ok=True)
    inputs = [os.path.join(args.out, "graphs", category, s + ".json") if args.graphs
              else os.path.join(args.data, category, s, "parts") for s in (a, b)]
    code = run([args.program, "match", *inputs, "--json", out, "--quiet", "--threads", "1", *shlex.split(args.options)],
               out + ".log")
    if code:
        return category, None
    with open(out) as file:
        return category, json.load(file)


def progress(results, total, what):
    for i, result in enumerate(results, 1):
        if sys.stderr.isatty():
            print(f"\r{what} {i}/{total} ", end="", file=sys.stderr)
        yield result


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("program")
    parser.add_argument("data")
    parser.add_argument("out")
    parser.add_argument("--graphs", action="store_true")
    parser.add_argument("--category", default="")
    parser.add_argument("--options", default="")
    parser.add_argument("--jobs", type=int, default=2)
    args = parser.parse_args()
    args.program = os.path.abspath(args.program)

    wanted = set(filter(None, args.category.split(",")))
    categories = [c for c in sorted(os.listdir(args.data))
                  if os.path.isdir(os.path.join(args.data, c)) and (not wanted or c in wanted)]
    shapes = {c: shapes_of(args.data, c) for c in categories}
    pairs = [(c, a, b) for c in categories for a, b in itertools.combinations(shapes[c], 2)]
    with concurrent.futures.ThreadPoolExecutor(args.jobs) as pool:
        if args.graphs:
            jobs = [(c, s) for c in categories for s in shapes[c]]
            failed = sum(map(bool, progress(pool.map(lambda j: make_graph(args, *j), jobs), len(jobs), "graph")))
            if failed:
                print(f"{failed} graphs failed; see {args.out}/graphs/*/*.log")
        results = list(progress(pool.map(lambda p: match(args, *p), pairs), len(pairs), "match"))

    bad = 0
    print(f"{'category':<12}{'pairs':>6}{'failed':>8}{'proven':>8}" + "".join(f"{p + ' s':>14}" for p in PHASES) + "   (medians)")
    for category in categories:
        rows = [r for c, r in results if c == category]
        good = [r for r in rows if r and r["complete"]]
        bad += len(rows) - len(good)
        medians = [statistics.median(r["seconds"].get(p, 0) for r in good) if good else float("nan") for p in PHASES]
        proven = sum(bool(r.get("optimal")) for r in good)
        print(f"{category:<12}{len(rows):>6}{len(rows) - len(good):>8}{proven:>8}" + "".join(f"{m:>14.4f}" for m in medians))
    sys.exit(1 if bad else 0)


if __name__ == "__main__":
    main()

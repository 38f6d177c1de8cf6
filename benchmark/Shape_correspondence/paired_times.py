#!/usr/bin/env python3
# Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
# SPDX-License-Identifier: GPL-3.0-or-later
"""Compares the processor seconds of two builds of the program.

  paired_times.py BEFORE AFTER [--rounds 3] [--command graph] MODEL...

BEFORE and AFTER are two builds of `shape_correspondence`. Each model is given to both in turn, so that they run under the same load; the
category of a model is the folder that holds the shape (CATEGORY/SHAPE/parts, CATEGORY/SHAPE.obj). Printed are medians over the models of a
category: seconds before, after, and the ratio of the two of each model. Of the rounds of one model the fastest counts. With
`--command match`, pairs of neighbouring models of a category are matched.
"""
import argparse
import os
import statistics
import subprocess
import sys


def processor_seconds(command):
    """Of a child process and its threads; it must succeed."""
    process = subprocess.Popen(command, stdout=subprocess.DEVNULL, stderr=subprocess.PIPE)
    errors = process.stderr.read()
    _, status, usage = os.wait4(process.pid, 0)
    process.returncode = os.waitstatus_to_exitcode(status)
    if process.returncode != 0:
        sys.exit(f"paired_times.py: {' '.join(command)}: {errors.decode()}")
    return usage.ru_utime + usage.ru_stime


def category_of(model):
    folder = os.path.normpath(model)
    if os.path.basename(folder) == "parts":
        folder = os.path.dirname(folder)
    return os.path.basename(os.path.dirname(folder)) or "-"


def jobs_of(models, command):
    """Arguments of the program by category."""
    by_category = {}
    for model in models:
        by_category.setdefault(category_of(model), []).append(model)
    if command == "graph":
        return {category: [["graph", model] for model in found] for category, found in by_category.items()}
    return {category: [["match", *pair] for pair in zip(found, found[1:])] for category, found in by_category.items()}


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("before")
    parser.add_argument("after")
    parser.add_argument("models", nargs="+")
    parser.add_argument("--rounds", type=int, default=3)
    parser.add_argument("--command", choices=["graph", "match"], default="graph")
    args = parser.parse_args()
    print(f"{'category':<14}{'jobs':>5}{'before s':>10}{'after s':>10}{'ratio':>8}")
    all_ratios = []
    for category, jobs in jobs_of(args.models, args.command).items():
        before, after = [], []
        for job in jobs:
            rounds = [[processor_seconds([program, *job]) for program in (args.before, args.after)]
                      for _ in range(args.rounds)]
            before.append(min(first for first, _ in rounds))
            after.append(min(second for _, second in rounds))
        ratios = [second / first for first, second in zip(before, after)]
        all_ratios += ratios
        if jobs:
            print(f"{category:<14}{len(jobs):>5}{statistics.median(before):>10.3f}{statistics.median(after):>10.3f}"
                  f"{statistics.median(ratios):>8.2f}", flush=True)
    if all_ratios:
        print(f"{'all':<14}{len(all_ratios):>5}{'':>20}{statistics.median(all_ratios):>8.2f}")


if __name__ == "__main__":
    main()

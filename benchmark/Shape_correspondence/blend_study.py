#!/usr/bin/env python3
# Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
# SPDX-License-Identifier: GPL-3.0-or-later
"""Blends pairs of shapes, draws each blend in one picture, and counts what does not hold:

  blend_study.py PROGRAM OUT --data FOLDER... [--pairs blend_pairs.txt] [--only WORD,WORD] [--cache FOLDER]
                 [--frames 9] [--options "--schedule best"] [--no-pictures]

The folders hold SHAPE/parts or CATEGORY/SHAPE/parts. Makes OUT/NN_SOURCE_TARGET.png and .json, and prints a table as Markdown:
seconds of processor time in one thread, with graphs from the cache where it has them, the schedule, and of each measure of
quality the worst of all frames, in bold where it is over the tolerance; at the end the number of blends over it.
"""
import argparse
import json
import os
import resource
import shlex
import statistics
import subprocess
import tempfile

import blend_figure


def find_model(folders, category, shape):
    for folder in folders:
        for path in (os.path.join(folder, shape), os.path.join(folder, category, shape)):
            if os.path.isdir(os.path.join(path, "parts")):
                return os.path.join(path, "parts")
    return None


def processor_seconds(command):
    def used():
        usage = resource.getrusage(resource.RUSAGE_CHILDREN)
        return usage.ru_utime + usage.ru_stime
    before = used()
    subprocess.run(command, check=True)
    return used() - before


def blend(args, source, target, name):
    """Seconds, and the blend's JSON."""
    result = os.path.join(args.out, name + ".json")
    with tempfile.TemporaryDirectory() as scratch:
        frames = os.path.join(scratch, "frames")
        command = [args.program, "blend", source, target, "-o", frames, "--frames", str(args.frames), "--json", result,
                   "--quiet", "--threads", "1", *shlex.split(args.options)]
        if args.cache:
            command += ["--cache", args.cache]
        seconds = processor_seconds(command)
        if not args.no_pictures:
            blend_figure.draw_frames(frames, os.path.join(args.out, name + ".png"))
    with open(result) as file:
        return seconds, json.load(file)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("program")
    parser.add_argument("out")
    parser.add_argument("--data", nargs="+", required=True)
    parser.add_argument("--pairs", default=os.path.join(os.path.dirname(os.path.abspath(__file__)), "blend_pairs.txt"))
    parser.add_argument("--only", default="")
    parser.add_argument("--cache", default="")
    parser.add_argument("--frames", type=int, default=9)
    parser.add_argument("--options", default="")
    parser.add_argument("--no-pictures", action="store_true")
    args = parser.parse_args()
    os.makedirs(args.out, exist_ok=True)
    wanted = list(filter(None, args.only.split(",")))
    with open(args.pairs) as file:
        pairs = [line.split() for line in file if line.strip() and not line.startswith("#")]
    measures, over, times = [], {}, []
    for number, (category, source, target) in enumerate(pairs, 1):
        name = f"{number:02}_{source}_{target}"
        models = [find_model(args.data, category, shape) for shape in (source, target)]
        if None in models or (wanted and not any(word in name for word in wanted)):
            continue
        seconds, result = blend(args, *models, name)
        times.append(seconds)
        if not measures:
            measures = list(result["tolerances"])
            over = dict.fromkeys(measures, 0)
            print("| blend | s | schedule | " + " | ".join(measures) + " |\n|---|---|---|" + "---|" * len(measures))
        cells = []
        for measure in measures:
            worst = max(frame["quality"][measure] for frame in result["frames"])
            is_over = worst > result["tolerances"][measure]
            over[measure] += is_over
            cells.append(f"**{worst:.3f}**" if is_over else f"{worst:.3f}")
        print(f"| {number} {source} → {target} | {seconds:.1f} | {result['schedules'][0]['name']} | " + " | ".join(cells) + " |",
              flush=True)
    print(f"| over the tolerance, of {len(times)} | median {statistics.median(times):.1f} | | " +
          " | ".join(str(over[measure]) for measure in measures) + " |")


if __name__ == "__main__":
    main()

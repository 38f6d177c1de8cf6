#!/usr/bin/env python3
# Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
# SPDX-License-Identifier: GPL-3.0-or-later
"""How often matches are right that a whole set of shapes confirms: scores `collection --matches` with and without `--agreeing`.

  collection_agreement.py PROGRAM LABELLED_FOLDER [--options "--roles MODEL --cache FOLDER"]

LABELLED_FOLDER has a folder for each category, with a folder for each shape: its parts and labels.json. Each category is a set. For figures
that hold for new shapes, give a role model that was learned from others, or `--roles none`. Prints a table in Markdown: precision, recall and
F1 over the ordered pairs of shapes, the mean of each category.
"""
import argparse
import json
import os
import shlex
import statistics
import subprocess
import sys
import tempfile


def labels_of(folder):
    with open(os.path.join(folder, "labels.json"), encoding="utf-8") as file:
        return {part["name"]: (part["coarse"], part.get("fine")) for part in json.load(file)["parts"]}


def right_pairs(source, target):
    """The rule of `evaluate`: parts of one role correspond, by finer labels where both shapes have them and share half of the smaller set."""
    result = set()
    for role in {coarse for coarse, _ in source.values()} & {coarse for coarse, _ in target.values()}:
        a = {name: fine for name, (coarse, fine) in source.items() if coarse == role}
        b = {name: fine for name, (coarse, fine) in target.items() if coarse == role}
        fine_a, fine_b = set(a.values()), set(b.values())
        has_fine = None not in fine_a and None not in fine_b
        is_fine = has_fine and 2 * len(fine_a & fine_b) >= min(len(fine_a), len(fine_b))
        result |= {(s, t) for s in a for t in b if not is_fine or a[s] == b[t]}
    return result


def scores(found, right):
    hits = len(found & right)
    precision = hits / len(found) if found else 0
    recall = hits / len(right) if right else 0
    return precision, recall, 2 * hits / (len(found) + len(right)) if found or right else 1


def matches_of(args, shapes, *more):
    with tempfile.TemporaryDirectory() as scratch:
        result = os.path.join(scratch, "collection.json")
        subprocess.run([args.program, "collection", *shapes, "--quiet", "--json", result, "--matches", *more, *shlex.split(args.options)],
                       check=True)
        with open(result, encoding="utf-8") as file:
            collection = json.load(file)
    folders = {shape["name"]: shape["file"] for shape in collection["shapes"]}
    return [(folders[m["source"]], folders[m["target"]], {tuple(pair) for pair in m["pairs"]}) for m in collection["matches"]]


def mean_scores(matches):
    labels = {folder: labels_of(os.path.dirname(folder) if folder.endswith("parts") else folder)
              for source, target, _ in matches for folder in (source, target)}
    rows = [scores(found, right_pairs(labels[source], labels[target])) for source, target, found in matches]
    return [statistics.mean(column) for column in zip(*rows)]


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("program")
    parser.add_argument("folder")
    parser.add_argument("--options", default="", help="further options of the program")
    args = parser.parse_args()
    print("| category | shapes | P | R | F1 | P, agreeing | R | F1 |\n|---|---|---|---|---|---|---|---|")
    table = []
    for category in sorted(os.listdir(args.folder)):
        folder = os.path.join(args.folder, category)
        shapes = sorted(os.path.join(folder, name, "parts") for name in os.listdir(folder)
                        if os.path.isfile(os.path.join(folder, name, "labels.json"))) if os.path.isdir(folder) else []
        if len(shapes) < 3:
            continue
        row = mean_scores(matches_of(args, shapes)) + mean_scores(matches_of(args, shapes, "--agreeing"))
        table.append(row)
        print(f"| {category} | {len(shapes)} | " + " | ".join(f"{value:.3f}" for value in row) + " |", flush=True)
    if not table:
        sys.exit(f"{args.folder}: no category has three shapes with parts and labels.json")
    print("| mean | | " + " | ".join(f"{statistics.mean(column):.3f}" for column in zip(*table)) + " |")


if __name__ == "__main__":
    main()

#!/usr/bin/env python3
# Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
# SPDX-License-Identifier: GPL-3.0-or-later
"""How much features of faces help matching: the table of the manual's page on learned features.

  learned_features.py PROGRAM OUT FOLDER... [--roles auto] [--pairs 12] [--weights 1,3,10] [--noise 0,.5,1,2,4,only] [--jobs 2]

FOLDERs hold labelled shapes, CATEGORY/SHAPE or SHAPE, each with labels.json and the OBJ files that it names. A face has the vector of
its part's coarse label, one of 32 orthogonal ones, plus noise of the part: a random vector of about the given length ("only": noise of
length 1 without the label). OUT keeps features, graphs and results, and a further run continues it. Prints F1, the mean over categories,
for each noise and weight, with the roles of a model (`roles train`), which should not have learned from the sources of FOLDER, and without.
--pairs: pairs of each category and folder, drawn at random but always the same.
"""
import argparse
import array
import collections
import concurrent.futures
import itertools
import json
import pathlib
import random
import struct
import subprocess

DIMENSION = 32


def shapes_in(folder):
    """The folders of labelled shapes, by category."""
    found = collections.defaultdict(list)
    for file in sorted(pathlib.Path(folder).rglob("labels.json")):
        found[json.loads(file.read_text())["category"]].append(file.parent)
    return found


def write_npy(path, rows):
    header = "{'descr': '<f4', 'fortran_order': False, 'shape': (%d, %d), }" % (len(rows), DIMENSION)
    header = (header + " " * (-(len(header) + 11) % 64) + "\n").encode()
    path.parent.mkdir(parents=True, exist_ok=True)
    path.write_bytes(b"\x93NUMPY\x01\x00" + struct.pack("<H", len(header)) + header
                     + b"".join(array.array("f", row).tobytes() for row in rows))


def features_of(shape, labels, noise):
    """A row for each face of the files of the folder `parts`, sorted by name. \\param labels the columns of labels"""
    parts = {pathlib.Path(part["file"]).name: part for part in json.loads((shape / "labels.json").read_text())["parts"]}
    rows = []
    for file in sorted((shape / "parts").iterdir()):
        random_numbers = random.Random(f"{shape.name}/{file.name}/{noise}")
        length = 1 if noise == "only" else float(noise)
        row = [random_numbers.gauss(0, length / DIMENSION ** .5) for _ in range(DIMENSION)]
        if noise != "only":
            row[labels[parts[file.name]["coarse"]]] += 1
        faces = sum(line.startswith("f ") for line in file.read_text().splitlines())
        rows += [row] * faces
    return rows


def pairs_of(folder, most):
    for category, shapes in shapes_in(folder).items():
        pairs = list(itertools.combinations(shapes, 2))
        yield category, random.Random(category).sample(pairs, min(most, len(pairs)))


def match(args, work):
    result, pair, options = work
    if not result.exists():
        result.parent.mkdir(parents=True, exist_ok=True)
        subprocess.run([args.program, "match", pair[0] / "parts", pair[1] / "parts", "--quiet", "--cache", args.out / "cache",
                        "--json", result, *options], check=True, stderr=subprocess.DEVNULL)


def f1(args, results):
    """The mean over categories."""
    truth = itertools.chain.from_iterable(("--ground-truth", folder) for folder in args.folders)
    text = subprocess.run([args.program, "evaluate", results, *truth, "--json", "-"], check=True, capture_output=True).stdout
    return json.loads(text)["mean"]["f1"]


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("program")
    parser.add_argument("out", type=pathlib.Path)
    parser.add_argument("folders", nargs="+")
    parser.add_argument("--pairs", type=int, default=12)
    parser.add_argument("--roles", default="auto")
    parser.add_argument("--weights", default="1,3,10")
    parser.add_argument("--noise", default="0,.5,1,2,4,only")
    parser.add_argument("--jobs", type=int, default=2)
    args = parser.parse_args()
    roles, levels = {"roles": args.roles, "geometry": "none"}, args.noise.split(",")
    settings = [(noise, weight) for noise in levels for weight in args.weights.split(",")]
    work, count = [], 0
    for number, folder in enumerate(args.folders):
        for category, pairs in pairs_of(folder, args.pairs):
            count += len(pairs)
            names = {part["coarse"] for shape in itertools.chain(*pairs)
                     for part in json.loads((shape / "labels.json").read_text())["parts"]}
            labels = {name: column for column, name in enumerate(sorted(names))}
            files = {}
            for shape, noise in itertools.product(sorted(set(itertools.chain(*pairs))), levels):
                files[shape, noise] = args.out / "features" / noise / str(number) / category / (shape.name + ".npy")
                if not files[shape, noise].exists():
                    write_npy(files[shape, noise], features_of(shape, labels, noise))
            for pair, model in itertools.product(pairs, roles):
                name = f"{number}_{category}_{pair[0].name}--{pair[1].name}.json"
                work.append((args.out / "without" / model / name, pair, ["--roles", roles[model]]))
                for noise, weight in settings:
                    work.append((args.out / f"{noise}_{weight}" / model / name, pair,
                                 ["--roles", roles[model], "--source-features", files[pair[0], noise], "--target-features",
                                  files[pair[1], noise], "--feature-weight", weight]))
    with concurrent.futures.ThreadPoolExecutor(args.jobs) as pool:
        list(pool.map(lambda one: match(args, one), work))
    print(f"{count} pairs\n\n| noise | weight | F1 with roles | by geometry |\n|---|---|---|---|")
    for noise, weight in [("no features", "")] + settings:
        results = args.out / (f"{noise}_{weight}" if weight else "without")
        print(f"| {noise} | {weight} |", *(f"{f1(args, results / model):.3f} |" for model in roles))


if __name__ == "__main__":
    main()

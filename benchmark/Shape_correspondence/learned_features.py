#!/usr/bin/env python3
# Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
# SPDX-License-Identifier: GPL-3.0-or-later
"""Measures how much features of faces improve matching: the table of the manual's page on learned features.

  PYTHONPATH=BUILD/python learned_features.py OUT FOLDER... [--roles MODEL] [--pairs 12] [--weights 1,3,10] [--noise 0,.5,1,2,4,only]

FOLDERs hold labelled shapes, CATEGORY/SHAPE or SHAPE, each with labels.json and the OBJ files that it names. A face has the vector of
its part's coarse label, one of 32 orthogonal ones, plus noise of the part: a random vector of about the given length ("only": noise of
length 1 without the label). OUT keeps graphs and results, and a further run continues it. Prints F1, the mean over categories, for each
noise and weight, with the roles of a model, which should not have learned from the sources of FOLDER, and without. --pairs: pairs of each
category and folder, drawn at random but always the same.
"""
import argparse
import collections
import functools
import itertools
import json
import pathlib
import random

import numpy as np
import shape_correspondence as sc

DIMENSION = 32


def shapes_in(folder):
    """The folders of labelled shapes, by category."""
    found = collections.defaultdict(list)
    for file in sorted(pathlib.Path(folder).rglob("labels.json")):
        found[json.loads(file.read_text())["category"]].append(file.parent)
    return found


def pairs_of(folder, most):
    for category, shapes in shapes_in(folder).items():
        pairs = list(itertools.combinations(shapes, 2))
        yield category, random.Random(category).sample(pairs, min(most, len(pairs)))


def coarse_labels(shape):
    """Coarse labels by name of the file in the folder `parts`."""
    return {pathlib.Path(part["file"]).name: part["coarse"] for part in json.loads((shape / "labels.json").read_text())["parts"]}


def features_of(shape, labels, noise):
    """A row for each face of the files of the folder `parts`, sorted by name. \\param labels column of each coarse label"""
    of_parts = coarse_labels(shape)
    rows = []
    for file in sorted((shape / "parts").iterdir()):
        random_numbers = random.Random(f"{shape.name}/{file.name}/{noise}")
        length = 1 if noise == "only" else float(noise)
        row = [random_numbers.gauss(0, length / DIMENSION ** .5) for _ in range(DIMENSION)]
        if noise != "only":
            row[labels[of_parts[file.name]]] += 1
        rows += [row] * sum(line.startswith("f ") for line in file.read_text().splitlines())
    return np.array(rows, np.float32)


def match_pair(args, pair, labels, settings, roles, name):
    """Writes the matches with all settings, and without features."""
    @functools.lru_cache(None)
    def graph(shape, noise):
        features = None if noise is None else features_of(shape, labels, noise)
        return sc.build_graph(shape / "parts", features=features, cache=args.out / "cache")

    for model, (noise, weight) in itertools.product(roles, [(None, "0"), *settings]):
        result = folder_of(args, model, noise, weight) / name
        if not result.exists():
            result.parent.mkdir(parents=True, exist_ok=True)
            sc.match(*(graph(shape, noise) for shape in pair), roles=roles[model], feature_weight=float(weight)).save(result)


def folder_of(args, model, noise, weight):
    return args.out / ("without" if noise is None else f"{noise}_{weight}") / model


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("out", type=pathlib.Path)
    parser.add_argument("folders", nargs="+")
    parser.add_argument("--roles", default="auto")
    parser.add_argument("--pairs", type=int, default=12)
    parser.add_argument("--weights", default="1,3,10")
    parser.add_argument("--noise", default="0,.5,1,2,4,only")
    args = parser.parse_args()
    settings = list(itertools.product(args.noise.split(","), args.weights.split(",")))
    roles = {"roles": "auto" if args.roles == "auto" else sc.roles.load(args.roles), "geometry": None}
    count = 0
    for number, folder in enumerate(args.folders):
        for category, pairs in pairs_of(folder, args.pairs):
            names = sorted({label for shape in itertools.chain(*pairs) for label in coarse_labels(shape).values()})
            labels = {name: column for column, name in enumerate(names)}
            for pair in pairs:
                match_pair(args, pair, labels, settings, roles, f"{number}_{category}_{pair[0].name}--{pair[1].name}.json")
            count += len(pairs)
    print(f"{count} pairs\n\n| noise | weight | F1 with roles | by geometry |\n|---|---|---|---|")
    for noise, weight in [(None, ""), *settings]:
        f1 = (sc.evaluate(folder_of(args, model, noise, weight), args.folders).mean.f1 for model in roles)
        print(f"| {noise or 'no features'} | {weight} |", *(f"{value:.3f} |" for value in f1))


if __name__ == "__main__":
    main()

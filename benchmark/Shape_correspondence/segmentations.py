#!/usr/bin/env python3
# Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
# SPDX-License-Identifier: GPL-3.0-or-later
"""The paper's Figures 17 to 19 on labelled shapes whose files do not say what their parts are.

  PYTHONPATH=BUILD/python segmentations.py BUILD OUT FOLDER... --roles MODEL [--pairs 12] [--jobs 2]

FOLDERs are as learned_features.py takes them. Every shape is written as one object and divided in four ways: as the labels say; into
its loose pieces; into segments where it is concave; into parts as the commands find them by the tree. In the first table, the source
has its labelled parts, as in the paper's Figure 17; in the second one, both shapes are divided alike. A pair of labelled parts counts as
found if a pair of what they were divided into carries it: each piece stands for the labelled part that has most of its area, and each
labelled part also for the piece that has most of it. A shape that is refused has no pairs. MODEL knows roles and what parts look like
(`roles train`, then `train_parts`), and should not have learned from the sources of FOLDER. Then, as in Figure 19, energies and F1 of the
paper's method, for pairs of shapes that no way divides into more than 60 parts, and F1 where the division of least energy is taken.
OUT keeps all files; a further run continues it.
"""
import argparse
import concurrent.futures
import itertools
import json
import pathlib
import statistics
import subprocess

from learned_features import pairs_of

FOUND = "found by the tree"
WAYS = {"as labelled": None, "loose pieces": "components", "segments": "segments", FOUND: "auto"}
RUNS = ("target", "roles"), ("target", "geometry"), ("both", "roles"), ("both", "geometry"), ("target", "paper")
MOST_PARTS = 60  # largest number of parts of shapes that the paper's method matches


class Divided_shape:
    """A labelled shape as one object, and its divisions into parts."""

    def __init__(self, folder, out):
        self.folder, self.out = folder, out
        self.model = out / "shape.obj"
        if self.model.exists():
            return
        lines, begin, count = ["o shape"], 0, 0
        for file in sorted((folder / "parts").iterdir()):
            for words in map(str.split, file.read_text().splitlines()):
                if words[:1] == ["v"]:
                    lines.append(" ".join(words))
                    count += 1
                elif words[:1] == ["f"]:
                    lines.append("f " + " ".join(str(int(word.split("/")[0]) + begin) for word in words[1:]))
            begin = count
        out.mkdir(parents=True, exist_ok=True)
        self.model.write_text("\n".join(lines) + "\n")

    def divide(self, args, way):
        """Writes the graph of the shape that is divided in this way, unless it is refused."""
        parts, made = self.out / f"{way}.txt", self.out / f"{way}.obj"
        if parts.exists():
            return
        labelled = self.folder / "parts"
        mode = ["--parts", WAYS[way]] if WAYS[way] else ["--parts", "file"]
        of_roles = ["--roles", args.roles] if way == FOUND else []
        done = subprocess.run([args.build / "benchmark" / "Shape_correspondence" / "benchmark_parts", *mode, *of_roles, "--obj", made,
                               self.model if WAYS[way] else labelled, labelled], capture_output=True, text=True)
        if made.exists():
            graph = ["graph", made, "--up", "y", "--parts", "file", "--quiet", "-o", self.graph(way)]
            subprocess.run([args.build / "shape_correspondence", *graph], stderr=subprocess.DEVNULL)
        parts.write_text(done.stdout)

    def graph(self, way):
        return self.out / f"{way}.json"

    def size(self, way):
        """The number of parts; 0 if the shape is refused."""
        return len(json.loads((self.out / f"{way}.txt").read_text())["parts"]) if self.graph(way).exists() else 0

    def owners(self, way):
        """For each found part, the labelled part that has most of its area; for each labelled part, the found part that has most of its area."""
        made = json.loads((self.out / f"{way}.txt").read_text())
        shared = {(found, part): points for part, row in zip(made["labelled_parts"], made["common_points"])
                  for found, points in zip(made["parts"], row) if points > 0}
        ordered = sorted(shared, key=shared.get)
        return dict(ordered), {part: found for found, part in ordered}


def carried(pairs, source, target):
    """The pairs of labelled parts that pairs of found parts carry. \\param source, target see owners()"""
    found = {tuple(pair) for pair in pairs}
    result = {(source[0][a], target[0][b]) for a, b in found if a in source[0] and b in target[0]}
    return sorted(result | {(a, b) for a, b in itertools.product(source[1], target[1]) if (source[1][a], target[1][b]) in found})


def match(args, work):
    """Writes the pairs of labelled parts that are found, and the energy."""
    result, method, shapes, ways = work
    if result.exists():
        return
    result.parent.mkdir(parents=True, exist_ok=True)
    raw = result.with_suffix(".raw")
    graphs = [shape.graph(way) for shape, way in zip(shapes, ways)]
    document = {"format": "shape_correspondence/match", "version": 1, "complete": True, "pairs": [], "energy": None}
    if all(graph.exists() for graph in graphs):
        options = {"roles": ["--roles", args.roles], "geometry": ["--roles", "none"], "paper": ["--paper"]}[method]
        subprocess.run([args.build / "shape_correspondence", "match", *graphs, "--quiet", "--json", raw, *options], check=True, stderr=subprocess.DEVNULL)
        found = json.loads(raw.read_text())
        raw.unlink()
        document["pairs"] = carried(found["pairs"], *(shape.owners(way) for shape, way in zip(shapes, ways)))
        document["complete"] = found["complete"]
        document["energy"] = found["energy"] / max(1, len(found["contacts"]))
    document["source"], document["target"] = (str(shape.folder / "parts") for shape in shapes)
    result.write_text(json.dumps(document))


def scores(args, folder):
    truth = itertools.chain.from_iterable(("--ground-truth", folder) for folder in args.folders)
    text = subprocess.run([args.build / "shape_correspondence", "evaluate", folder, *truth, "--json", "-"], check=True, capture_output=True).stdout
    return json.loads(text)


def ranks(values):
    order = sorted(range(len(values)), key=values.__getitem__)
    return [order.index(i) for i in range(len(values))]


def write_energies(folders, f1):
    """Prints the tables of Figure 19. \\param f1 F1 by way of dividing and file of the result"""
    energies = {way: {file.name: json.loads(file.read_text())["energy"] for file in folder.iterdir()} for way, folder in folders.items()}
    names = [name for name in f1["as labelled"] if all(of_way[name] is not None for of_way in energies.values())]
    mean = lambda of_pair: f"{statistics.mean(map(of_pair, names)):.3f}"
    print(f"\nEnergies for each contact and F1 of the paper's method, {len(names)} pairs of at most {MOST_PARTS} parts:\n\n| target | energy | F1 |\n|---|---|---|")
    for way in WAYS:
        print(f"| {way} | {mean(energies[way].get)} | {mean(f1[way].get)} |")
    best = lambda ways, measure: lambda name: f1[measure(ways, key=lambda way: energies[way][name])][name]
    ways = list(WAYS)[1:]
    print(f"| of the three that are made: the least energy | | {mean(best(ways, min))} |")
    print(f"| of the three: the greatest F1 | | {mean(lambda name: max(f1[way][name] for way in ways))} |")
    x, y = (ranks([values[way][name] for way in WAYS for name in names]) for values in (energies, f1))
    print(f"\nRank correlation of energy and F1: {statistics.correlation(x, y):.2f}")


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("build", type=pathlib.Path)
    parser.add_argument("out", type=pathlib.Path)
    parser.add_argument("folders", nargs="+")
    parser.add_argument("--roles", required=True)
    parser.add_argument("--pairs", type=int, default=12)
    parser.add_argument("--jobs", type=int, default=2)
    args = parser.parse_args()
    pairs = [(category, pair) for folder in args.folders for category, of_category in pairs_of(folder, args.pairs) for pair in of_category]
    shapes = {folder: Divided_shape(folder, args.out / "shapes" / folder.parent.name / folder.name)
              for folder in sorted(set(itertools.chain.from_iterable(pair for _, pair in pairs)))}
    with concurrent.futures.ThreadPoolExecutor(args.jobs) as pool:
        list(pool.map(lambda one: one[0].divide(args, one[1]), itertools.product(shapes.values(), WAYS)))
        small = {folder for folder, shape in shapes.items() if max(map(shape.size, WAYS)) <= MOST_PARTS}
        work, folders = [], {}
        for (side, method), way in itertools.product(RUNS, WAYS):
            folders[side, method, way] = args.out / "results" / side / method / way
            for category, pair in pairs:
                if method != "paper" or small.issuperset(pair):
                    result = folders[side, method, way] / f"{category}_{pair[0].name}--{pair[1].name}.json"
                    ways = ["as labelled" if side == "target" else way, way]
                    work.append((result, method, [shapes[folder] for folder in pair], ways))
        list(pool.map(lambda one: match(args, one), work))
    print(f"{len(pairs)} pairs of {len(shapes)} shapes\n\n| division | found / labelled parts | refused | "
          + " | ".join(f"{side}, {method}" for side, method in RUNS[:-1]) + " |\n|---" + "|---" * (1 + len(RUNS)) + "|")
    f1 = {key: scores(args, folder) for key, folder in folders.items() if folder.exists()}
    for way in WAYS:
        made = [shape for shape in shapes.values() if shape.size(way) > 0]
        ratio = statistics.mean(shape.size(way) / shape.size("as labelled") for shape in made)
        cells = [f"{f1[side, method, way]['mean']['f1']:.3f}" for side, method in RUNS[:-1]]
        print(f"| {way} | {ratio:.2f} | {len(shapes) - len(made)} | {' | '.join(cells)} |")
    if ("target", "paper", FOUND) not in f1:
        return
    of_paper = {way: {pathlib.Path(entry["file"]).name: entry["f1"] for entry in f1["target", "paper", way]["results"]} for way in WAYS}
    write_energies({way: folders["target", "paper", way] for way in WAYS}, of_paper)


if __name__ == "__main__":
    main()

#!/usr/bin/env python3
# Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
# SPDX-License-Identifier: GPL-3.0-or-later
"""Labels the Princeton Segmentation Benchmark by matching, and compares its segments with human ones.

  PYTHONPATH=BUILD/python psb.py FOLDER [--only Chair,Table] [--skip given,raw] [--parts segments] [--cache FOLDER] [--json FILE]

FOLDER has CATEGORY/N.off, one mesh each, and CATEGORY/N_labels.txt: a line with a label, then one with the numbers of its faces, from 1
(Kalogerakis et al. 2010). Given segments are the connected faces of one label; specks of less than .5 % of the area join their
neighbours; their upright axis is that of the raw mesh, as every command estimates it. --parts says how raw meshes are divided, as of `match`.
Examples always have given segments.

Prints a table as Markdown. label transfer: share of the area that gets its label from 1, 3 or 12 examples, each of which votes with its
probability; means over all ordered pairs, or over DRAWS sets of examples for each shape, then over shapes. A raw mesh that is refused
counts as 0. Rand error: share of the pairs of faces that only one of both segmentations has in one segment; the whole mesh, where it is
refused.
"""
import argparse
import collections
import json
import os
import random
import statistics
import tempfile

import numpy as np
import shape_correspondence as sc

EXAMPLES = (1, 3, 12)
DRAWS = 10
SPECK = 0.005  # least share of the area of a given segment


def read_off(path):
    """Vertices and triangles."""
    with open(path) as file:
        words = file.read().split()
    vertices, faces = int(words[1]), int(words[2])
    begin = 4 + 3 * vertices
    points = np.array(words[4:begin], float).reshape(-1, 3)
    return points, np.array(words[begin:begin + 4 * faces], int).reshape(-1, 4)[:, 1:]


def read_labels(path, faces):
    """The label of every face."""
    labels = np.full(faces, "", dtype=object)
    with open(path) as file:
        lines = file.read().splitlines()
    for label, numbers in zip(lines[::2], lines[1::2]):
        labels[np.array(numbers.split(), int) - 1] = label
    return labels


def areas_of(points, faces):
    a, b, c = (points[faces[:, k]] for k in range(3))
    return np.linalg.norm(np.cross(b - a, c - a), axis=1) / 2


def neighbours_of(faces):
    """The pairs of faces with a common edge."""
    by_edge = collections.defaultdict(list)
    for face, corners in enumerate(faces.tolist()):
        for k in range(3):
            by_edge[tuple(sorted((corners[k], corners[k - 1])))].append(face)
    return [(a, b) for around in by_edge.values() for a in around for b in around if a < b]


def components(count, pairs):
    """The number of the connected component of each of `count` nodes. \\param pairs edges"""
    parent = list(range(count))

    def root(i):
        while parent[i] != i:
            parent[i] = i = parent[parent[i]]
        return i
    for a, b in pairs:
        parent[root(a)] = root(b)
    return np.unique([root(i) for i in range(count)], return_inverse=True)[1]


def given_segments(faces, areas, labels):
    """The segment of every face: connected faces of one label, without specks."""
    pairs = neighbours_of(faces)
    while True:
        segments = components(len(faces), [(a, b) for a, b in pairs if labels[a] == labels[b]])
        sizes = np.bincount(segments, areas)
        specks = [s for s in np.argsort(sizes) if sizes[s] < SPECK * areas.sum()]
        for speck in specks:
            around = collections.Counter(labels[b if segments[a] == speck else a] for a, b in pairs
                                         if (segments[a] == speck) != (segments[b] == speck))
            if around:
                labels[segments == speck] = around.most_common(1)[0][0]
                break
        else:
            return segments


def rand_error(a, b):
    """The share of the pairs of faces that only one of both segmentations has in one segment."""
    pairs_in = lambda numbers: (np.bincount(numbers).astype(float) ** 2).sum()
    both = pairs_in(np.unique(a * (b.max() + 1) + b, return_inverse=True)[1])
    return (pairs_in(a) + pairs_in(b) - 2 * both) / (len(a) * (len(a) - 1.0))


class Labelled_mesh:
    def __init__(self, folder, name, parts, cache):
        self.name, self.file = name, os.path.join(folder, name + ".off")
        self.points, self.faces = read_off(self.file)
        self.areas = areas_of(self.points, self.faces)
        self.labels = read_labels(os.path.join(folder, name + "_labels.txt"), len(self.faces))
        labels = self.labels.copy()
        self.people = given_segments(self.faces, self.areas, labels)
        self.faces_of = {"given": {str(s): np.flatnonzero(self.people == s) for s in range(self.people.max() + 1)}, "raw": {}}
        self.label_of_segment = {name: labels[faces[0]] for name, faces in self.faces_of["given"].items()}
        self.segments = np.zeros(len(self.faces), int)
        self.graphs = {}
        face_of = {self.key(self.points[corners]): i for i, corners in enumerate(self.faces)}
        try:
            self.graphs["raw"] = sc.build_graph(self.file, parts=parts, cache=cache)
            self.shape = self.graphs["raw"].shape
        except sc.InvalidInput:
            self.shape = sc.read(self.file, parts="file")
        for number, part in enumerate(self.shape.parts):
            found = [face_of.get(self.key(part.vertices[corners])) for corners in part.faces]
            self.faces_of["raw"][part.name] = np.array([face for face in found if face is not None], int)
            self.segments[self.faces_of["raw"][part.name]] = number
        self.refused = "raw" not in self.graphs

    def build_given(self, cache):
        with tempfile.TemporaryDirectory() as folder:
            file = os.path.join(folder, self.name + ".obj")
            sc.Shape.from_segmentation(self.points, self.faces, self.people, self.name, self.shape.up).save(file)
            self.graphs["given"] = sc.build_graph(file, parts="file", cache=cache)

    @staticmethod
    def key(corners):
        return tuple(sorted(map(tuple, np.float32(corners).tolist())))

    def example(self):
        return sc.roles.LabelledShape(self.graphs["given"], "shape", self.label_of_segment)

    def right(self, faces_of_part, votes):
        """The share of the area whose label has most votes."""
        area = 0
        for part, faces in faces_of_part.items():
            if votes[part]:
                label = max(sorted(votes[part]), key=votes[part].get)
                area += self.areas[faces][self.labels[faces] == label].sum()
        return area / self.areas.sum()


def transfer_scores(meshes, kind):
    """By number of examples, the mean share of the area with the right label."""
    targets = [mesh for mesh in meshes if kind in mesh.graphs]
    labels = {}  # by example and target
    for source in meshes:
        found = sc.transfer_labels(source.example(), [mesh.graphs[kind] for mesh in targets])
        labels.update({(source.name, mesh.name): roles.parts for mesh, roles in zip(targets, found)})
    result = {}
    for count in EXAMPLES:
        scores = [0.] * (len(meshes) - len(targets))
        for target in targets:
            draw = random.Random(target.name)
            others = [mesh.name for mesh in meshes if mesh is not target]
            sets = [[other] for other in others] if count == 1 else [draw.sample(others, count) for _ in range(DRAWS)]
            shares = []
            for examples in sets:
                votes = collections.defaultdict(lambda: collections.defaultdict(float))
                for example in examples:
                    for part in labels[example, target.name]:
                        votes[part.name][part.coarse] += part.probability or 0
                shares.append(target.right(target.faces_of[kind], votes))
            scores.append(statistics.mean(shares))
        result[count] = statistics.mean(scores)
    return result


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("folder")
    parser.add_argument("--only", default="")
    parser.add_argument("--skip", default="")
    parser.add_argument("--parts", default="segments")
    parser.add_argument("--cache")
    parser.add_argument("--json")
    args = parser.parse_args()
    only, skip = set(filter(None, args.only.split(","))), set(args.skip.split(","))
    kinds = [kind for kind in ("given", "raw") if kind not in skip]
    head = [f"{kind}, {count}" for kind in kinds for count in EXAMPLES] + ["Rand error", "refused"]
    print("| category | " + " | ".join(head) + " |\n" + "|---" * (1 + len(head)) + "|")
    document = []
    for category in sorted(os.listdir(args.folder)):
        folder = os.path.join(args.folder, category)
        if not os.path.isdir(folder) or (only and category not in only):
            continue
        names = sorted(name[:-4] for name in os.listdir(folder) if name.endswith(".off"))
        if not names:
            continue
        meshes = [Labelled_mesh(folder, name, args.parts, args.cache) for name in names]
        if kinds:
            for mesh in meshes:
                mesh.build_given(args.cache)
        scores = {kind: transfer_scores(meshes, kind) for kind in kinds}
        rand = [rand_error(mesh.people, mesh.segments) for mesh in meshes]
        refused = [mesh.name for mesh in meshes if mesh.refused]
        document.append({"category": category, "label_transfer": scores, "rand_error": dict(zip(names, rand)), "refused": refused})
        cells = [f"{scores[kind][count]:.3f}" for kind in kinds for count in EXAMPLES]
        print(f"| {category} | " + " | ".join(cells + [f"{statistics.mean(rand):.3f}", str(len(refused))]) + " |", flush=True)
    if args.json:
        with open(args.json, "w") as file:
            json.dump(document, file, indent=1)


if __name__ == "__main__":
    main()

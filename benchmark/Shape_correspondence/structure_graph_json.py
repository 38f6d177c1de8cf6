#!/usr/bin/env python3
# Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
# SPDX-License-Identifier: GPL-3.0-or-later
"""Makes a structural graph in JSON, which the program reads, of a structure graph in the XML of the paper's authors.

  structure_graph_json.py GRAPH.xml GRAPH.json [--up x|y|z]

A `document` has `node`s: an `id`, a `type` (CURVE or SHEET), of a sheet `controls` with two counts `c`, the control `point`s of a cubic
B-spline with clamped uniform knots, and their `weights`; `edge`s: two nodes `n`, and for each a `coord` of parameters `uv`, one for each
contact region; and `group`s of nodes `n`. Splines are sampled. Without `coord`s, a contact is where samples are nearest. Two nodes of a group
are mirror images, more are a row if their steps are equal; if a group is neither, the program detects all groups. Meshes are not read.
"""
import argparse
import json
import math
import sys
import xml.etree.ElementTree

CURVE_SAMPLES, SIDE_SAMPLES = 33, 9  # numbers of samples of a curve, and along each side of a sheet
EQUAL = 0.05  # largest distance of a member of a row from its place, over the step


def refuse(element, what):
    sys.exit(f"structure_graph_json.py: {element.tag} {(element.findtext('id') or '').strip()!r} {what}")


def texts(element, tag):
    return [(child.text or "").strip() for child in element.findall(tag)]


def numbers(element, text):
    try:
        values = [float(word) for word in text.split()]
    except ValueError:
        values = [math.nan]
    if not all(map(math.isfinite, values)):
        refuse(element, f"has {text!r}, which are not numbers")
    return values


def basis(count, t):
    """The values at t of a B-spline basis with clamped uniform knots, cubic if there are points enough (Cox, de Boor)."""
    degree = min(3, count - 1)
    inner = count - degree
    knot = [min(1, max(0, (i - degree) / inner)) for i in range(count + degree + 1)]
    values = [0.0] * (count + degree + 1)
    values[degree + min(inner - 1, int(t * inner))] = 1
    for k in range(1, degree + 1):
        for i in range(count + degree - k):
            left, right = knot[i + k] - knot[i], knot[i + k + 1] - knot[i + 1]
            values[i] = ((t - knot[i]) / left * values[i] if left else 0) + ((knot[i + k + 1] - t) / right * values[i + 1] if right else 0)
    return values[:count]


class Part:
    def __init__(self, node):
        self.name = next(iter(texts(node, "id")), "") or refuse(node, "has no <id>")
        kind = next(iter(texts(node, "type")), "").upper()
        if kind not in ("CURVE", "SHEET"):
            refuse(node, f"has the <type> {kind!r}, which is none of CURVE, SHEET")
        self.is_sheet = kind == "SHEET"
        points = [numbers(node, text) for text in texts(node, "point")]
        counts = [int(count) for text in texts(node.find("controls"), "c") for count in numbers(node, text)] if self.is_sheet else [len(points), 1]
        if any(len(point) != 3 for point in points) or len(counts) != 2 or counts[0] * counts[1] != len(points) or counts[0] < 2:
            refuse(node, "does not have the <point>s, of three numbers each, that its <controls> say")
        weights = [w for text in texts(node, "weights") for w in numbers(node, text)] or [1.0] * len(points)
        if len(weights) != len(points) or min(weights) <= 0:
            refuse(node, "does not have as many <weights> as points, above 0")
        rows, columns = (SIDE_SAMPLES, SIDE_SAMPLES) if self.is_sheet else (CURVE_SAMPLES, 1)
        self.samples = {}  # points by parameters (u, v)
        for u in (i / (rows - 1) for i in range(rows)):
            for v in (j / max(1, columns - 1) for j in range(columns)):
                share = [a * b * w for (a, b), w in zip(((a, b) for a in basis(counts[0], u) for b in basis(counts[1], v)), weights)]
                self.samples[u, v] = [sum(s * p[k] for s, p in zip(share, points)) / sum(share) for k in range(3)]

    def to_json(self):
        points = list(self.samples.values())
        if not self.is_sheet:
            return {"name": self.name, "type": "curve", "points": points}
        return {"name": self.name, "type": "sheet", "grid": [points[i:i + SIDE_SAMPLES] for i in range(0, len(points), SIDE_SAMPLES)]}

    def parameter(self, uv):
        u, v = (min(1.0, max(0.0, x)) for x in uv[:2])
        return [u, v] if self.is_sheet else [u]

    def middle(self):
        return [sum(column) / len(self.samples) for column in zip(*self.samples.values())]


def members(element, parts):
    names = texts(element, "n")
    for name in names:
        if name not in parts:
            refuse(element, f"names the node {name!r}, which does not exist")
    return [parts[name] for name in names]


def contacts(edge, parts):
    ends = members(edge, parts)
    if len(ends) != 2 or ends[0] is ends[1]:
        refuse(edge, "does not join two nodes")
    places = [[numbers(edge, text) for text in texts(coord, "uv")] for coord in edge.findall("coord")[:2]]
    if len(places) < 2:
        near = min(((math.dist(p, q), a, b) for a, p in ends[0].samples.items() for b, q in ends[1].samples.items()))
        places = [[near[1]], [near[2]]]
    names = [part.name for part in ends]
    return [{"parts": names, "parameters": [part.parameter(uv) for part, uv in zip(ends, both)]} for both in zip(*places)]


def group(parts):
    """A group of two or more parts; None if they are neither mirror images nor a row."""
    middles = [part.middle() for part in parts]
    first, last = middles[0], middles[-1]
    result = {"parts": [part.name for part in parts], "symmetry": "self"}
    if len(parts) == 2 and first != last:
        return {**result, "symmetry": "reflection", "plane": {"point": [(a + b) / 2 for a, b in zip(first, last)],
                                                              "normal": [(a - b) / math.dist(first, last) for a, b in zip(first, last)]}}
    if len(parts) > 1:
        step = [(b - a) / (len(parts) - 1) for a, b in zip(first, last)]
        off = max(math.dist(m, [a + i * s for a, s in zip(first, step)]) for i, m in enumerate(middles))
        return {**result, "symmetry": "translation", "vector": step} if off < EQUAL * math.hypot(*step) else None
    return result


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("source")
    parser.add_argument("output")
    parser.add_argument("--up", choices=["x", "y", "z"], default="z")
    args = parser.parse_args()
    document = xml.etree.ElementTree.parse(args.source).getroot()
    parts = {part.name: part for part in map(Part, document.findall("node"))}
    if len(parts) < 2 or len(parts) < len(document.findall("node")):
        sys.exit(f"structure_graph_json.py: {args.source}: it has fewer than two nodes, or two of one <id>")
    result = {"format": "shape_correspondence/graph", "version": 1, "name": args.source, "up": [float(axis == args.up) for axis in "xyz"],
              "parts": [part.to_json() for part in parts.values()]}
    groups = [group(members(element, parts)) for element in document.findall("group")]
    if groups and None not in groups:
        result["groups"] = groups
    found = [contact for edge in document.findall("edge") for contact in contacts(edge, parts)]
    if found:
        result["contacts"] = found
    with open(args.output, "w", encoding="utf-8") as file:
        json.dump(result, file)


if __name__ == "__main__":
    main()

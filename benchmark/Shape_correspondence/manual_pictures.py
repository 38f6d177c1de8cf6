#!/usr/bin/env python3
# Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
# SPDX-License-Identifier: GPL-3.0-or-later
"""Makes the pictures of the manual from models of data/ and generated ones.

  manual_pictures.py PROGRAM GENERATOR DATA OUT [--browser chromium] [--only NAME,NAME]

GENERATOR is generate_models. Makes OUT/NAME.webp, .svg or .png: the figures of the manual, the shapes of the tutorials, and the gallery. Shapes are drawn by three.js in Chromium; `graph` and
`page` are screenshots of pages. readme_animation.py makes the picture of README.md, python/blender/test_addon.py that of the add-on.
"""
import argparse
import json
import math
import os
import shutil
import struct
import subprocess
import sys
import tempfile

from picture import GREY, THREE, Picture, colours_of_match, colours_of_roles, draw_blend, numbered_colour, read_model, screenshot

DEMO = "chair_four_legged", "chair_swivel"
PLANES = "airplane_propeller", "airplane_twin_engine"
CHAIRS = ["chair_four_legged", "chair_slatted", "chair_spindle", "chair_swivel", "stool"]
# Generated shapes of different topology; the first pair is the main example of the paper
GALLERY = [("velocipede", "1", "10"), ("airplane", "1", "13"), ("chair", "11", "2"), ("lamp", "1", "5"), ("table", "13", "15"), ("bed", "2", "3"),
           ("boat", "dinghy", "yawl"), ("cart", "handcart", "wagon")]
SKIPPED = 77
WIDTH, HEIGHT = 1000, 520  # of the window of a screenshot, which has two pixels for each of these


def line(a, b, colour, width):
    return f'<line x1="{a[0]:.0f}" y1="{a[1]:.0f}" x2="{b[0]:.0f}" y2="{b[1]:.0f}" stroke="{colour}" stroke-width="{width}" stroke-linecap="round"/>'


def sheet(grid):
    """The triangles of a grid of points."""
    corners = [[grid[i + k][j + m] for k, m in ((0, 0), (0, 1), (1, 1), (1, 0))] for i in range(len(grid) - 1) for j in range(len(grid[0]) - 1)]
    return [[a, b, c] for quad in corners for a, b, c in (quad[:3], quad[2:] + quad[:1])]


def box(low, high):
    """The triangles of a box."""
    corner = [[(low, high)[i >> k & 1][k] for k in range(3)] for i in range(8)]
    quads = (0, 2, 6, 4), (1, 5, 7, 3), (0, 4, 5, 1), (2, 3, 7, 6), (0, 1, 3, 2), (4, 6, 7, 5)
    return [[corner[i] for i in quad] for a, b, c, d in quads for quad in ((a, b, c), (a, c, d))]


def divided(triangle, longest):
    """The triangles made by bisecting the longest edge until no edge is longer than `longest`."""
    edges = [math.dist(triangle[i], triangle[(i + 1) % 3]) for i in range(3)]
    i = edges.index(max(edges))
    if edges[i] <= longest:
        return [triangle]
    a, b, c = (triangle[(i + k) % 3] for k in range(3))
    middle = [(p + q) / 2 for p, q in zip(a, b)]
    return divided([a, middle, c], longest) + divided([middle, b, c], longest)


def read_coloured_ply(file):
    """[(colour, triangles)] of a binary PLY file of the program, where triangles have the mean colours of their corners."""
    with open(file, "rb") as ply:
        header, _, body = ply.read().partition(b"end_header\n")
    count = {words[1]: int(words[2]) for words in map(str.split, header.decode().splitlines()) if words[0] == "element"}
    vertex, face = struct.Struct("<3d3B"), struct.Struct("<B3ii")
    vertices = [vertex.unpack_from(body, i * vertex.size) for i in range(count["vertex"])]
    start = vertex.size * count["vertex"]
    triangles = [[vertices[v] for v in face.unpack_from(body, start + i * face.size)[1:4]] for i in range(count["face"])]
    return [(tuple(sum(v[3 + k] for v in t) / (3 * 255) for k in range(3)), [[v[:3] for v in t]]) for t in triangles]


def tube(points, radius=0.006):
    """The triangles of a thin tube with four sides along a polyline; crossed ribbons, so that it is seen from all sides."""
    triangles = []
    for a, b in zip(points, points[1:]):
        for axis in range(3):
            side = [radius * (k == axis) for k in range(3)]
            low, high = ([[p[k] + sign * side[k] for k in range(3)] for p in (a, b)] for sign in (-1, 1))
            triangles += [[low[0], low[1], high[1]], [high[1], high[0], low[0]]]
    return triangles


def colours_by_label(parts):
    """The colour of a part by its coarse label."""
    roles = sorted({part["coarse"] for part in parts})
    colours = dict(zip(roles, colours_of_roles(roles)))
    return {part["name"]: colours[part["coarse"]] for part in parts}.get


class Pictures:
    def __init__(self, args, scratch):
        self.args, self.scratch = args, scratch
        self.cache = os.path.join(scratch, "cache")

    def run(self, *words):
        subprocess.run([self.args.program, *words, "--cache", self.cache, "--quiet"], check=True)

    def data(self, name):
        return os.path.join(self.args.data, name)

    def out(self, name, ending=".webp"):
        return os.path.join(self.args.out, name + ending)

    def generated(self, *options):
        folder = os.path.join(self.scratch, "generated" + "".join(options))
        if not os.path.isdir(folder):
            subprocess.run([self.args.generator, *options, folder], check=True)
        return folder

    def result(self, command, *words):
        file = os.path.join(self.scratch, "result.json")
        self.run(command, *words, "--json", file)
        with open(file) as result:
            return json.load(result)

    def draw_pair(self, picture, source, target, options=(), column=0, row=0):
        colours = colours_of_match(self.result("match", source, target, *options)["blocks"])
        for side, model in enumerate((source, target)):
            picture.draw(read_model(model), colours[side], column + side, row)

    def draw_blend(self, picture, source, target, frames, row=0):
        """A blend from left to right, in the colours of the match."""
        colours = colours_of_match(self.result("match", source, target)["blocks"])
        folder = os.path.join(tempfile.mkdtemp(dir=self.scratch), "frames")
        self.run("blend", source, target, "-o", folder, "--frames", str(frames))

        def in_between(name):
            a, _, b = name.partition("~")
            return colours[0](a) if a else colours[1](b)
        for column, name in enumerate(sorted(os.listdir(folder))):
            ends = {0: colours[0], frames - 1: colours[1]}
            picture.draw(read_model(os.path.join(folder, name)), ends.get(column, in_between), column, row)

    def abstraction(self):
        """A chair: its surfaces, its curves and sheets, and these in the colours of symmetry groups."""
        shape, file = self.data("chair_slatted"), os.path.join(self.scratch, "graph.json")
        self.run("graph", shape, "-o", file)
        with open(file) as graph:
            graph = json.load(graph)
        drawn = [(part["name"], sheet(part["grid"]) if part["type"] == "sheet" else tube(part["points"])) for part in graph["parts"]]
        names = [part["name"] for part in graph["parts"]]
        group = {name: i for i, g in enumerate(graph["groups"]) for name in g["parts"]}
        picture = Picture(3)
        picture.draw(read_model(shape), lambda name: numbered_colour(names.index(name)), 0)
        picture.draw(drawn, lambda name: numbered_colour(names.index(name)), 1)
        picture.draw(drawn, lambda name: numbered_colour(group[name]), 2)
        picture.write(self.out("abstraction"), self.args.browser)

    def energy(self):
        """A schematic picture of the rods between two parts: before, rotated (E_d), and longer (E_c)."""
        seat, leg = [(10, 30), (60, 30), (110, 30)], [(20, 40), (20, 80), (20, 120)]
        turned, apart = [(32, 40), (52, 76), (72, 112)], [(20, 62), (20, 102), (20, 142)]
        panels = [("before", leg), ("the leg turns: E_d", turned), ("they part: E_c", apart)]
        body = ""
        for i, (title, leg) in enumerate(panels):
            rods = "".join(line(a, b, "#999", 1) for a in seat for b in leg)
            body += (f'<g transform="translate({10 + 190 * i},0)">{rods}{line(seat[0], seat[-1], "#2f91f2", 6)}{line(leg[0], leg[-1], "#dc5b90", 6)}'
                     f'<text x="60" y="170">{title}</text></g>')
        self.write_svg("energy", 570, 180, body)

    def search(self):
        """A beam search that keeps three states of each level, each with two expansions: a schematic picture."""
        levels, kept, body = [[400]], [0], ""
        for level, keep in enumerate(([0, 1], [0, 1, 3], [1, 2, 4])):
            parents = [levels[-1][i] for i in kept]
            at = [80 + 640 * (i + 0.5) / (2 * len(parents)) for i in range(2 * len(parents))]
            body += "".join(line((parents[i // 2], 20 + 60 * level), (x, 80 + 60 * level), "#2f91f2" if i in keep else "#bbb", 2)
                            for i, x in enumerate(at))
            levels.append(at)
            kept = keep
        for level, (at, keep) in enumerate(zip(levels, ([0], [0, 1], [0, 1, 3], [1, 2, 4]))):
            body += "".join(f'<circle cx="{x:.0f}" cy="{20 + 60 * level}" r="9" fill="{"#2f91f2" if i in keep else "#ccc"}"/>' for i, x in enumerate(at))
            body += f'<text x="30" y="{25 + 60 * level}">{level} groups</text>'
        self.write_svg("search", 760, 220, body)

    def write_svg(self, name, width, height, body):
        with open(os.path.join(self.args.out, name + ".svg"), "w") as file:
            file.write(f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {width} {height}" width="{width}" height="{height}" font-family="sans-serif" '
                       f'font-size="13" text-anchor="middle" fill="#555">{body}</svg>\n')

    def roles(self):
        """Parts in the colours of their roles."""
        shapes = ["chair_slatted", "chair_swivel", "table_trestle", "airplane_propeller"]
        picture = Picture(len(shapes))
        for column, shape in enumerate(shapes):
            with open(os.path.join(self.data(shape), "labels.json")) as labels:
                picture.draw(read_model(self.data(shape)), colours_by_label(json.load(labels)["parts"]), column)
        picture.write(self.out("roles"), self.args.browser)

    def blocks(self):
        """The parts of two chairs, one colour for each, and the blocks of their match."""
        pair = self.data("chair_slatted"), self.data("chair_spindle")
        picture = Picture(4)
        for column, shape in enumerate(pair):
            parts = read_model(shape)
            names = [name for name, _ in parts]
            picture.draw(parts, lambda name: numbered_colour(names.index(name)), column)
        self.draw_pair(picture, *pair, column=2)
        picture.write(self.out("blocks"), self.args.browser)

    def as_one_object(self, shape):
        """The file of a shape whose parts are one object."""
        file = os.path.join(self.scratch, shape + "_one.obj")
        corners = [p for _, triangles in read_model(self.data(shape)) for t in triangles for p in t]
        with open(file, "w") as obj:
            obj.writelines("v {:.6f} {:.6f} {:.6f}\n".format(*p) for p in corners)
            obj.writelines(f"f {i} {i + 1} {i + 2}\n" for i in range(1, len(corners), 3))
        return file

    def finding(self):
        """Two aeroplanes as one object each: the pieces of one, the parts that are found, and their match."""
        files, found = [self.as_one_object(shape) for shape in PLANES], []
        for file in files:
            found.append(file[:-4] + "_found.obj")
            self.run_parts(file, "-o", found[-1])
        pieces = found[0].replace("_found", "_pieces")
        self.run_parts(files[0], "--parts", "components", "-o", pieces)
        picture = Picture(4)
        for column, file in enumerate((pieces, found[0])):
            parts = read_model(file)
            names = [name for name, _ in parts]
            picture.draw(parts, lambda name: numbered_colour(names.index(name)), column)
        colours = colours_of_match(self.result("match", *files)["blocks"])
        for side, file in enumerate(found):
            picture.draw(read_model(file), colours[side], 2 + side)
        picture.write(self.out("finding"), self.args.browser)

    def finding_tree(self):
        """The tree of the first aeroplane's pieces; the nodes that are parts are filled, with their roles."""
        file, page = self.as_one_object(PLANES[0]), os.path.join(self.scratch, "parts.html")
        self.run_parts(file, "--html", page)
        with open(page, encoding="utf-8") as html:
            model = json.loads(html.read().split('id="parts">')[1].split("</script>")[0])["models"][0]
        leaves, count = [part for part, *_ in model["pieces"]], len(model["pieces"])
        under = [{i} for i in range(count)]
        for a, b in model["unions"]:
            under.append(under[a] | under[b])
        order, roots = [], [under.index(max(under, key=len))]
        while roots:  # leaves from left to right
            node = roots.pop()
            roots += reversed(model["unions"][node - count]) if node >= count else []
            order += [node] if node < count else []
        place, body = {}, ""
        for node, pieces in enumerate(under):
            if node < count:
                place[node] = 40 + 44 * order.index(node), 250
                continue
            a, b = (place[child] for child in model["unions"][node - count])
            place[node] = x, y = (a[0] + b[0]) / 2, min(a[1], b[1]) - 22
            body += line((a[0], y), (b[0], y), "#aaa", 1) + "".join(line((p[0], y), p, "#aaa", 1) for p in (a, b))
        for node, pieces in enumerate(under):
            parts = {leaves[i] for i in pieces}
            is_part = len(parts) == 1 and len(pieces) == leaves.count(min(parts))
            x, y = place[node]
            body += f'<circle cx="{x:.0f}" cy="{y}" r="{7 if is_part else 3}" fill="{"#2f91f2" if is_part else "#999"}"/>'
            if is_part:
                body += f'<text transform="translate({min(place[i][0] for i in pieces):.0f},266) rotate(50)" text-anchor="start">{model["roles"][min(parts)].replace("_", " ")}</text>'
        self.write_svg("finding_tree", 40 + 44 * count + 40, 350, body)

    def run_parts(self, *words):
        subprocess.run([self.args.program, "parts", *words, "--quiet"], check=True)

    def split(self):
        """Splits, step by step: a solid back becomes slats."""
        picture = Picture(6)
        self.draw_blend(picture, self.data("chair_four_legged"), self.data("chair_slatted"), 6)
        picture.write(self.out("split"), self.args.browser)

    def map(self):
        """Stripes on the parts of a chair, and what the map between the surfaces makes of them."""
        bands, size = 12, 0.02
        shape = read_model(self.data(DEMO[0]))
        heights = [p[1] for _, triangles in shape for t in triangles for p in t]
        low, high = min(heights), max(heights)
        pieces = {}
        for name, triangles in shape:
            for triangle in triangles:
                for t in divided(triangle, size):
                    band = int(bands * (sum(p[1] for p in t) / 3 - low) / (high - low))
                    pieces.setdefault((name, min(band, bands - 1)), []).append(t)
        colours = [numbered_colour(band % 4) for band in range(bands)]
        source, painted = (os.path.join(self.scratch, name) for name in ("striped.obj", "painted.ply"))
        with open(os.path.join(self.scratch, "striped.mtl"), "w") as mtl:
            for band, colour in enumerate(colours):
                mtl.write(f"newmtl band{band}\nKd {' '.join(f'{c:.4f}' for c in colour)}\n")
        with open(source, "w") as obj:
            obj.write("mtllib striped.mtl\n")
            written, last = 0, None
            for (name, band), triangles in sorted(pieces.items()):
                if name != last:
                    obj.write(f"o {name}\n")
                last = name
                obj.write("".join(f"v {p[0]:.6f} {p[1]:.6f} {p[2]:.6f}\n" for t in triangles for p in t) + f"usemtl band{band}\n")
                obj.write("".join(f"f {written + 3 * i + 1} {written + 3 * i + 2} {written + 3 * i + 3}\n" for i in range(len(triangles))))
                written += 3 * len(triangles)
        self.run("transfer", source, self.data("chair_slatted"), "-o", painted)
        picture = Picture(2)
        picture.draw([(colours[band], triangles) for (_, band), triangles in pieces.items()], tuple, 0)
        picture.draw(read_coloured_ply(painted), tuple, 1)
        picture.write(self.out("map"), self.args.browser)

    def tutorial_pipeline(self):
        """The two tables of the example, in the colours of their labels."""
        top = "top", box((0, 0.7, 0), (1.2, 0.75, 0.8))
        legs = [("leg", box((x, 0, z), (x + 0.06, 0.7, z + 0.06))) for x in (0, 1.14) for z in (0, 0.74)]
        panels = [("leg", box((x, 0, 0), (x + 0.06, 0.7, 0.8))) for x in (0.1, 1.04)]
        picture = Picture(2)
        for column, parts in enumerate(([top, *legs], [top, *panels])):
            picture.draw(parts, dict(zip(("top", "leg"), colours_of_roles(["top", "leg"]))).get, column)
        picture.write(self.out("tutorial_pipeline"), self.args.browser)

    def tutorial_roles(self):
        """Lamps in the colours of their roles."""
        folder = os.path.join(self.generated("--benchmark"), "lamp")
        lamps = sorted(os.listdir(folder))[::3]
        picture = Picture(len(lamps))
        for column, lamp in enumerate(lamps):
            with open(os.path.join(folder, lamp, "labels.json")) as labels:
                picture.draw(read_model(os.path.join(folder, lamp)), colours_by_label(json.load(labels)["parts"]), column)
        picture.write(self.out("tutorial_roles"), self.args.browser)

    def tutorial_match(self):
        picture = Picture(4)
        self.draw_pair(picture, *map(self.data, DEMO))
        self.draw_pair(picture, self.data("chair_slatted"), self.data("chair_spindle"), column=2)
        picture.write(self.out("tutorial_match"), self.args.browser)

    def tutorial_parts(self):
        picture = Picture(2)
        parts = read_model(self.data(DEMO[0]))
        with open(os.path.join(self.data(DEMO[0]), "labels.json")) as labels:
            picture.draw(parts, colours_by_label(json.load(labels)["parts"]), 0)
        names = [name for name, _ in parts]
        picture.draw(parts, lambda name: numbered_colour(names.index(name)), 1)
        picture.write(self.out("tutorial_parts"), self.args.browser)

    def collection(self):
        return self.result("collection", *map(self.data, CHAIRS))

    def tutorial_collection(self):
        picture = Picture(len(CHAIRS))
        cluster = {tuple(part): c["label"] for c in self.collection()["clusters"] for part in c["parts"]}
        for column, chair in enumerate(CHAIRS):
            picture.draw(read_model(self.data(chair)),
                         lambda name: numbered_colour(cluster[chair, name]) if (chair, name) in cluster else GREY, column)
        picture.write(self.out("tutorial_collection"), self.args.browser)

    def gallery_figure1(self):
        """Figures 1 and 9: correspondences by the method of the paper."""
        folders = [self.generated("--benchmark"), self.generated("--gallery")]
        picture = Picture(8, 2)
        for i, (category, a, b) in enumerate(GALLERY):
            folder = next(path for path in (os.path.join(f, category) for f in folders) if os.path.isdir(path))
            shapes = [os.path.join(folder, f"{category}_{name}") for name in (a, b)]
            self.draw_pair(picture, *shapes, options=["--paper"], column=i % 4 * 2, row=i // 4)
        picture.write(self.out("gallery_figure1"), self.args.browser)

    def blends(self, name, pairs, frames=7):
        """A row of frames for each pair of shapes."""
        picture = Picture(frames, len(pairs))
        for row, pair in enumerate(pairs):
            with tempfile.TemporaryDirectory() as scratch:
                out = os.path.join(scratch, "frames")
                self.run("blend", *pair, "-o", out, "--frames", str(frames))
                draw_blend(picture, out, row)
        picture.write(self.out(name), self.args.browser)

    def blend(self):
        self.blends("blend", [(self.data("table_pedestal"), self.data("table_trestle"))])

    def gallery_figure12(self):
        """Figure 12: blends, of the pairs that `results.py` measures, too."""
        folders = [self.generated("--benchmark"), self.generated("--gallery")]
        with open(os.path.join(os.path.dirname(os.path.abspath(__file__)), "figure12_pairs.txt")) as file:
            pairs = [line.split() for line in file if line.strip() and not line.startswith("#")]
        found = lambda *names: next(path for path in (os.path.join(folder, *names, "parts") for folder in folders) if os.path.isdir(path))
        self.blends("gallery_figure12", [[found(category, name) for name in names] for category, *names in pairs])

    def gallery_figure14(self):
        """Figure 14: the shapes of a set by their mean distance, the medoid first."""
        folder = os.path.join(self.generated("--benchmark"), "chair")
        chairs = [os.path.join(folder, name) for name in sorted(os.listdir(folder))][:10]
        energies = self.result("collection", *chairs, "--paper")["energies"]
        n = len(chairs)
        order = sorted(range(n), key=lambda i: sum(energies[i][j] + energies[j][i] for j in range(n)))
        picture = Picture(n)
        for column, i in enumerate(order):
            picture.draw(read_model(chairs[i]), lambda name: numbered_colour(0) if column == 0 else GREY, column)
        picture.write(self.out("gallery_figure14"), self.args.browser)

    def gallery_nearest(self):
        """The medoids of the categories of generated shapes, and the ten shapes of all that are nearest to each."""
        folder, count = self.generated("--training", "100"), 10
        shapes = {category: [os.path.join(folder, category, name) for name in sorted(os.listdir(os.path.join(folder, category)))]
                  for category in sorted(os.listdir(folder))}
        everything = sum(shapes.values(), [])
        picture = Picture(1 + count, len(shapes))
        for row, (category, members) in enumerate(shapes.items()):
            query = next(m for m in members if os.path.basename(m) == self.result("collection", *members)["medoid"]["shape"])
            others = [shape for shape in everything if shape != query]
            parts = read_model(query)
            number = {name: i for i, (name, _) in enumerate(parts)}
            corners = {name: [p for t in triangles for p in t] for name, triangles in parts}
            size = {name: sum(max(axis) - min(axis) for axis in zip(*points)) for name, points in corners.items()}
            picture.draw(parts, lambda name: numbered_colour(number[name]), 0, row)
            for column, near in enumerate(self.result("collection", *others, "--nearest", query, "-k", str(count))["nearest"]):
                colour = {b: numbered_colour(number[a]) for a, b in sorted(near["pairs"], key=lambda pair: size[pair[0]])}
                picture.draw(read_model(near["file"]), lambda name: colour.get(name, GREY), 1 + column, row)
        picture.write(self.out("gallery_nearest"), self.args.browser)

    def graph(self):
        page = os.path.join(self.scratch, "graph.html")
        self.run("graph", self.data("chair_spindle"), "--html", page)
        screenshot(self.args.browser, page, self.out("graph", ".png"), WIDTH, HEIGHT)

    def page(self):
        page = os.path.join(self.scratch, "match.html")
        self.run("match", *map(self.data, DEMO), "--html", page)
        screenshot(self.args.browser, page, self.out("page", ".png"), WIDTH, HEIGHT)


NAMES = ["abstraction", "blend", "finding", "finding_tree", "energy", "search", "roles", "blocks", "split", "map", "tutorial_parts", "tutorial_match", "tutorial_pipeline", "tutorial_roles",
         "tutorial_collection", "gallery_figure1", "gallery_figure12", "gallery_figure14", "gallery_nearest", "graph", "page"]


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("program")
    parser.add_argument("generator")
    parser.add_argument("data")
    parser.add_argument("out")
    parser.add_argument("--browser", default="chromium")
    parser.add_argument("--only", default="", metavar="NAMES", help=", ".join(NAMES))
    args = parser.parse_args()
    os.makedirs(args.out, exist_ok=True)
    if not shutil.which(args.browser) or not os.path.exists(THREE):
        print(f"{args.browser} or {THREE} is not installed: no pictures are made")
        sys.exit(SKIPPED)
    wanted = args.only.split(",") if args.only else NAMES
    with tempfile.TemporaryDirectory() as scratch:
        pictures = Pictures(args, scratch)
        for name in wanted:
            getattr(pictures, name)()


if __name__ == "__main__":
    main()

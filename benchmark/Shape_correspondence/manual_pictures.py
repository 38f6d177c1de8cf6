#!/usr/bin/env python3
# Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
# SPDX-License-Identifier: GPL-3.0-or-later
"""Makes the pictures of the manual from models of data/ and generated ones.

  manual_pictures.py PROGRAM GENERATOR DATA OUT [--browser chromium] [--only NAME,NAME]

GENERATOR is generate_models. Makes OUT/NAME.png: match, the shapes of the tutorials, and the gallery. `graph` is a screenshot of the
page of `graph --html`; it is made only with --browser.
"""
import argparse
import json
import os
import subprocess
import tempfile

import blend_figure
from contact_sheet import screenshot
from picture import GREY, Picture, colours_of_match, connected_blocks, numbered_colour, read_model

DEMO = "chair_four_legged", "chair_swivel"
CHAIRS = ["chair_four_legged", "chair_slatted", "chair_spindle", "chair_swivel", "stool"]
# Generated shapes of different topology, of every category but beds
GALLERY = [("airplane", "biplane", "biplane_twin"), ("chair", "office_slats", "windsor_arms"), ("lamp", "desk_clamp", "desk_three_rods"),
           ("table", "leaves_up", "writing"), ("velocipede", "tandem", "tandem_step_through"), ("bed", "cot_bars", "slats")]
WIDTH, HEIGHT = 1000, 520  # of a screenshot


class Pictures:
    def __init__(self, args, scratch):
        self.args, self.scratch = args, scratch
        self.cache = os.path.join(scratch, "cache")

    def run(self, *words):
        subprocess.run([self.args.program, *words, "--cache", self.cache, "--quiet"], check=True)

    def data(self, name):
        return os.path.join(self.args.data, name)

    def out(self, name):
        return os.path.join(self.args.out, name + ".png")

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

    def match(self):
        picture = Picture(2)
        self.draw_pair(picture, *map(self.data, DEMO))
        picture.write(self.out("match"))

    def tutorial_match(self):
        picture = Picture(4)
        self.draw_pair(picture, *map(self.data, DEMO))
        self.draw_pair(picture, self.data("chair_slatted"), self.data("chair_spindle"), column=2)
        picture.write(self.out("tutorial_match"))

    def tutorial_parts(self):
        picture = Picture(2)
        parts = read_model(self.data(DEMO[0]))
        labels = {p["name"]: p["coarse"] for p in json.load(open(os.path.join(self.data(DEMO[0]), "labels.json")))["parts"]}
        objects = sorted(set(labels.values()))
        picture.draw(parts, lambda name: numbered_colour(objects.index(labels[name])), 0)
        names = [name for name, _ in parts]
        picture.draw(parts, lambda name: numbered_colour(names.index(name)), 1)
        picture.write(self.out("tutorial_parts"))

    def collection(self):
        return self.result("collection", *map(self.data, CHAIRS))

    def tutorial_collection(self):
        picture = Picture(len(CHAIRS))
        cluster = {tuple(part): c["label"] for c in self.collection()["clusters"] for part in c["parts"]}
        for column, chair in enumerate(CHAIRS):
            picture.draw(read_model(self.data(chair)),
                         lambda name: numbered_colour(cluster[chair, name]) if (chair, name) in cluster else GREY, column)
        picture.write(self.out("tutorial_collection"))

    def gallery_figure1(self):
        """Figures 1 and 9: correspondences by the method of the paper."""
        folder = self.generated("--benchmark")
        picture = Picture(6, 2)
        for i, (category, a, b) in enumerate(GALLERY):
            shapes = [os.path.join(folder, category, f"{category}_{name}") for name in (a, b)]
            self.draw_pair(picture, *shapes, options=["--paper"], column=i % 3 * 2, row=i // 3)
        picture.write(self.out("gallery_figure1"))

    def gallery_figure12(self):
        """Figure 12: blends."""
        blend_figure.write_figure(self.args.program, self.data("table_pedestal"), self.data("table_trestle"), self.out("blend"), 7)

    def gallery_figure13(self):
        """Figure 13: a pair directly, and by way of the chain of least energy."""
        folder = self.generated("--benchmark")
        tables = [os.path.join(folder, "table", name) for name in sorted(os.listdir(os.path.join(folder, "table")))]
        bridges = self.result("collection", *tables, "--paper")["bridges"]
        best = min(bridges, key=lambda b: b["energy"] / b["direct_energy"])
        path = {os.path.basename(table): table for table in tables}
        chain = [path[name] for name in best["chain"]]
        picture = Picture(2 + len(chain))
        self.draw_pair(picture, chain[0], chain[-1], options=["--paper"])
        colours = colours_of_match(connected_blocks(best["pairs"]))
        for i, shape in enumerate(chain):
            ends = {0: colours[0], len(chain) - 1: colours[1]}
            picture.draw(read_model(shape), ends.get(i, lambda name: GREY), 2 + i)
        picture.write(self.out("gallery_figure13"))
        print("figure 13:", " - ".join(best["chain"]), best["energy"], "directly", best["direct_energy"])

    def gallery_figure14(self):
        """Figure 14: the shapes of a set by their mean distance, the medoid first."""
        folder = os.path.join(self.generated("--benchmark"), "chair")
        chairs = [os.path.join(folder, name) for name in sorted(os.listdir(folder))][:10]
        energies = self.result("collection", *chairs, "--paper")["energies"]
        n = len(chairs)
        order = sorted(range(n), key=lambda i: sum(energies[i][j] + energies[j][i] for j in range(n)))
        picture = Picture(n, fineness=1)
        for column, i in enumerate(order):
            picture.draw(read_model(chairs[i]), lambda name: numbered_colour(0) if column == 0 else GREY, column)
        picture.write(self.out("gallery_figure14"))

    def graph(self):
        page = os.path.join(self.scratch, "graph.html")
        self.run("graph", self.data("chair_spindle"), "--html", page)
        screenshot(self.args.browser, page, self.out("graph"), WIDTH, HEIGHT)


NAMES = ["match", "tutorial_parts", "tutorial_match", "tutorial_collection", "gallery_figure1", "gallery_figure12", "gallery_figure13",
         "gallery_figure14"]


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("program")
    parser.add_argument("generator")
    parser.add_argument("data")
    parser.add_argument("out")
    parser.add_argument("--browser", default="", help="make graph.png with it, too")
    parser.add_argument("--only", default="", metavar="NAMES", help=", ".join(NAMES))
    args = parser.parse_args()
    os.makedirs(args.out, exist_ok=True)
    wanted = args.only.split(",") if args.only else NAMES + (["graph"] if args.browser else [])
    with tempfile.TemporaryDirectory() as scratch:
        pictures = Pictures(args, scratch)
        for name in wanted:
            getattr(pictures, name)()


if __name__ == "__main__":
    main()

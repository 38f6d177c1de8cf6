#!/usr/bin/env python3
# Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
# SPDX-License-Identifier: GPL-3.0-or-later
"""Draws the frames of a blend side by side, as in the manual:

  blend_figure.py PROGRAM SOURCE TARGET OUT.png [--frames 7] [--options "--abstraction boxes"]

A part and its counterpart have one colour; parts that vanish or grow are grey. Needs nothing but Python.
"""
import argparse
import os
import shlex
import subprocess
import tempfile

from picture import GREY, Picture, numbered_colour, read_obj


def write_figure(program, source, target, out, frames, options=()):
    with tempfile.TemporaryDirectory() as scratch:
        folder = os.path.join(scratch, "frames")
        subprocess.run([program, "blend", source, target, "-o", folder, "--frames", str(frames), "--quiet", *options], check=True)
        draw_frames(folder, out)


def draw_frames(folder, out):
    picture = Picture(len(os.listdir(folder)))
    draw_row(picture, folder, 0)
    picture.write(out)


def draw_row(picture, folder, row):
    """Draws the frames in a folder of OBJ files, the first one the source and the last one the target."""
    shapes = [read_obj(os.path.join(folder, name)) for name in sorted(os.listdir(folder))]
    numbers = {}  # of source parts that stay
    of_source, of_target = {}, {}  # the ends have the names of the parts alone
    for name, _ in shapes[1]:
        a, _, b = name.partition("~")
        if a and b:
            number = numbers.setdefault(a, len(numbers))
            of_source.setdefault(a, number)
            of_target.setdefault(b, number)

    def colour_in_between(name):
        a, _, b = name.partition("~")
        return numbered_colour(numbers[a]) if a and b else GREY

    def colour_by(known):
        return lambda name: numbered_colour(known[name]) if name in known else GREY
    for i, parts in enumerate(shapes):
        colours = {0: colour_by(of_source), len(shapes) - 1: colour_by(of_target)}
        picture.draw(parts, colours.get(i, colour_in_between), i, row)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("program")
    parser.add_argument("source")
    parser.add_argument("target")
    parser.add_argument("out")
    parser.add_argument("--frames", type=int, default=7)
    parser.add_argument("--options", default="")
    args = parser.parse_args()
    write_figure(args.program, args.source, args.target, args.out, args.frames, shlex.split(args.options))


if __name__ == "__main__":
    main()

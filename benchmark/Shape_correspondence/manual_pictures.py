#!/usr/bin/env python3
# Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
# SPDX-License-Identifier: GPL-3.0-or-later
"""Makes the pictures of the manual from models of data/: screenshots of the pages that the program writes.

  manual_pictures.py PROGRAM DATA OUT [--browser chromium]

Makes OUT/graph.png and OUT/match.png with a browser that takes screenshots without a window.
"""
import argparse
import os
import subprocess
import tempfile

from contact_sheet import screenshot

WIDTH, HEIGHT = 1000, 520
PICTURES = {"graph": ["graph", "chair_spindle"], "match": ["match", "chair_four_legged", "chair_spindle"]}


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("program")
    parser.add_argument("data")
    parser.add_argument("out")
    parser.add_argument("--browser", default="chromium")
    args = parser.parse_args()
    os.makedirs(args.out, exist_ok=True)
    with tempfile.TemporaryDirectory() as folder:
        for name, (command, *shapes) in PICTURES.items():
            page = os.path.join(folder, name + ".html")
            subprocess.run([args.program, command, *[os.path.join(args.data, shape) for shape in shapes],
                            "--html", page, "--quiet"], check=True)
            screenshot(args.browser, page, os.path.join(args.out, name + ".png"), WIDTH, HEIGHT)


if __name__ == "__main__":
    main()

#!/usr/bin/env python3
# Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
# SPDX-License-Identifier: GPL-3.0-or-later
"""Draws the pages that `experiments worst` left in a folder side by side, in one picture.

  worst_sheet.py FOLDER OUT.png [--browser chromium]

Parts that correspond have one colour, what is grey has no counterpart. The number is that of the page and of the row in the table.
"""
import argparse
import os
import tempfile

from contact_sheet import PICTURE_ALONE, screenshot

COLUMNS, WIDTH, HEIGHT = 5, 300, 220


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("folder")
    parser.add_argument("out")
    parser.add_argument("--browser", default="chromium")
    args = parser.parse_args()
    tiles = []
    with tempfile.TemporaryDirectory() as work:
        while os.path.exists(source := os.path.join(args.folder, f"worst_{len(tiles) + 1}.html")):
            number = len(tiles) + 1
            with open(source) as file:  # the picture alone
                text = file.read().replace("</style>", PICTURE_ALONE)
            page = os.path.join(work, f"{number}.html")
            with open(page, "w") as file:
                file.write(text)
            screenshot(args.browser, page, os.path.join(work, f"{number}.png"), WIDTH, HEIGHT)
            tiles.append(f'<div><img src="{number}.png">{number}</div>')
        sheet = os.path.join(work, "sheet.html")
        with open(sheet, "w") as file:
            file.write("<style>body{margin:0;display:grid;font:13px sans-serif;grid-template-columns:repeat(%d,%dpx)}"
                       "div{text-align:center}img{display:block}</style>%s" % (COLUMNS, WIDTH, "".join(tiles)))
        rows = -(-len(tiles) // COLUMNS)
        screenshot(args.browser, sheet, args.out, COLUMNS * WIDTH, rows * (HEIGHT + 20))


if __name__ == "__main__":
    main()

#!/usr/bin/env python3
# Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
# SPDX-License-Identifier: GPL-3.0-or-later
"""Draws the structural graphs of all shapes of a folder, a sheet of pictures a category.

  contact_sheet.py PROGRAM DATA OUT [--category chair,table] [--browser chromium]

DATA holds CATEGORY/SHAPE/parts. Makes OUT/CATEGORY/SHAPE.html with the program, and OUT/CATEGORY.png of all of them with a
browser that takes screenshots without a window.
"""
import argparse
import os
import subprocess

COLUMNS, WIDTH, HEIGHT = 4, 480, 400
FLAGS = ["--headless=new", "--no-sandbox", "--use-gl=angle", "--use-angle=swiftshader", "--enable-unsafe-swiftshader",
         "--hide-scrollbars", "--allow-file-access-from-files"]


# Style of a page of which only the picture is shown
PICTURE_ALONE = """#side, #tools { display: none; }
body { grid-template: "stage" 100vh / 100%; }
#stage { height: 100vh; border: 0; }
</style>"""


def screenshot(browser, page, picture, width, height):
    subprocess.run([browser, *FLAGS, "--virtual-time-budget=4000", f"--window-size={width},{height}",
                    f"--screenshot={picture}", "file://" + os.path.abspath(page)], check=True, capture_output=True, timeout=120)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("program")
    parser.add_argument("data")
    parser.add_argument("out")
    parser.add_argument("--category", default="")
    parser.add_argument("--browser", default="chromium")
    args = parser.parse_args()
    wanted = set(filter(None, args.category.split(",")))
    for category in sorted(os.listdir(args.data)):
        folder = os.path.join(args.data, category)
        if not os.path.isdir(folder) or (wanted and category not in wanted):
            continue
        os.makedirs(os.path.join(args.out, category), exist_ok=True)
        tiles = []
        for shape in sorted(os.listdir(folder)):
            model = os.path.join(folder, shape, "parts")
            if not os.path.isdir(model):
                continue
            page = os.path.join(args.out, category, shape + ".html")
            picture = page[:-5] + ".png"
            subprocess.run([os.path.abspath(args.program), "graph", model, "--quiet", "--html", page], check=True)
            with open(page) as file:  # the picture alone
                text = file.read().replace("</style>", PICTURE_ALONE)
            with open(picture[:-4] + ".tile.html", "w") as file:
                file.write(text)
            screenshot(args.browser, picture[:-4] + ".tile.html", picture, WIDTH, HEIGHT)
            os.remove(picture[:-4] + ".tile.html")
            tiles.append(f'<div><img src="{category}/{shape}.png">{shape}</div>')
        sheet = os.path.join(args.out, category + ".html")
        with open(sheet, "w") as file:
            file.write("<style>body{margin:0;display:grid;font:13px sans-serif;grid-template-columns:repeat(%d,%dpx)}"
                       "div{text-align:center}img{display:block}</style>%s" % (COLUMNS, WIDTH, "".join(tiles)))
        rows = -(-len(tiles) // COLUMNS)
        screenshot(args.browser, sheet, os.path.join(args.out, category + ".png"), COLUMNS * WIDTH, max(rows * (HEIGHT + 20), 200))


if __name__ == "__main__":
    main()

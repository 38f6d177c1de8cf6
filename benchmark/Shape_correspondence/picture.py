# Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
# SPDX-License-Identifier: GPL-3.0-or-later
"""Draws shapes side by side, as WebP files, by three.js in a browser without a window; and takes screenshots of pages."""
import base64
import collections
import colorsys
import json
import math
import os
import re
import subprocess
import tempfile

HERE = os.path.dirname(os.path.abspath(__file__))
THREE = "/usr/share/javascript/three/three.min.js"  # of Debian's libjs-three
WIDTH, HEIGHT = 320, 384  # pixels of the cell of a shape
TURN, TILT = math.radians(32), math.radians(18)  # direction of view
GREY = 0.72, 0.72, 0.72
SHADES = 1, 0.8, 1.15, 0.9, 1.07
COLOURS = ("2f91f2 dc5b90 b7cb30 203aa1 af2e0b 7e0360 b68629 46d6d2 734f9a 7c2621 a879c4 a82964 4cdd8b 1e5dc2 cfaafc 50367f ce7066 "
           "297538 ff9cb4 772548 8b467e f8a96e").split()
GOLDEN_RATIO = 0.618034  # far hues for subsequent numbers
BROWSER_FLAGS = ["--headless=new", "--no-sandbox", "--use-gl=angle", "--use-angle=swiftshader", "--enable-unsafe-swiftshader",
                 "--hide-scrollbars", "--allow-file-access-from-files"]
# Style of a page of which only the picture is shown
PICTURE_ALONE = """#side, #tools { display: none; }
body { grid-template: "stage" 100vh / 100%; }
#stage { height: 100vh; border: 0; }
</style>"""


def screenshot(browser, page, picture, width, height):
    subprocess.run([browser, *BROWSER_FLAGS, "--virtual-time-budget=4000", f"--window-size={width},{height}", "--force-device-scale-factor=2",
                    f"--screenshot={picture}", "file://" + os.path.abspath(page)], check=True, capture_output=True, timeout=120)


def read_obj(file):
    """[(name, triangles)], a triangle three points. Faces before any `o` have the name of the file."""
    points, parts = [], []
    for line in open(file):
        word, *rest = line.split() or [""]
        if word == "v":
            points.append(tuple(map(float, rest[:3])))
        elif word == "o":
            parts.append((rest[0], []))
        elif word == "f":
            if not parts:
                parts.append((os.path.splitext(os.path.basename(file))[0], []))
            corners = [points[int(corner.split("/")[0]) - 1] for corner in rest]
            parts[-1][1].extend([corners[0], corners[i], corners[i + 1]] for i in range(1, len(corners) - 1))
    return parts


def read_model(path):
    """The parts of an OBJ file or of a folder SHAPE/parts."""
    if os.path.isfile(path):
        return read_obj(path)
    folder = os.path.join(path, "parts")
    return [(name[:-4], [t for _, triangles in read_obj(os.path.join(folder, name)) for t in triangles])
            for name in sorted(os.listdir(folder)) if name.endswith(".obj")]


def numbered_colour(number):
    """The colour of a number in web pages, as distinct_colours() makes it; beyond COLOURS by hue, every other five darker."""
    if number < len(COLOURS):
        return tuple(int(COLOURS[number][2 * i:2 * i + 2], 16) / 255 for i in range(3))
    darker = number // 5 % 2
    return colorsys.hsv_to_rgb(number * GOLDEN_RATIO % 1, 0.55 + 0.2 * darker, 0.95 - 0.25 * darker)


def role_colours():
    """The colours of roles, as the program has them."""
    with open(os.path.join(HERE, "..", "..", "src", "io", "system", "colours.cpp")) as file:
        text = file.read()
    palette = [tuple(int(word[2 * i:2 * i + 2], 16) / 255 for i in range(3)) for word in re.findall(r"\b0x([0-9a-f]{6})\b", text)]
    return {role: palette[int(place)] for role, place in re.findall(r'\{"(\w+)", (\d+)\}', text)}


def colours_of_roles(roles):
    """A colour for each item of a list of roles: first the role's colour, then shades of it."""
    known, count, result = role_colours(), collections.Counter(), []
    for i, role in enumerate(roles):
        shade = SHADES[count[role] % len(SHADES)]
        count[role] += 1
        result.append(tuple(shade * channel for channel in known[role]) if role in known else numbered_colour(i))
    return result


def hexadecimal(colour):
    return "#" + "".join(f"{round(255 * min(1, channel)):02x}" for channel in colour)


def by_colour(parts, colour_of):
    """The triangles of each colour, as shapes.js takes them; the shape has size 1 and stands on the ground, its middle over the origin."""
    points = [p for _, triangles in parts for t in triangles for p in t]
    low, high = ([extreme(axis) for axis in zip(*points)] for extreme in (min, max))
    size = max(b - a for a, b in zip(low, high))
    origin = (low[0] + high[0]) / 2, low[1], (low[2] + high[2]) / 2
    found = {}
    for name, triangles in parts:
        found.setdefault(hexadecimal(colour_of(name)), []).extend(round((p[k] - origin[k]) / size, 5) for t in triangles for p in t for k in range(3))
    return [{"colour": colour, "triangles": flat} for colour, flat in found.items()]


def rendered(script, data, browser):
    """The pictures that a script makes with three.js in a browser without a window; it writes their data URLs into the document."""
    with tempfile.TemporaryDirectory() as work:
        with open(os.path.join(work, "data.js"), "w") as file:
            file.write("".join(f"const {name} = {json.dumps(value)};\n" for name, value in data.items()))
        page = os.path.join(work, "page.html")
        with open(page, "w") as file:
            sources = f"file://{THREE}", f"file://{os.path.join(HERE, 'shapes.js')}", "data.js"
            file.write('<!DOCTYPE html><meta charset="utf-8"><body>' + "".join(f'<script src="{source}"></script>' for source in sources) +
                       f"<script>{script}</script>")
        done = subprocess.run([browser, *BROWSER_FLAGS, "--dump-dom", "--timeout=600000", "file://" + page], capture_output=True, text=True, check=True)
    return [base64.b64decode(picture) for picture in re.findall(r"data:image/webp;base64,([\w+/=]+)", done.stdout)]


class Picture:
    """A grid of shapes."""

    def __init__(self, columns, rows=1):
        self.columns, self.rows, self.cells = columns, rows, []

    def draw(self, parts, colour_of, column, row=0):
        """Draws [(name, triangles)] into a cell, as large as fits. colour_of: name to (red, green, blue)."""
        self.cells.append({"column": column, "row": row, "parts": by_colour(parts, colour_of)})

    def write(self, file, browser):
        [picture] = rendered(f"document.body.textContent = drawGrid(cells, {self.columns}, {self.rows}, {WIDTH}, {HEIGHT}, {TURN}, {TILT});",
                             {"cells": self.cells}, browser)
        with open(file, "wb") as out:
            out.write(picture)


def colours_of_match(blocks):
    """Colours of source parts and of target parts: one for each block, grey for the others."""
    colours = colours_of_roles([block.get("role") for block in blocks])

    def of_side(side):
        number = {part: i for i, block in enumerate(blocks) for part in block[side]}
        return lambda name: colours[number[name]] if name in number else GREY
    return [of_side("source"), of_side("target")]


def draw_blend(picture, folder, row):
    """Draws the frames in a folder of OBJ files, the first one the source and the last one the target. A part and its counterpart have one colour."""
    shapes = [read_obj(os.path.join(folder, name)) for name in sorted(os.listdir(folder))]
    numbers = {}  # colours of source parts with a counterpart
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

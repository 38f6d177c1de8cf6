# Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
# SPDX-License-Identifier: GPL-3.0-or-later
"""Draws shapes side by side, as PNG files, with nothing but Python; and pages, with a browser that takes screenshots without a window."""
import colorsys
import math
import os
import struct
import subprocess
import zlib

WIDTH, HEIGHT = 200, 240  # pixels of a shape
TURN, TILT = math.radians(32), math.radians(18)  # of the eye
GREY = 0.72, 0.72, 0.72
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
    subprocess.run([browser, *BROWSER_FLAGS, "--virtual-time-budget=4000", f"--window-size={width},{height}",
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
    """The colours of web pages, as distinct_colours() makes them; further ones by hue, every other five darker."""
    if number < len(COLOURS):
        return tuple(int(COLOURS[number][2 * i:2 * i + 2], 16) / 255 for i in range(3))
    darker = number // 5 % 2
    return colorsys.hsv_to_rgb(number * GOLDEN_RATIO % 1, 0.55 + 0.2 * darker, 0.95 - 0.25 * darker)


def seen(p):
    """x to the right, y up, z to the eye."""
    x, z = p[0] * math.cos(TURN) - p[2] * math.sin(TURN), p[0] * math.sin(TURN) + p[2] * math.cos(TURN)
    return x, p[1] * math.cos(TILT) - z * math.sin(TILT), p[1] * math.sin(TILT) + z * math.cos(TILT)


class Picture:
    """A grid of shapes. Each is drawn `fineness` times as large and averaged."""

    def __init__(self, columns, rows=1, fineness=2):
        self.fineness = fineness
        self.cell = WIDTH * fineness, HEIGHT * fineness
        self.pixels = [bytearray(b"\xff" * 3 * columns * self.cell[0]) for _ in range(rows * self.cell[1])]

    def draw(self, parts, colour_of, column, row=0):
        """Draws [(name, triangles)] into a cell, as large as fits. colour_of: name to (red, green, blue)."""
        triangles = [(colour_of(name), [seen(p) for p in t]) for name, of_part in parts for t in of_part]
        xs = [p[0] for _, t in triangles for p in t]
        ys = [p[1] for _, t in triangles for p in t]
        margin = 10 * self.fineness
        scale = min((self.cell[0] - margin) / (max(xs) - min(xs)), (self.cell[1] - margin) / (max(ys) - min(ys)))
        left, bottom = column * self.cell[0], (row + 1) * self.cell[1] - margin / 2
        middle, low = (max(xs) + min(xs)) / 2, min(ys)
        depth = [{} for _ in range(len(self.pixels))]
        for rgb, t in triangles:
            at = [(left + self.cell[0] / 2 + scale * (p[0] - middle), bottom - scale * (p[1] - low), p[2]) for p in t]
            self._draw_triangle(at, t, rgb, depth)

    def _draw_triangle(self, at, triangle, rgb, depth):
        a, b, c = at
        (u, v, w), (x, y, z) = ([q[i] - triangle[0][i] for i in range(3)] for q in triangle[1:])
        normal = v * z - w * y, w * x - u * z, u * y - v * x
        length = math.hypot(*normal)
        area = (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])
        if length == 0 or abs(area) < 1e-9:
            return
        light = 0.45 + 0.55 * abs(0.3 * normal[0] + 0.6 * normal[1] + 0.74 * normal[2]) / length
        shade = bytes(int(255 * min(1, light * channel)) for channel in rgb)
        xs, ys = (a[0], b[0], c[0]), (a[1], b[1], c[1])
        for row in range(max(0, math.ceil(min(ys) - 0.5)), min(len(self.pixels) - 1, math.floor(max(ys) - 0.5)) + 1):
            for column in range(math.ceil(min(xs) - 0.5), math.floor(max(xs) - 0.5) + 1):
                px, py = column + 0.5, row + 0.5
                s = ((px - a[0]) * (c[1] - a[1]) - (py - a[1]) * (c[0] - a[0])) / area
                t = ((b[0] - a[0]) * (py - a[1]) - (b[1] - a[1]) * (px - a[0])) / area
                if s < 0 or t < 0 or s + t > 1:
                    continue
                near = a[2] + s * (b[2] - a[2]) + t * (c[2] - a[2])
                if near > depth[row].get(column, -math.inf):
                    depth[row][column] = near
                    self.pixels[row][3 * column:3 * column + 3] = shade

    def _averaged(self):
        n, rows = self.fineness, []
        for top in range(0, len(self.pixels), n):
            lines = self.pixels[top:top + n]
            width = len(lines[0]) // (3 * n)
            rows.append(bytes(sum(line[3 * (x * n + i) + channel] for line in lines for i in range(n)) // (n * n)
                              for x in range(width) for channel in range(3)))
        return rows

    def write(self, file):
        def chunk(kind, data):
            return struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))
        rows = self._averaged()
        header = struct.pack(">IIBBBBB", len(rows[0]) // 3, len(rows), 8, 2, 0, 0, 0)
        with open(file, "wb") as out:
            out.write(b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", header) +
                      chunk(b"IDAT", zlib.compress(b"".join(b"\0" + row for row in rows), 9)) + chunk(b"IEND", b""))


def connected_blocks(pairs):
    """The sets of parts that pairs connect, as `match` writes blocks."""
    blocks = []
    for a, b in pairs:
        touched = [block for block in blocks if a in block["source"] or b in block["target"]]
        blocks = [block for block in blocks if block not in touched]
        blocks.append({"source": {a}.union(*(block["source"] for block in touched)),
                       "target": {b}.union(*(block["target"] for block in touched))})
    return blocks


def colours_of_match(blocks):
    """Colours of source parts and of target parts: one for each block, grey for the others."""
    def of_side(side):
        number = {part: i for i, block in enumerate(blocks) for part in block[side]}
        return lambda name: numbered_colour(number[name]) if name in number else GREY
    return [of_side("source"), of_side("target")]


def draw_blend(picture, folder, row):
    """Draws the frames in a folder of OBJ files, the first one the source and the last one the target. A part and its counterpart have one colour."""
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

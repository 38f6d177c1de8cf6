#!/usr/bin/env python3
# Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
# SPDX-License-Identifier: GPL-3.0-or-later
"""Files as other programs write them, and inputs that are hard to treat: makes each, and runs the program on it.

  foreign_files.py PROGRAM [BEFORE]   prints a row for each kind: what the program makes of it (and what an earlier one made)

Ends with exit status 1 if PROGRAM does not do what is wanted.
"""
import json
import os
import random
import struct
import subprocess
import sys
import tempfile
import time
import zlib

MOST_SECONDS = 60  # time limit of a command
RED, BLUE = (255, 0, 0), (0, 0, 255)


# The chair of six parts ------------------------------------------------------------------------------------------------

BOXES = {"seat": ((-.225, .425, -.225), (.225, .475, .225)), "back": ((-.225, .495, -.22), (.225, .945, -.18))}
for side, x in (("l", -.2), ("r", .2)):
    for end, z in (("f", .2), ("b", -.2)):
        BOXES[f"leg_{end}{side}"] = ((x - .02, 0, z - .02), (x + .02, .425, z + .02))
QUADS = [(0, 1, 3, 2), (4, 6, 7, 5), (0, 4, 5, 1), (2, 3, 7, 6), (0, 2, 6, 4), (1, 5, 7, 3)]  # the faces of a box, oriented outwards


def corners(box):
    low, high = box
    return [((low, high)[i >> 2 & 1][0], (low, high)[i >> 1 & 1][1], (low, high)[i & 1][2]) for i in range(8)]


def lying(boxes):
    """The boxes, turned from y up to z up."""
    turned = {n: [(p[0], -p[2], p[1]) for p in box] for n, box in boxes.items()}
    return {n: tuple(tuple(f(a, b) for a, b in zip(*box)) for f in (min, max)) for n, box in turned.items()}


def triangles_of(quads):
    return [t for a, b, c, d in quads for t in ((a, b, c), (a, c, d))]


def obj(boxes=BOXES, vertex=lambda p: "v %g %g %g" % p, name=lambda n: f"o {n}", after=lambda n, k: "", eol="\n"):
    lines, first = [], 1
    for n, box in boxes.items():
        lines += [name(n)] + [vertex(p) for p in corners(box)]
        for k, quad in enumerate(QUADS):
            lines += [after(n, k), "f " + " ".join(str(first + i) for i in quad)]
        first += 8
    return eol.join(line for line in lines if line) + eol


def facets(box):
    points = corners(box)
    return [[points[i] for i in t] for t in triangles_of(QUADS)]


def text_stl(boxes=BOXES, header=lambda n: f"solid {n}", footer=lambda n: f"endsolid {n}"):
    lines = []
    for n, box in boxes.items():
        lines.append(header(n))
        for facet in facets(box):
            lines += ["facet normal 0 0 0", "outer loop"] + ["vertex %g %g %g" % p for p in facet] + ["endloop", "endfacet"]
        lines.append(footer(n))
    return "\n".join(line for line in lines if line) + "\n"


def binary_stl(box, header=b""):
    data = b"".join(struct.pack("<12fH", 0, 0, 0, *sum(facet, ()), 0) for facet in facets(box))
    return header.ljust(80, b" ") + struct.pack("<I", len(data) // 50) + data


def all_points():
    return [p for box in BOXES.values() for p in corners(box)]


def ply(eol="\n", comments=(), face_property=None, mark=""):
    quads = [tuple(8 * i + k for k in quad) for i in range(6) for quad in QUADS]
    lines = [mark + "ply", "format ascii 1.0", *comments, "element vertex 48", *(f"property float {a}" for a in "xyz"),
             "element face 36", "property list uchar int vertex_indices"]
    if face_property:
        lines += face_property[0]
    lines += ["end_header"] + ["%g %g %g" % p for p in all_points()]
    for i, quad in enumerate(quads):
        lines.append(f"4 {' '.join(map(str, quad))}" + (" " + face_property[1](i) if face_property else ""))
    return eol.join(lines) + eol


def off(head, end=" 36 0\n"):
    faces = "".join(f"4 {' '.join(str(8 * i + k) for k in quad)}\n" for i in range(6) for quad in QUADS)
    return head + "48" + end + "".join("%g %g %g\n" % p for p in all_points()) + faces


def strips(binary):
    strip = [k for i in range(6) for quad in QUADS for k in (8 * i + quad[0], 8 * i + quad[1], 8 * i + quad[3], 8 * i + quad[2], -1)]
    head = ("ply\nformat %s 1.0\nelement vertex 48\nproperty float x\nproperty float y\nproperty float z\n"
            "element tristrips 1\nproperty list int int vertex_indices\nend_header\n")
    if binary:
        return ((head % "binary_little_endian").encode() + b"".join(struct.pack("<3f", *p) for p in all_points()) +
                struct.pack(f"<i{len(strip)}i", len(strip), *strip))
    return head % "ascii" + "".join("%g %g %g\n" % p for p in all_points()) + f"{len(strip)} {' '.join(map(str, strip))}\n"


def png(left, right, size=8):
    """A PNG picture whose left half has one colour, and whose right half another one."""
    row = b"\0" + bytes(left) * (size // 2) + bytes(right) * (size // 2)
    chunk = lambda kind, data: struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))
    return (b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", struct.pack(">2I5B", size, size, 8, 2, 0, 0, 0)) +
            chunk(b"IDAT", zlib.compress(row * size)) + chunk(b"IEND", b""))


class Glb:
    """A GLB file in the making."""

    def __init__(self):
        self.bytes, self.document = b"", {"asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": []}], "nodes": [],
                                          "meshes": [], "accessors": [], "bufferViews": []}

    def view(self, data):
        self.document["bufferViews"].append({"buffer": 0, "byteOffset": len(self.bytes), "byteLength": len(data)})
        self.bytes += data + b"\0" * (-len(data) % 4)
        return len(self.document["bufferViews"]) - 1

    def accessor(self, kind, rows):
        flat = [x for row in rows for x in row]
        integral = kind == "SCALAR"
        view = self.view(struct.pack(f"<{len(flat)}{'H' if integral else 'f'}", *flat))
        entry = {"bufferView": view, "componentType": 5123 if integral else 5126, "count": len(rows), "type": kind}
        if kind == "VEC3":
            entry.update(min=[min(c) for c in zip(*rows)], max=[max(c) for c in zip(*rows)])
        self.document["accessors"].append(entry)
        return len(self.document["accessors"]) - 1

    def mesh(self, box, uv_sets=(), material=None):
        primitive = {"attributes": {"POSITION": self.accessor("VEC3", corners(box))},
                     "indices": self.accessor("SCALAR", [(i,) for t in triangles_of(QUADS) for i in t])}
        for k, uv in enumerate(uv_sets):
            primitive["attributes"][f"TEXCOORD_{k}"] = self.accessor("VEC2", [uv] * 8)
        if material is not None:
            primitive["material"] = material
        self.document["meshes"].append({"primitives": [primitive]})
        return len(self.document["meshes"]) - 1

    def node(self, root=True, **entry):
        self.document["nodes"].append(entry)
        if root:
            self.document["scenes"][0]["nodes"].append(len(self.document["nodes"]) - 1)
        return len(self.document["nodes"]) - 1

    def data(self):
        self.document["buffers"] = [{"byteLength": len(self.bytes)}]
        text = json.dumps(self.document).encode()
        text += b" " * (-len(text) % 4)
        chunks = struct.pack("<I4s", len(text), b"JSON") + text + struct.pack("<I4s", len(self.bytes), b"BIN\0") + self.bytes
        return struct.pack("<4s2I", b"glTF", 2, 12 + len(chunks)) + chunks


def textured(texture_info, uv_sets, **document):
    glb = Glb()
    glb.document.update(images=[{"bufferView": glb.view(png(RED, BLUE)), "mimeType": "image/png"}], textures=[{"source": 0}],
                        materials=[{"pbrMetallicRoughness": {"baseColorTexture": {"index": 0, **texture_info}}}], **document)
    for name, box in BOXES.items():
        glb.node(name=name, mesh=glb.mesh(box, uv_sets, 0))
    return glb.data()


def fbx(up, boxes=BOXES, unit=1):
    """An FBX file in text, whose axis `up` (y 1, z 2) is upright. `unit` is the unit of length in centimetres."""
    turn = lambda p: tuple(100 / unit * x for x in (p if up == 1 else (p[0], -p[2], p[1])))
    properties = {"UpAxis": up, "UpAxisSign": 1, "FrontAxis": 3 - up, "FrontAxisSign": 1 if up == 1 else -1, "CoordAxis": 0,
                  "CoordAxisSign": 1}
    settings = "".join(f'P: "{n}", "int", "Integer", "",{v}\n' for n, v in properties.items())
    settings += f'P: "UnitScaleFactor", "double", "Number", "",{unit}\n'
    objects = links = ""
    for i, (name, box) in enumerate(boxes.items()):
        points = ",".join("%g,%g,%g" % turn(p) for p in corners(box))
        faces = ",".join(f"{a},{b},{c},{-d - 1}" for a, b, c, d in QUADS)
        objects += (f'Geometry: {100 + i}, "Geometry::{name}", "Mesh" {{\nVertices: *24 {{\na: {points}\n}}\n'
                    f'PolygonVertexIndex: *24 {{\na: {faces}\n}}\nGeometryVersion: 124\n}}\n'
                    f'Model: {200 + i}, "Model::{name}", "Mesh" {{\nVersion: 232\n}}\n')
        links += f'C: "OO",{200 + i},0\nC: "OO",{100 + i},{200 + i}\n'
    return ("; FBX 7.4.0 project file\nFBXHeaderExtension:  {\nFBXHeaderVersion: 1003\nFBXVersion: 7400\n}\n"
            f"GlobalSettings:  {{\nVersion: 1000\nProperties70:  {{\n{settings}}}\n}}\n"
            f"Objects:  {{\n{objects}}}\nConnections:  {{\n{links}}}\n")


# Running ---------------------------------------------------------------------------------------------------------------


class Runner:
    """Runs a program in a folder of its own, where it makes its inputs."""

    def __init__(self, program, folder):
        self.program, self.folder = os.path.abspath(program), folder

    def write(self, name, content):
        path = os.path.join(self.folder, name)
        os.makedirs(os.path.dirname(path), exist_ok=True)
        with open(path, "wb") as file:
            file.write(content if isinstance(content, bytes) else content.encode())
        return path

    def run(self, *words):
        begin = time.time()
        try:
            process = subprocess.run([self.program, *words], cwd=self.folder, capture_output=True, timeout=MOST_SECONDS)
        except subprocess.TimeoutExpired:
            return -1, "", f"more than {MOST_SECONDS} s", MOST_SECONDS
        return process.returncode, process.stdout.decode(), process.stderr.decode(), time.time() - begin

    def said(self, *words):
        """The exit status and the message of a command that fails; None if it succeeds."""
        status, _, error, _ = self.run(*words)
        return f"{status}: {error.strip()[:90]}" if status else None

    def summary(self, path, *options):
        """The number of parts and the upright axis, as `parts` prints them, or its error."""
        status, out, error, _ = self.run("parts", path, *options)
        line = out.split("\n")[0].split(": ", 1)[-1] if status == 0 else error.strip()
        return line[:110]

    def names(self, path):
        status, _, _, _ = self.run("parts", path, "--parts-json", "p.json")
        if status:
            return []
        with open(os.path.join(self.folder, "p.json")) as file:
            return sorted({piece["part"] for piece in json.load(file)["pieces"]})

    def match(self, a, b, *options):
        status, _, error, seconds = self.run("match", a, b, *options, "--json", "m.json", "--quiet")
        if status:
            return {"error": error.strip(), "seconds": seconds, "pairs": []}
        with open(os.path.join(self.folder, "m.json")) as file:
            return json.load(file)

    def transferred_colour(self, source):
        """The colour of the largest part of what `transfer` paints, red or blue."""
        self.write("plain_chair.obj", obj())
        if said := self.said("transfer", source, "plain_chair.obj", "--size", "64", "-o", "o.glb", "--quiet"):
            return said
        with open(os.path.join(self.folder, "o.glb"), "rb") as file:
            data = file.read()
        length = struct.unpack_from("<I", data, 12)[0]
        document, binary = json.loads(data[20:20 + length]), data[28 + length:]
        pixels = {}
        for image in document.get("images", []):
            view = document["bufferViews"][image["bufferView"]]
            begin = view.get("byteOffset", 0)
            for pixel in pixels_of(binary[begin:begin + view["byteLength"]]):
                pixels[pixel] = pixels.get(pixel, 0) + 1
        for material in document.get("materials", []):
            factor = material.get("pbrMetallicRoughness", {}).get("baseColorFactor")
            if factor and not pixels:
                pixels[tuple(round(255 * x) for x in factor[:3])] = 1
        strongest = max(pixels or {(0, 0, 0): 1}, key=lambda p: pixels.get(p, 0) * (max(p) - min(p)))
        return "red" if strongest[0] > strongest[2] else "blue" if strongest[2] > strongest[0] else str(strongest)


def pixels_of(data):
    """The pixels of a PNG file of 8 bits, RGB or RGBA, not interlaced."""
    width, height, _, kind = struct.unpack_from(">2I2B", data, 16)
    channels, at, packed = {2: 3, 6: 4}[kind], 8, b""
    while at < len(data):
        length, name = struct.unpack_from(">I4s", data, at)
        packed += data[at + 8:at + 8 + length] if name == b"IDAT" else b""
        at += 12 + length
    raw, stride, above = zlib.decompress(packed), width * channels, None
    for y in range(height):
        kind, row = raw[y * (stride + 1)], bytearray(raw[y * (stride + 1) + 1:(y + 1) * (stride + 1)])
        above = above or bytes(stride)
        for i in range(stride):
            left, up, corner = (row[i - channels] if i >= channels else 0), above[i], (above[i - channels] if i >= channels else 0)
            guess = left + up - corner
            paeth = min((left, up, corner), key=lambda v: abs(guess - v))
            row[i] = (row[i] + (0, left, up, (left + up) // 2, paeth)[kind]) & 255
        above = bytes(row)
        for x in range(0, stride, channels):
            yield tuple(row[x:x + 3])


# The kinds of files: each function returns what came out and what is wanted --------------------------------------------

KINDS = []


def kind(name):
    def add(function):
        KINDS.append((name, function))
        return function
    return add


def parts_wanted(runner, files, wanted=6):
    """Checks that each file, (name, content), has the wanted number of parts."""
    got = []
    for name, content in files:
        runner.write(name, content)
        line = runner.summary(name)
        got.append("" if f" {wanted} parts" in f" {line}" or wanted == 1 and " 1 part" in line else f"{name}: {line}")
    told = [g for g in got if g]
    return "; ".join(told) or f"{wanted} parts each", f"{wanted} parts each"


@kind("exactly flat triangle")
def _(r):
    points = corners(((0, 0, 0), (1, 1, 1))) + [(2, y, z) for y in (0, 1) for z in (0, 1)]
    sides = [[0, 4, 8, 9, 5, 1], [1, 5, 9, 11, 7, 3], [3, 7, 11, 10, 6, 2], [2, 6, 10, 8, 4, 0]]  # with corners on their edges
    for start in range(6):
        faces = [[0, 1, 3, 2], [10, 11, 9, 8]] + [side[start:] + side[:start] for side in sides]
        r.write("box.obj", "o box\n" + "".join("v %g %g %g\n" % p for p in points) +
                "".join("f " + " ".join(str(i + 1) for i in face) + "\n" for face in faces))
        if " 1 parts" not in " " + r.summary("box.obj"):
            return r.summary("box.obj"), "1 part"
    return "1 part", "1 part"


@kind("OBJ group named again")
def _(r):
    r.write("plain.obj", obj())
    r.write("again.obj", obj(after=lambda n, k: f"g {n}\nusemtl m{k // 3}" if k % 3 == 0 else ""))
    match = r.match("plain.obj", "again.obj")
    return f"{len(match['pairs'])} pairs", "6 pairs"


@kind("FBX upright axis")
def _(r):
    r.write("y.fbx", fbx(1))
    r.write("z.fbx", fbx(2))
    return ", ".join("z up" if "z up" in r.summary(f"{axis}.fbx") else "y up" for axis in "yz"), "y up, z up"


@kind("glTF instancing")
def _(r):
    glb = Glb()
    for name in ("seat", "back"):
        glb.node(name=name, mesh=glb.mesh(BOXES[name]))
    places = [(x, 0, z) for x in (-.2, .2) for z in (-.2, .2)]
    leg = glb.mesh(((-.02, 0, -.02), (.02, .425, .02)))
    glb.node(name="leg", mesh=leg, extensions={"EXT_mesh_gpu_instancing": {"attributes": {"TRANSLATION": glb.accessor("VEC3", places)}}})
    glb.document["extensionsUsed"] = ["EXT_mesh_gpu_instancing"]
    return parts_wanted(r, [("instances.glb", glb.data())])


@kind("glTF texture transform, second set")
def _(r):
    transform = {"extensions": {"KHR_texture_transform": {"offset": [.5, 0]}}}
    left, right = (.25, .5), (.75, .5)
    r.write("plain.glb", textured({}, [left]))
    r.write("transform.glb", textured(transform, [left], extensionsUsed=["KHR_texture_transform"],
                                      extensionsRequired=["KHR_texture_transform"]))
    r.write("second.glb", textured({"texCoord": 1}, [left, right]))
    return ", ".join(r.transferred_colour(f"{n}.glb") for n in ("plain", "transform", "second")), "red, blue, blue"


@kind("PLY with several textures")
def _(r):
    r.write("red.png", png(RED, RED))
    r.write("blue.png", png(BLUE, BLUE))
    uv = "8 " + " ".join(["0.5"] * 8)
    for name, number in (("first", 0), ("last", 1)):
        number_of = lambda i, n=number: f"{uv} {n if i // 6 < 5 else 1 - n}"
        r.write(f"{name}.ply", ply(comments=("comment TextureFile red.png", "comment TextureFile blue.png"),
                                   face_property=(["property list uchar float texcoord", "property int texnumber"], number_of)))
    return ", ".join(r.transferred_colour(f"{n}.ply") for n in ("first", "last")), "red, blue"


@kind("byte order mark")
def _(r):
    mark = "\ufeff"
    return parts_wanted(r, [("first.obj", mark + obj(name=lambda n: "" if n == "seat" else f"o {n}")), ("name.obj", mark + obj()),
                            ("m.stl", mark + text_stl()), ("m.ply", ply(mark=mark)), ("m.off", off(mark + "OFF\n"))])


@kind("OFF dialects")
def _(r):
    return parts_wanted(r, [("joined.off", off("OFF")), ("joined_0.off", off("OFF ")), ("comment.off", off("OFF # chair\n# x\n")),
                            ("no_edges.off", off("OFF\n", " 36\n"))])


@kind("PLY triangle strips")
def _(r):
    return parts_wanted(r, [("strips.ply", strips(False)), ("strips_binary.ply", strips(True))])


@kind("hidden files in a folder")
def _(r):
    for name, box in BOXES.items():
        r.write(f"chair/{name}.stl", binary_stl(box))
        r.write(f"chair/._{name}.stl", b"\0\5\26\7" * 90)
    r.write("chair/.old_seat.stl", binary_stl(BOXES["seat"]))
    return r.summary("chair")[:27], "6 objects, 6 pieces, 6 part"


@kind("OBJ vertex colours")
def _(r):
    r.write("colours.obj", obj(vertex=lambda p: "v %g %g %g 1 0 0" % p))
    return r.transferred_colour("colours.obj"), "red"


@kind("STL dialects")
def _(r):
    one_by_one = "".join(text_stl({name: box}) for name, box in BOXES.items())
    return parts_wanted(r, [("upper.stl", text_stl().upper()), ("concatenated.stl", one_by_one),
                            ("no_footer.stl", text_stl(footer=lambda n: "endsolid")), ("no_name.stl", text_stl(header=lambda n: "solid"))])


@kind("binary STL files put together")
def _(r):
    return parts_wanted(r, [("binary.stl", b"".join(binary_stl(box, b"solid " + name.encode()) for name, box in BOXES.items()))])


@kind("names of parents in glTF")
def _(r):
    glb = Glb()
    children = []
    for i, (name, box) in enumerate(BOXES.items()):
        child = glb.node(root=False, name=f"Object_{2 * i + 4}", mesh=glb.mesh(box))
        children.append(glb.node(root=False, name=name, children=[child]))
    glb.node(name="Sketchfab_model", children=children)
    r.write("wrapped.glb", glb.data())
    return " ".join(r.names("wrapped.glb")), " ".join(sorted(BOXES))


@kind("carriage returns")
def _(r):
    return parts_wanted(r, [("mac.obj", obj(eol="\r")), ("mac.ply", ply("\r")), ("mac.stl", text_stl().replace("\n", "\r")),
                            ("mac.off", off("OFF\n").replace("\n", "\r")), ("dos.obj", obj(eol="\r\n"))])


@kind("OBJ groups of faces in objects")
def _(r):
    return parts_wanted(r, [("faces.obj", obj(after=lambda n, k: f"g {n}_side{k}"))])


@kind("backslash ends a comment or a name")
def _(r):
    vertex_first = obj(name=lambda n: "" if n == "seat" else f"o {n}")
    return parts_wanted(r, [("comment.obj", "# from C:\\models\\\n" + vertex_first), ("name.obj", "# from C:\\models\\\n" + obj()),
                            ("material.obj", obj(after=lambda n, k: "usemtl C:\\tmp\\" if k == 0 else ""))])


@kind("upright axis by command")
def _(r):
    r.write("z.obj", obj(lying(BOXES)))
    return f"{'z up' if 'z up' in r.summary('z.obj') else 'y up'}", "z up"


@kind("copies in one place")
def _(r):
    boxes = {}
    for name, box in BOXES.items():
        boxes[name] = boxes[f"{name}_collision"] = box
    r.write("copies.obj", obj(boxes))
    match = r.match("copies.obj", "copies.obj")
    same = all(a == b for a, b in match["pairs"])
    return f"{len(match['pairs'])} pairs, {'the same' if same else 'others'}, {match.get('energy', -1):g}", "12 pairs, the same, 0"


@kind("FBX in centimetres and metres")
def _(r):
    r.write("cm.fbx", fbx(1))
    r.write("m.fbx", fbx(2, unit=100))
    match = r.match("cm.fbx", "m.fbx")
    return f"{len(match['pairs'])} pairs, {match.get('energy', -1):.4f}", "6 pairs, 0.0000"


@kind("parts written and read back")
def _(r):
    order = ["back", "left legs", "right%41legs", "seat"]  # either part of legs has two pieces
    pairs = obj(lying(BOXES), name=lambda n: {"leg_fl": "o left legs", "leg_fr": "o right%41legs"}.get(n, "" if n[:3] == "leg" else f"o {n}"))
    r.write("z.obj", pairs)
    r.run("parts", "z.obj", "--parts", "file", "--parts-json", "list.json")
    told = []
    for form in ("o.obj", "o.ply", "o.glb", "folder", "seg/z.seg"):
        r.write("seg/z.obj", pairs)
        said = r.said("parts", "z.obj" if form[:3] != "seg" else "seg/z.obj", "--parts", "file", "--up", "z", "-o", form)
        back = "seg/z.obj" if form[:3] == "seg" else form
        names = r.names(back)
        match = r.match("z.obj", back, "--source-parts-from", "list.json", "--source-up", "z")
        same = names == order and len(match["pairs"]) == 4 and all(a == b for a, b in match["pairs"])
        if said or not same or (form != "o.glb" and match["energy"] > 1e-6):  # GLB has single precision
            told.append(f"{form}: {said or names} {match.get('energy')} {match.get('error', '')}")
    return "; ".join(told) or "the same parts", "the same parts"


@kind("lists of labels written for another model")
def _(r):
    r.write("a.obj", obj())
    r.write("b.obj", obj())
    r.run("parts", "a.obj", "-o", "b.seg")
    _, _, error, _ = r.run("graph", "b.obj", "-q", "-o", "g.json")
    with open(os.path.join(r.folder, "g.json")) as file:
        warnings = " ".join(json.load(file)["warnings"])
    return f"{'written for' in error} {'written for' in warnings} {' '.join(r.names('b.obj'))}", f"True True {' '.join(sorted(BOXES))}"


@kind("lists of labels that are none")
def _(r):
    r.write("m.obj", obj())
    told = []
    labels = [str(i // 6) for i in range(36)]
    for line, text in ((4, "0.5"), (4, "-0"), (4, "leg"), (4, "1 2"), (4, "")):
        r.write("l.seg", "\n".join(labels[:3] + [text] + labels[4:]) + "\n")
        status, _, error, _ = r.run("parts", "m.obj", "--parts-from", "l.seg")
        if status != 1 or f"line {line}" not in error or "; write one whole number" not in error:
            told.append(f"{text}: {status} {error}")
    r.write("l.seg", "\n".join(labels) + "\n\n# of faces\n\n")
    told += [said for said in [r.said("parts", "m.obj", "--parts-from", "l.seg")] if said]
    r.write("m.seg", "3\n" * 36)
    told += [] if "no parts, since all faces have the label" in r.run("graph", "m.obj")[1] else ["one label: no note"]
    return "; ".join(told) or "errors", "errors"


@kind("labels of PLY in other words")
def _(r):
    files = [(f"{n}.ply", ply(face_property=([f"property int {n}"], lambda i: str(i // 6))))
             for n in ("Label", "LABEL", "segmentation", "scalar_Label", "SegmentID")]
    head, rest = ply().split("end_header\n")
    rows = rest.split("\n")
    rows = [f"{row} {i // 8}" for i, row in enumerate(rows[:48])] + rows[48:]
    head = head.replace("element face", "property uchar label\nelement face")
    # Three labels, since the pieces of the object would be six parts as well
    files3 = [("vertices.ply", head + "end_header\n" + "\n".join(f"{row.rsplit(' ', 1)[0]} {i // 16}" if i < 48 else row
                                                               for i, row in enumerate(rows)))]
    one, six = parts_wanted(r, files3, 3), parts_wanted(r, files)
    return f"{one[0]}, {six[0]}", f"{one[1]}, {six[1]}"


@kind("objects without faces")
def _(r):
    r.write("m.obj", obj() + "o curve\nv 0 0 0\nv 1 0 0\nl 49 50\no nothing\n")
    r.write("m.stl", text_stl() + "solid nothing\nendsolid nothing\n")
    notes = [r.run("graph", f"m.{kind}", "--parts", "file")[1] for kind in ("obj", "stl")]
    told = [name for note in notes for name in ("'curve'", "'nothing'") if name in note and "left out" in note]
    return " ".join(told), "'curve' 'nothing' 'nothing'"


@kind("URDF elements that lack something")
def _(r):
    told = []
    for shape, word in (('cylinder length="1"', "radius"), ('cylinder radius="1"', "length"), ('sphere radius="-1"', "radius"),
                        ("box", "size"), ('box size="1 1 0"', "size"), ('box size="1 1 1 1"', "size"), ("mesh", "filename"),
                        ('mesh filename="a.obj" scale="1 0 1"', "scale")):
        r.write("a.obj", obj())
        links = "".join(f'<link name="{n}"><visual><geometry><{g}/></geometry></visual></link>' for n, g in
                        (("base", 'sphere radius="1"'), ("arm", shape)))
        r.write("r.urdf", f'<robot name="r">{links}<joint name="j"><parent link="base"/><child link="arm"/></joint></robot>')
        status, _, error, _ = r.run("parts", "r.urdf")
        element = shape.split()[0]
        if status != 1 or not all(w in error for w in ("r.urdf", "link 'arm'", f"<{element}>", word, "; write" if "1 1 1" not in error else "; correct")):
            told.append(f"{shape}: {status} {error.strip()[:80]}")
    return "; ".join(told) or "errors", "errors"


@kind("hierarchy of PartNet")
def _(r):
    files = {}
    for i, (name, box) in enumerate(BOXES.items()):
        files[name] = f"new-{i}"
        r.write(f"173/objs/new-{i}.obj", obj({name: box}))
    node = lambda name, objs=(), children=(): {"name": name, "text": name, **({"objs": list(objs)} if objs else {}),
                                               **({"children": list(children)} if children else {})}
    legs = [node("leg", [files[n]]) for n in BOXES if n[:3] == "leg"]
    tree = [node("chair", children=[node("chair_seat", [files["seat"]]), node("chair_back", [files["back"]]),
                                    node("chair_base", children=legs[:2] + [node("foot_pair", legs[2]["objs"] + legs[3]["objs"])])])]
    r.write("173/result.json", json.dumps(tree))
    got = " ".join(r.names("173"))
    for objs, word in ((["new-9"], "new-9"), ([], "none of its nodes lists files")):
        r.write("173/result_after_merging.json", json.dumps([node("chair", objs)]))
        said = r.run("parts", "173")[2]
        got += "" if word in said else f", {word}: {said}"
    return got, "chair_back chair_seat foot_pair leg leg#2"


@kind("far and tiny parts")
def _(r):
    told = []
    for far in (1e7, 1e9, 1e12):
        points = [(0, 0, 0), (1, 0, 0), (.5, -.7568, -.6537), (.5, -.959, .2837), (.5, -.2794, .9602)]
        tiny = [(0, 0, 0), (0, 0, 1.7e-6), (1.7e-6, 0, 0), (1.7e-6, 0, 1.7e-6)]
        r.write("far.obj", "".join("v %r %r %r\n" % (x, y - far, z + far) for x, y, z in points) + "".join("v %r %r %r\n" % p for p in tiny) +
                "o fan\nf 1 2 3\nf 1 2 4\nf 1 2 5\no bow\nf 6 9 7 8\n")
        status, _, error, _ = r.run("graph", "far.obj")
        told.append("" if status == 0 or status == 1 and "far.obj" in error else f"{status} {error[:60]}")
    return "; ".join(t for t in told if t) or "a graph or an error", "a graph or an error"


@kind("order of triangles")
def _(r):
    shuffled = random.Random(1)
    outcomes = set()
    for order in range(3):
        text = ""
        first = 1
        for name, (low, high) in BOXES.items():
            points = corners((low, high))
            faces = triangles_of(QUADS)
            if order:
                shuffled.shuffle(faces)
            text += f"o {name}\n" + "".join("v %g %g %g\n" % p for p in points)
            text += "".join("f " + " ".join(str(first + i) for i in t) + "\n" for t in faces)
            first += 8
        r.write("order.obj", text)
        status, out, _, _ = r.run("graph", "order.obj", "-o", "-", "--quiet")
        graph = json.loads(out) if status == 0 else {}
        for part in graph.get("parts", []):
            part.get("abstraction", {}).pop("seconds", None)
        outcomes.add(json.dumps(graph.get("parts")))
    return f"{len(outcomes)} graphs", "1 graphs"


@kind("limit of the search time")
def _(r):
    rng = random.Random(7)
    boxes = {}
    for i in range(150):
        low = [rng.uniform(0, 10) for _ in range(3)]
        boxes[f"p{i}"] = (tuple(low), tuple(x + rng.uniform(1, 11) for x in low))
    r.write("many.obj", obj(boxes))
    r.run("graph", "many.obj", "--parts", "file", "--abstraction", "boxes", "-o", "g.json")
    told = []
    for search in ("exact", "beam"):
        status, _, error, seconds = r.run("match", "g.json", "g.json", "--search", search, "--search-time-limit", "3", "--quiet")
        told.append("" if seconds < 20 and status in (0, 1) else f"{search}: {seconds:.0f} s, status {status} {error[:40]}")
    return "; ".join(t for t in told if t) or "kept", "kept"


@kind("FIFO in place of a graph in the cache")
def _(r):
    r.write("chair.obj", obj())
    r.run("graph", "chair.obj", "--cache", "cache", "--quiet")
    cache = os.path.join(r.folder, "cache")
    for folder, _, files in os.walk(cache):
        for file in files:
            os.remove(os.path.join(folder, file))
            os.mkfifo(os.path.join(folder, file))
    status, _, error, _ = r.run("graph", "chair.obj", "--cache", "cache", "--quiet")
    return "made anew, or an error" if status in (0, 1) else error, "made anew, or an error"


def main():
    programs = sys.argv[1:3]
    if not programs:
        sys.exit(__doc__)
    failures = 0
    for name, function in KINDS:
        rows = []
        for program in programs:
            with tempfile.TemporaryDirectory() as folder:
                try:
                    got, wanted = function(Runner(program, folder))
                except (OSError, ValueError, KeyError) as error:
                    got, wanted = f"{type(error).__name__}: {error}", None
                rows.append("ok" if got == wanted else got)
        failures += rows[0] != "ok"
        print(f"{name}: " + "  | before: ".join(rows), flush=True)
    print(f"{len(KINDS) - failures} of {len(KINDS)} kinds are as wanted")
    sys.exit(failures > 0)


if __name__ == "__main__":
    main()

#!/usr/bin/env python3
# Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
# SPDX-License-Identifier: GPL-3.0-or-later
"""Makes one file of the page, the program as a WebAssembly module, and the models of data/; the same bytes from the same files.

  make_page.py MODULE.js VIEWER.js DATA OUTPUT.html

Needs `zopfli`, which packs better than gzip what browsers unpack alike.
"""
import base64
import hashlib
import json
import os
import re
import shutil
import subprocess
import sys
import tempfile

HERE = os.path.dirname(os.path.abspath(__file__))


def read(*path):
    with open(os.path.join(*path), encoding="utf-8") as file:
        return file.read()


def script(*modules):
    """Modules as one script: each import is one line, and what they define differs in name."""
    text = re.sub(r"^import .*\n", "", "".join(read(module) for module in modules), flags=re.M)
    return "(() => {\n'use strict';\n" + re.sub(r"^export ", "", text, flags=re.M) + "})();\n"


def policy_of(text):
    return "'sha256-" + base64.b64encode(hashlib.sha256(text.encode()).digest()).decode() + "'"


def packed(data):
    program = shutil.which("zopfli") or sys.exit("make_page.py: zopfli is missing; scripts/install_packages zopfli installs it")
    with tempfile.NamedTemporaryFile() as file:
        file.write(data)
        file.flush()
        return base64.b64encode(subprocess.run([program, "--i5", "-c", file.name], check=True, stdout=subprocess.PIPE).stdout).decode()


def differences(numbers):
    return [number - before for number, before in zip(numbers, [0, *numbers])]


def packed_part(path):
    """What page/examples.js makes the text of an OBJ file of, since few bytes tell how numbers differ from those before."""
    name = os.path.splitext(os.path.basename(path))[0]
    points, triangles = [], []
    for line in read(path).splitlines():
        if re.fullmatch(r"v( -?\d+\.\d{5}){3}", line):
            points.append([int(number.replace(".", "")) for number in line.split()[1:]])
        elif re.fullmatch(r"f( \d+){3}", line):
            triangles += [int(corner) for corner in line.split()[1:]]
        elif line != "o " + name:
            sys.exit(f"make_page.py: {path}: a line of another form than those of examples: {line}")
    return {"name": name, "coordinates": [differences(numbers) for numbers in zip(*points)], "corners": differences(triangles)}


def examples(data, names):
    folders = {name: os.path.join(data, name, "parts") for name in names}
    models = {name: [packed_part(os.path.join(folder, part)) for part in sorted(os.listdir(folder))]
              for name, folder in folders.items()}
    return json.dumps(models, separators=(",", ":")).encode()


def main(module, viewer, data, output):
    page = os.path.join(HERE, "page")
    names = sorted(name for name in os.listdir(data) if os.path.isdir(os.path.join(data, name, "parts")))
    unpacked = os.path.join(page, "unpacked.js")
    own = script(os.path.join(HERE, "..", "src", "viewer", "page", "dom.js"), unpacked, os.path.join(page, "examples.js"),
                 os.path.join(page, "app.js"))
    with open(os.path.splitext(module)[0] + ".wasm", "rb") as file:
        program = packed(file.read())
    content = {"HASHES": policy_of(own) + " " + policy_of(read(viewer)), "STYLE": read(page, "app.css"), "MODULE": read(module),
               "WORKER": script(unpacked, os.path.join(page, "worker.js")), "PROGRAM": program, "NAMES": " ".join(names),
               "EXAMPLES": packed(examples(data, names)), "SCRIPT": own}
    for name in ("MODULE", "WORKER", "SCRIPT"):
        if re.search(r"</script|<!--", content[name], re.I):
            sys.exit(f"make_page.py: the script {name} would end its element")
    with open(output, "w", encoding="utf-8", newline="\n") as file:
        file.write(re.sub("@([A-Z]+)@", lambda place: content[place[1]], read(page, "app.html")))


if __name__ == "__main__":
    main(*sys.argv[1:])

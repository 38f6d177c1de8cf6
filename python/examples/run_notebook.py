# Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
# SPDX-License-Identifier: GPL-3.0-or-later
"""Runs a notebook and writes its outputs into it: printed text and the figures of matplotlib.

    run_notebook.py NOTEBOOK           runs it, in the current folder
    run_notebook.py NOTEBOOK --check   fails if the printed text is not what the notebook holds; changes nothing
"""

import base64
import contextlib
import io
import json
import sys


def figures():
    """The open figures of matplotlib as PNG, which are closed."""
    if "matplotlib.pyplot" not in sys.modules:
        return
    import matplotlib.pyplot as plt

    for number in plt.get_fignums():
        png = io.BytesIO()
        plt.figure(number).savefig(png, format="png", dpi=80, metadata={"Software": None})
        yield base64.b64encode(png.getvalue()).decode()
    plt.close("all")


def run(code, names):
    """The outputs of a cell."""
    printed = io.StringIO()
    with contextlib.redirect_stdout(printed):
        exec(code, names)
    outputs = []
    if printed.getvalue():
        outputs.append({"name": "stdout", "output_type": "stream", "text": printed.getvalue().splitlines(True)})
    outputs += [{"data": {"image/png": png}, "metadata": {}, "output_type": "display_data"} for png in figures()]
    return outputs


def text(cell):
    """What a cell has printed."""
    return "".join(line for output in cell["outputs"] for line in output.get("text", []))


def main(path, check):
    with open(path, encoding="utf-8") as file:
        notebook = json.load(file)
    names = {"__name__": "__main__"}
    for count, cell in enumerate((c for c in notebook["cells"] if c["cell_type"] == "code"), 1):
        expected = text(cell)
        cell["outputs"], cell["execution_count"] = run("".join(cell["source"]), names), count
        if check and text(cell) != expected:
            sys.exit(f"{path}: cell {count} prints\n{text(cell)}\nand the notebook has\n{expected}\nrun {__file__}")
    if not check:
        with open(path, "w", encoding="utf-8") as file:
            file.write(json.dumps(notebook, indent=1, ensure_ascii=False) + "\n")


if __name__ == "__main__":
    main(sys.argv[1], "--check" in sys.argv[2:])

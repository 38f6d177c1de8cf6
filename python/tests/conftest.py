# Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
# SPDX-License-Identifier: GPL-3.0-or-later
import json
import os
import subprocess
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parents[2]


@pytest.fixture(scope="session")
def data():
    """The folder of models."""
    return ROOT / "data"


@pytest.fixture(scope="session")
def cache(tmp_path_factory):
    """A folder that keeps graphs, of the module and of the program."""
    return tmp_path_factory.mktemp("cache")


@pytest.fixture(scope="session")
def program():
    """Runs the program, in the folder of the sources."""
    path = os.environ.get("SHAPE_CORRESPONDENCE_PROGRAM")
    if path is None:
        pytest.skip("SHAPE_CORRESPONDENCE_PROGRAM does not name the program")

    def run(*arguments):
        return subprocess.run([path, *map(str, arguments)], cwd=ROOT, capture_output=True, text=True)

    return run


@pytest.fixture
def json_of_program(program):
    """The JSON that a command of the program writes."""

    def run(*arguments):
        result = program(*arguments, "--json", "-")
        assert result.returncode == 0, result.stderr
        return json.loads(result.stdout)

    return run


@pytest.fixture(scope="session")
def box():
    """Makes the triangles of a box from its least and greatest corner."""
    import numpy as np

    faces = np.array([[0, 2, 3], [0, 3, 1], [4, 5, 7], [4, 7, 6], [0, 1, 5], [0, 5, 4],
                      [2, 6, 7], [2, 7, 3], [0, 4, 6], [0, 6, 2], [1, 3, 7], [1, 7, 5]])

    def make(low, high):
        corners = np.array([[(low, high)[i >> k & 1][k] for k in range(3)] for i in range(8)], float)
        return corners, faces

    return make


@pytest.fixture(scope="session")
def table(box):
    """Makes a table of five boxes: triples (name, V, F)."""

    def make(width=1.2, height=0.7):
        legs = [("leg_%d" % i, *box((x - .03, 0, z - .03), (x + .03, height, z + .03)))
                for i, (x, z) in enumerate([(-width / 2 + .05, -.3), (width / 2 - .05, -.3),
                                            (-width / 2 + .05, .3), (width / 2 - .05, .3)])]
        return [("top", *box((-width / 2, height, -.4), (width / 2, height + .04, .4))), *legs]

    return make

# Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
# SPDX-License-Identifier: GPL-3.0-or-later
"""Options have the names and defaults of the library, and all are documented."""

import inspect
import re

import pytest

import shape_correspondence as sc
from shape_correspondence import _core

LIBRARY = _core.default_options()


def defaults(function):
    return {name: list(p.default) if p.default == () else p.default
            for name, p in inspect.signature(function).parameters.items() if p.default is not p.empty}


@pytest.mark.parametrize("function", [sc.match, sc.build_graph, sc.blend, sc.evaluate])
def test_defaults_are_those_of_the_library(function):
    python = defaults(function)
    for name, value in LIBRARY[function.__name__].items():
        if name == "part_matching":  # None stands for the library's
            assert python[name] is None
            continue
        assert python[name] == value, name


def test_part_matching():
    assert LIBRARY["match"]["part_matching"]["overlap"] == 2
    for name in LIBRARY["match"]["part_matching"]:
        assert f"``{name}``" in sc.match.__doc__, name


def test_defaults_of_a_collection():
    python = defaults(sc.collection)
    for name, value in LIBRARY["collection"].items():
        assert python[name] == value, name


def test_defaults_of_reading():
    python = defaults(sc.read)
    assert python["parts"] == LIBRARY["read"]["parts"]
    assert LIBRARY["read"]["up"] == LIBRARY["read"]["parts_from"] == LIBRARY["read"]["cache"] == ""  # None in Python
    assert defaults(sc.match)["threads"] == LIBRARY["read"]["threads"]


def test_names_are_those_of_named_parameters(data):
    header = (data.parent / "include/CGAL/Shape_correspondence/parameters.h").read_text()
    names = re.findall(r"^  X\((\w+),\s*(\w+_options)", header, re.MULTILINE)
    assert len(names) > 20
    python = {"Search_options": defaults(sc.match), "Structure_options": defaults(sc.build_graph)}
    for name, structure in names:
        assert name in python[structure], name


def test_paper_options():
    assert sc.paper_options() == {"search_method": "beam", "alignments": 0, "coarse_target": False}


@pytest.mark.parametrize("name", sc.__all__)
def test_all_that_is_public_is_documented(name):
    thing = getattr(sc, name)
    if name != "roles":
        assert thing.__doc__ and not thing.__doc__.startswith(f"{name}("), name
    functions = vars(thing).values() if inspect.isclass(thing) or inspect.ismodule(thing) else [thing]
    for function in functions:
        if not inspect.isfunction(function) or function.__name__.startswith("_") or not function.__module__.startswith(
                "shape_correspondence"):
            continue
        if function.__name__ == "__eq__":
            continue
        assert function.__doc__, function
    if inspect.isfunction(thing):
        for parameter in inspect.signature(thing).parameters:
            assert f":param {parameter}:" in thing.__doc__ or parameter in ("cache", "threads", "progress"), parameter


def test_unknown_options_are_refused(table):
    with pytest.raises(TypeError):
        sc.match(table(), table(), beam_widht=3)
    with pytest.raises(TypeError):
        sc.match(table(), table(), part_matching={"ovrlap": 3})
    with pytest.raises(TypeError):
        sc.collection([table(), table()], solutions=2)
    with pytest.raises(TypeError):
        sc.blend(table(), table(), "result.json", beam_width=3)


@pytest.mark.parametrize("options", [{"search_method": "fast"}, {"min_confidence": 2}, {"search_method": "beam", "beam_width": 0},
                                     {"energy_norm": "max"}, {"source_parts": ["seat"]}, {"target_parts": [5]},
                                     {"search_method": "beam", "roles": sc.roles.load()}, {"alignments": -1},
                                     {"part_matching": {"excess": -1}}])
def test_options_out_of_range(table, options):
    with pytest.raises(sc.InvalidInput):
        sc.match(table(), table(), **options)


def test_the_wrong_type_of_an_option(table):
    with pytest.raises(TypeError):
        sc.match(table(), table(), beam_width="wide")

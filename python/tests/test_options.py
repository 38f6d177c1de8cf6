# Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
# SPDX-License-Identifier: GPL-3.0-or-later
"""Options have the names and defaults of the library, and all are documented."""

import inspect
import re

import pytest

import shape_correspondence as sc
from shape_correspondence import _core, _options


def defaults(function):
    return {name: p.default for name, p in inspect.signature(function).parameters.items() if p.default is not p.empty}


@pytest.mark.parametrize("function", [sc.match, sc.read, sc.build_graph, sc.blend, sc.collection])
def test_options_are_those_of_the_table(function):
    python = defaults(function)
    options = _core.options_of(function.__name__)
    assert options
    for name, value, text in options:
        assert python[name] == value, name
        assert text and f":param {name}: " in function.__doc__, name


def test_options_and_defaults_of_a_match():
    assert list(defaults(sc.match))[:5] == ["part_matching", "roles", "pinned", "forbidden", "source_parts"]
    expected = {"search_method": "parts", "category": None, "min_confidence": 0, "beam_width": 20, "expansions": 4,
                "role_weight": 0, "feature_weight": 3, "paper": False, "cut_curves": True, "unmatched_cost": float("inf"),
                "maximum_parts": 0, "coarse_to_fine": 0, "alignments": 1, "front_is_sure": False, "solutions": 1,
                "min_marginals": False}
    assert {name: value for name, value, _ in _core.options_of("match")} == expected


def test_part_matching():
    library = {name: value for name, value, _ in _core.options_of("part_matching")}
    assert library["overlap"] == 2
    for name in library:
        assert f"``{name}``" in sc.match.__doc__, name


def test_names_are_those_of_named_parameters(data):
    header = (data.parent / "include/CGAL/Shape_correspondence/parameters.h").read_text()
    names = re.findall(r"^  X\((\w+),\s*(\w+_options)", header, re.MULTILINE)
    assert len(names) > 10
    python = {"Search_options": defaults(sc.match), "Structure_options": defaults(sc.build_graph)}
    for name, structure in names:
        assert name in python[structure], name


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


@pytest.mark.parametrize("call, suggestion", [
    (lambda table: sc.match(table, table, serach="exact"), "search"),
    (lambda table: sc.match(table, table, allow_unmatch=1), "allow_unmatched"),
    (lambda table: sc.build_graph(table, no_symetry=True), "no_symmetry"),
    (lambda table: sc.nearest(table, [table], max_part=3), "max_parts"),
])
def test_suggestions(table, call, suggestion):
    with pytest.raises(TypeError, match=f"did you mean '{suggestion}'"):
        call(table())


def test_every_option_of_the_program_is_taken(program, tmp_path):
    without_meaning_here = {"abstraction", "examples", "glb", "help", "help_all", "html", "json", "output", "parts_json", "progress", "quiet",
                            "search_time_limit", "seed", "verbose"}
    for name in set(re.findall(r"--([a-z][a-z-]+)", program("match", "--help").stdout)):
        name = name.replace("-", "_")
        known = {*defaults(sc.match), *defaults(sc.read), *defaults(sc.build_graph), *_options._OF_PROGRAM}
        assert name in known | without_meaning_here or re.match("(source|target)_(up|front|parts)", name), name


def test_an_option_under_two_names(table):
    with pytest.raises(TypeError, match="not both"):
        sc.match(table(), table(), search="exact", search_method="beam")
    with pytest.raises(TypeError, match="read already"):
        sc.match(sc.build_graph(table()), table(), kind="curve")
    with pytest.raises(sc.InvalidInput, match="front"):
        sc.match(table(), table(), front="left")


def test_unknown_options_are_refused(table):
    with pytest.raises(TypeError, match="beam_width"):
        sc.match(table(), table(), beam_widht=3)
    with pytest.raises(TypeError):
        sc.match(table(), table(), part_matching={"ovrlap": 3})
    with pytest.raises(TypeError):
        sc.collection([table(), table()], solutions=2)
    with pytest.raises(TypeError):
        sc.blend(table(), table(), "result.json", beam_width=3)


@pytest.mark.parametrize("options", [{"search_method": "fast"}, {"min_confidence": 2}, {"search_method": "beam", "beam_width": 0},
                                     {"source_parts": ["seat"]}, {"target_parts": [5]},
                                     {"search_method": "beam", "roles": sc.roles.load()}, {"alignments": -1},
                                     {"part_matching": {"excess": -1}}])
def test_options_out_of_range(table, options):
    with pytest.raises(sc.InvalidInput):
        sc.match(table(), table(), **options)


def test_the_wrong_type_of_an_option(table):
    with pytest.raises(TypeError):
        sc.match(table(), table(), beam_width="wide")

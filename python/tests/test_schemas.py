# Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
# SPDX-License-Identifier: GPL-3.0-or-later
"""The JSON that the program writes is as the schemas say, and has no other keys."""

import json

import pytest

TABLE, OTHER, THIRD = "data/table_four_legged", "data/table_trestle", "data/table_pedestal"
EXACT = ("--search", "exact", "--solutions", 2, "--min-marginals", "--allow-unmatched", 0.5)


def closed(schema):
    """The schema without further keys."""
    if isinstance(schema, list):
        return [closed(part) for part in schema]
    if not isinstance(schema, dict):
        return schema
    result = {key: closed(part) for key, part in schema.items()}
    if isinstance(schema.get("properties"), dict):
        result["additionalProperties"] = False
    return result


@pytest.fixture(scope="module")
def check(data):
    jsonschema = pytest.importorskip("jsonschema")
    folder = data.parent / "doc" / "Shape_correspondence" / "schemas"

    def run(document):
        path = folder / (document["format"].split("/")[1] + ".schema.json")
        schema = json.loads(path.read_text(encoding="utf-8"))
        jsonschema.Draft202012Validator.check_schema(schema)
        jsonschema.Draft202012Validator(closed(schema)).validate(document)
        jsonschema.Draft202012Validator(schema).validate({**document, "key of later versions": 1})
        for key in schema["required"]:
            with pytest.raises(jsonschema.ValidationError):
                jsonschema.validate({name: value for name, value in document.items() if name != key}, schema)

    return run


@pytest.mark.parametrize("arguments", [
    ("match", TABLE, OTHER),
    ("match", TABLE, OTHER, *EXACT),
    ("match", TABLE, "data/chair_swivel", "--paper"),
    ("graph", TABLE),
    ("graph", "data/chair_swivel"),
    ("collection", TABLE, OTHER, THIRD, "--matches"),
    ("collection", OTHER, THIRD, "--nearest", TABLE),
    ("collection", OTHER, THIRD, "--labels-from", TABLE),
    ("roles", "predict", TABLE),
])
def test_commands(json_of_program, check, cache, arguments):
    check(json_of_program(*arguments, "--cache", cache))


def test_files(program, json_of_program, check, cache, tmp_path):
    shared = ("--cache", cache)
    check(json_of_program("blend", TABLE, OTHER, *shared, "-o", tmp_path / "blend.glb", "--frames", 3))
    check(json_of_program("transfer", TABLE, OTHER, *shared, "--labels", "parts", "--size", 64, "-o",
                          tmp_path / "looks.ply"))
    program("match", TABLE, OTHER, *shared, "--json", tmp_path / "match.json")
    check(json_of_program("evaluate", tmp_path / "match.json", "--ground-truth", "data"))
    program("graph", "data/raw/chair_swivel.obj", *shared, "-o", tmp_path / "graph.json", "--parts-json",
            tmp_path / "parts.json")
    check(json.loads((tmp_path / "parts.json").read_text()))

# Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
# SPDX-License-Identifier: GPL-3.0-or-later
"""The module gives the same results as the program, to the bit."""

import json
import pathlib

import pytest

import shape_correspondence as sc

TABLE, OTHER = "data/table_four_legged", "data/table_trestle"


@pytest.fixture(autouse=True)
def in_the_sources(monkeypatch, data):
    monkeypatch.chdir(data.parent)


def without_times(result):
    return {key: value for key, value in result.items() if key != "seconds"}


def as_text(result):
    return json.dumps(without_times(result))  # tells -0.0 from 0.0, and the order of keys


@pytest.mark.parametrize("arguments, options", [
    ((), {}),
    (("--roles", "none", "--min-confidence", 0.5), {"roles": None, "min_confidence": 0.5}),
    (("--paper",), {"paper": True}),
    (("--paper", "--abstraction", "fitted"), {"paper": True, "abstraction": "fitted"}),
    (("--role-weight", 1), {"role_weight": 1, "search": "exact"}),
    (("--search", "exact", "--solutions", 3, "--min-marginals"),
     {"search_method": "exact", "solutions": 3, "min_marginals": True}),
    (("--search", "beam", "--no-cut", "--allow-unmatched", 0.7),
     {"search_method": "beam", "cut_curves": False, "unmatched_cost": 0.7}),
])
def test_match(json_of_program, cache, arguments, options):
    expected = json_of_program("match", TABLE, OTHER, "--cache", cache, *arguments)
    found = sc.match(TABLE, OTHER, cache=cache, **options)
    assert as_text(found.to_dict()) == as_text(expected)
    assert as_text(sc.Match.from_dict(expected).to_dict()) == as_text(expected)


def test_graph_of_the_other_abstraction(cache):
    flow, fitted = (sc.build_graph(TABLE, abstraction=word, cache=cache) for word in ("flow", "fitted"))
    warning = "abstracted by mean curvature flow"
    assert [warning in text for text in sc.match(flow, fitted).warnings] == [True]
    assert [warning in text for text in sc.match(flow, fitted, abstraction="flow").warnings] == [True]
    assert not sc.match(fitted, fitted).warnings
    assert [warning in text for text in sc.match(flow, fitted, paper=True).warnings] == [True]


@pytest.mark.parametrize("arguments, options", [
    (("--search", "exact", "--no-cut", "--allow-unmatched", 0.7), {"search": "exact", "no_cut": True, "allow_unmatched": 0.7}),
    (("--search", "beam", "--max-parts", 4, "--front", "auto"), {"search": "beam", "max_parts": 4, "front": "auto"}),
    (("--roles", "none", "--pin", "top_board=plank_top", "--source-parts", "top_board,post_1", "--front", "given"),
     {"roles": "none", "pin": "top_board=plank_top", "source_parts": "top_board,post_1", "front": "given"}),
    (("--no-symmetry", "--part-kind", "top_board=sheet", "--max-iterations", 9, "--up", "y"),
     {"no_symmetry": True, "part_kind": "top_board=sheet", "max_iterations": 9, "up": "y"}),
    (("--symmetries", "reflection", "--segment"), {"symmetries": "reflection", "segment": True}),
])
def test_options_by_their_names_in_the_program(json_of_program, arguments, options):
    assert as_text(sc.match(TABLE, OTHER, **options).to_dict()) == as_text(json_of_program(
        "match", TABLE, OTHER, *arguments))


def test_transfer_looks(json_of_program, cache, tmp_path):
    paths = [str(tmp_path / name) for name in ("program.ply", "module.ply")]
    expected = json_of_program("transfer", TABLE, OTHER, "--cache", cache, "--labels", "parts", "--size", 64, "-o",
                               paths[0])
    found = sc.transfer_looks(sc.match(TABLE, OTHER, cache=cache), paths[1], labels="parts", size=64).to_dict()
    assert as_text({**found, "output": ""}) == as_text({**expected, "output": ""})
    assert open(paths[0], "rb").read() == open(paths[1], "rb").read()
    with pytest.raises(sc.InvalidInput, match="--labels parts"):
        sc.transfer_looks(sc.match(TABLE, OTHER, cache=cache), paths[1])


def test_chosen_parts(json_of_program, cache):
    expected = json_of_program("match", TABLE, OTHER, "--cache", cache, "--source-parts",
                               ",".join(sc.build_graph(TABLE, cache=cache).part_names[:3]))
    found = sc.match(TABLE, OTHER, cache=cache, source_parts=[0, 1, 2])
    assert as_text(found.to_dict()) == as_text(expected)


def test_graph_without_a_cache(json_of_program):
    expected = json_of_program("graph", TABLE)
    assert as_text(sc.build_graph(TABLE).to_dict()) == as_text(expected)
    assert as_text(sc.build_graph(sc.read(TABLE)).to_dict()) == as_text(expected)
    assert as_text(sc.build_graph(TABLE, threads=1).to_dict()) == as_text(expected)


def test_a_model_that_is_read_has_the_parts_of_its_graph(tmp_path):
    meshes = [(vertices, faces) for _, vertices, faces in sc.read("data/airplane_propeller").parts]
    lines, before = ["o all"], 1  # one object, so that its parts are found
    for vertices, faces in meshes:
        lines += ["v " + " ".join(map(repr, map(float, v))) for v in vertices] + ["f " + " ".join(map(str, f + before)) for f in faces]
        before += len(vertices)
    model = tmp_path / "one.obj"
    model.write_text("\n".join(lines) + "\n")
    shape, graph = sc.read(model), sc.build_graph(model)
    assert [name for name, _, _ in shape.parts] == graph.part_names
    assert as_text(sc.build_graph(shape).to_dict()) == as_text(graph.to_dict())


def test_graph_options(json_of_program):
    expected = json_of_program("graph", TABLE, "--no-symmetry", "--kind", "curve", "--curve-points", 5,
                               "--contact-tolerance", 0.1)
    found = sc.build_graph(TABLE, detect_symmetry=False, kind="curve", curve_points=5, contact_tolerance=0.1)
    assert as_text(found.to_dict()) == as_text(expected)


def test_blend(json_of_program, cache, tmp_path):
    expected = json_of_program("blend", TABLE, OTHER, "--cache", cache, "-o", tmp_path / "blend.glb", "--frames", 5)
    blend = sc.blend(TABLE, OTHER, cache=cache)
    output = str(tmp_path / "blend.glb")
    assert as_text(blend.to_dict(5, output)) == as_text(expected)
    again = tmp_path / "again.glb"
    blend.save(again, 5)
    assert again.read_bytes() == (tmp_path / "blend.glb").read_bytes()


def test_collection(json_of_program, cache):
    shapes = [TABLE, OTHER, "data/table_pedestal"]
    expected = json_of_program("collection", *shapes, "--cache", cache)
    found = sc.collection(shapes, cache=cache)
    assert as_text(found.to_dict()) == as_text(expected)
    assert found.energies.shape == (3, 3)
    assert found.matches is None
    expected = json_of_program("collection", *shapes, "--cache", cache, "--matches", "--agreeing")
    found = sc.collection(shapes, cache=cache, matches=True, agreeing=True)
    assert as_text(found.to_dict()) == as_text(expected)
    assert len(found.matches) == 6


def test_store_of_a_collection(cache, tmp_path):
    shapes = [TABLE, OTHER, "data/table_pedestal"]
    expected = sc.collection(shapes, cache=cache).to_dict()
    store = tmp_path / "store"
    assert sc.collection(shapes, cache=cache, store=store).to_dict() == expected
    rows = {path: path.stat().st_mtime_ns for path in (store / "pairs").iterdir()}
    assert rows
    assert sc.collection(shapes, cache=cache, store=store).to_dict() == expected
    assert {path: path.stat().st_mtime_ns for path in (store / "pairs").iterdir()} == rows
    other = sc.collection(shapes, cache=cache, store=store, search_method="exact")  # work of other options is apart
    assert other.to_dict() == sc.collection(shapes, cache=cache, search_method="exact").to_dict()


@pytest.mark.parametrize("arguments, options", [((), {}), (("--abstraction", "flow"), {"abstraction": "flow"})])
def test_transfer_labels(json_of_program, cache, arguments, options):
    shapes = [OTHER, "data/table_pedestal"]
    expected = json_of_program("collection", *shapes, "--cache", cache, "--labels-from", TABLE, *arguments)
    labels = json.loads((pathlib.Path(TABLE) / "labels.json").read_text())
    source = sc.roles.LabelledShape(TABLE, labels["category"], {
        part["name"]: (part["coarse"], part.get("fine") or "") for part in labels["parts"]})
    found = sc.transfer_labels(source, shapes, cache=cache, **options)
    assert [shape.to_dict()["parts"] for shape in found] == [shape["parts"] for shape in expected["shapes"]]
    assert found[0].category == expected["category"] == "table"


@pytest.mark.parametrize("arguments, options", [((), {}), (("--paper",), {"paper": True})])
def test_nearest(json_of_program, cache, arguments, options):
    shapes = [OTHER, "data/table_pedestal"]
    expected = json_of_program("collection", *shapes, "--cache", cache, "--nearest", TABLE, "-k", 1, *arguments)
    assert as_text(sc.nearest(TABLE, shapes, 1, cache=cache, **options).to_dict()) == as_text(expected)


def test_evaluate(json_of_program, cache, tmp_path):
    file = tmp_path / "result.json"
    found = sc.match(TABLE, OTHER, cache=cache)
    found.save(file)
    expected = json_of_program("evaluate", file, "--ground-truth", "data")
    assert as_text(sc.evaluate(file, "data").to_dict()) == as_text(expected)
    in_memory = sc.evaluate(found, "data")
    assert in_memory.mean == sc.evaluate(file, "data").mean
    assert 0 < in_memory.mean.f1 <= 1


def test_roles(program, cache, tmp_path):
    file = tmp_path / "labels.json"
    program("label", TABLE, "--cache", cache, "--output", file)
    assert as_text(sc.roles.predict(TABLE, cache=cache).to_dict()) == as_text(json.loads(file.read_text()))


def test_pictures(program, cache, tmp_path):
    program("match", TABLE, OTHER, "--cache", cache, "--glb", tmp_path / "program.glb", "--html",
            tmp_path / "program.html")
    found = sc.match(TABLE, OTHER, cache=cache)
    for ending in ("glb", "html"):
        found.save(tmp_path / f"module.{ending}")
    assert (tmp_path / "module.glb").read_bytes() == (tmp_path / "program.glb").read_bytes()
    sizes = [(tmp_path / f"{name}.html").stat().st_size for name in ("program", "module")]
    assert sizes[0] > 1e5 and abs(sizes[0] - sizes[1]) < 200  # times have other digits


@pytest.mark.parametrize("arguments, call", [
    (("graph", "data/no_such_model.obj"), lambda: sc.read("data/no_such_model.obj")),
    (("match", "data/no_such_model.obj", TABLE), lambda: sc.match("data/no_such_model.obj", TABLE)),
    (("graph", "data/README.md"), lambda: sc.build_graph("data/README.md")),
    (("match", TABLE, OTHER, "--roles", "data/README.md"), lambda: sc.match(TABLE, OTHER, roles="data/README.md")),
    (("evaluate", "data/table_trestle/labels.json", "--ground-truth", "data"),
     lambda: sc.evaluate("data/table_trestle/labels.json", "data")),
])
def test_errors_have_the_same_messages(program, arguments, call):
    result = program(*arguments)
    assert result.returncode == 1
    with pytest.raises(sc.InvalidInput) as error:
        call()
    message = str(error.value).replace("train_role_model()", "shape_correspondence roles train")  # as the program calls it
    assert result.stderr == f"shape_correspondence: {message}\n"
    assert isinstance(error.value, ValueError)

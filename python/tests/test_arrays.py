# Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
# SPDX-License-Identifier: GPL-3.0-or-later
"""NumPy arrays in and out."""

import numpy as np
import pytest

import shape_correspondence as sc


def test_parts_come_back_as_they_went_in(table):
    parts = table()
    shape = sc.Shape(parts, name="table", up="y")
    assert shape.name == shape.file == "table"
    assert shape.up.tolist() == [0, 1, 0]
    assert [part.name for part in shape.parts] == [name for name, _, _ in parts]
    for part, (_, vertices, faces) in zip(shape.parts, parts):
        assert part.vertices.dtype == np.float64
        np.testing.assert_array_equal(part.vertices, vertices)
        np.testing.assert_array_equal(part.faces, faces)


@pytest.mark.parametrize("dtype", [np.float32, np.int64])
def test_arrays_of_other_types_and_orders(table, dtype):
    parts = [(name, np.asfortranarray(1000 * vertices, dtype), faces.astype(np.uint16)[::1])
             for name, vertices, faces in table()]
    for part, (_, vertices, faces) in zip(sc.Shape(parts).parts, parts):
        np.testing.assert_array_equal(part.vertices, vertices)
        np.testing.assert_array_equal(part.faces, faces)


def test_up(table):
    turned = [(name, vertices[:, [2, 0, 1]], faces) for name, vertices, faces in table()]
    assert sc.Shape(turned, up="z").up.tolist() == [0, 0, 1]
    assert sc.Shape(turned, up="-z").up.tolist() == [0, 0, -1]
    assert sc.Shape(turned, up="+z").up.tolist() == [0, 0, 1]
    assert sc.Shape(turned, up=(0, 0, 2)).up.tolist() == [0, 0, 1]
    assert sc.Shape(turned, up="auto").up.tolist() == [0, 0, 1]
    with pytest.raises(sc.InvalidInput):
        sc.Shape(turned, up="w")
    with pytest.raises(sc.InvalidInput):
        sc.Shape(turned, up=(0, 0, 0))


@pytest.mark.parametrize("vertices, faces, word", [
    (np.zeros((3, 2)), [[0, 1, 2]], "vertices"),
    (["a", "b"], [[0, 1, 2]], "vertices"),
    (np.eye(3), [[0, 1, 2, 0]], "faces"),
    (np.eye(3), [[0., 1., 2.]], "faces"),
    (np.eye(3), [[0, 1, 3]], "leg"),
    (np.eye(3), [[0, 1, 2**32 + 2]], "leg"),  # not vertex 2
    (np.eye(3), [[0, 1, -1]], "leg"),
    (np.full((3, 3), np.nan), [[0, 1, 2]], "leg"),
    (np.zeros((3, 3)), [[0, 1, 2]], "leg"),
])
def test_arrays_that_are_no_mesh(vertices, faces, word):
    with pytest.raises(sc.InvalidInput, match=word):
        sc.Shape([("leg", vertices, faces)])


def test_arrays_match_as_files_do(data, cache):
    files = [data / "table_four_legged", data / "table_trestle"]
    shapes = [sc.Shape(sc.read(file).parts, name=file.name) for file in files]
    of_arrays, of_files = sc.match(*shapes), sc.match(*files, cache=cache)
    assert of_arrays.pairs == of_files.pairs
    assert of_arrays.confidences == of_files.confidences
    assert of_arrays.energy == of_files.energy
    assert of_arrays.source == "table_four_legged"


def test_a_graph_is_built_once(table):
    graphs = [sc.build_graph(table()), sc.build_graph(sc.Shape(table(width=2)))]
    found = sc.match(*graphs)
    assert found.pairs == [(name, name) for name, _, _ in sorted(table())] or found.counterparts("top") == ["top"]
    assert found.source_graph.part_names == [name for name, _, _ in table()]
    assert found.to_dict() == {**sc.match(*graphs).to_dict(), "seconds": found.to_dict()["seconds"]}
    assert [len(group.parts) for group in graphs[0].groups] and graphs[0].contacts
    top = next(part for part in graphs[0].parts if part.name == "top")
    assert top.type == "sheet" and top.grid.shape == (8, 8, 3)
    assert graphs[0].shape.parts[0].name == "top"


def test_a_saved_graph(table, tmp_path):
    graph = sc.build_graph(table())
    graph.save(tmp_path / "table.json")
    again = sc.build_graph(tmp_path / "table.json")
    assert again.part_names == graph.part_names and again.shape is None
    for ending in ("graphml", "dot", "glb", "html"):
        graph.save(tmp_path / f"table.{ending}")
        assert (tmp_path / f"table.{ending}").stat().st_size > 100
    with pytest.raises(sc.InvalidInput):
        graph.save(tmp_path / "table.png")
    found = sc.match(again, again)
    with pytest.raises(sc.InvalidInput, match="without surfaces"):
        sc.transfer(found, [])
    with pytest.raises(sc.InvalidInput, match="without surfaces"):
        sc.blend(again, again, found)


def test_transfer(table):
    source, target = sc.Shape(table()), sc.Shape(table(width=2, height=1))
    found = sc.match(source, target)
    heights = [part.vertices[:, 1] / 0.74 for part in source.parts]
    moved = sc.transfer(found, heights)
    assert list(moved) == [part.name for part in target.parts]
    for part in target.parts:
        np.testing.assert_allclose(moved[part.name], part.vertices[:, 1] / 1.04, atol=0.03)
    colours = {part.name: np.repeat([[i, 0, 255]], len(part.vertices), 0) for i, part in enumerate(source.parts)}
    labels = sc.transfer(found, colours, none=-1)
    assert labels["top"].dtype.kind == "i" and labels["top"].shape == (8, 3)
    assert (labels["top"] == [0, 0, 255]).all()
    names = sc.transfer(found, [np.full(len(part.vertices), part.name) for part in source.parts], none="")
    assert (names["top"] == "top").all()


def test_values_that_do_not_fit(table):
    found = sc.match(table(), table())
    with pytest.raises(sc.InvalidInput, match="leg_3"):
        sc.transfer(found, {f"leg_{i}": np.zeros(8) for i in range(3)} | {"top": np.zeros(8)})
    with pytest.raises(sc.InvalidInput, match="7"):
        sc.transfer(found, [np.zeros(7)] * 5)
    with pytest.raises(sc.InvalidInput, match="4 parts"):
        sc.transfer(found, [np.zeros(8)] * 4)


def test_pinned_and_forbidden_pairs(table):
    graphs = [sc.build_graph(table()), sc.build_graph(table(width=2))]
    assert ("leg_0", "leg_0") in sc.match(*graphs).pairs
    assert ("leg_0", "leg_0") not in sc.match(*graphs, forbidden=[("leg_0", "leg_0")]).pairs
    assert sc.match(*graphs, pinned=[("leg_0", 1)]).counterparts("leg_0") == [graphs[1].part_names[1]]


def test_values_of_parts_without_counterpart(table):
    found = sc.match(table(), table(), source_parts=["top"], target_parts=["top"])
    moved = sc.transfer(found, [np.ones(8)] * 5)
    assert np.isnan(moved["leg_0"]).all() and (moved["top"] == 1).all()


def test_blend(table, tmp_path):
    source, target = sc.Shape(table()), sc.Shape(table(width=2, height=1))
    blend = sc.blend(source, target)
    heights = [max(part.vertices[:, 1].max() for part in blend(t).parts) for t in (0, 0.5, 1)]
    np.testing.assert_allclose(heights, [0.74, 0.89, 1.04], atol=0.02)
    assert {task.task for task in blend.tasks} == {"morph"}
    blend.save(tmp_path / "frames", frames=3)
    assert sorted(file.name for file in (tmp_path / "frames").iterdir()) == [
        "frame_000.obj", "frame_001.obj", "frame_002.obj"]
    match = sc.match(source, target)
    match.save(tmp_path / "match.json")
    assert sc.blend(source, target, tmp_path / "match.json").to_dict(3) == sc.blend(source, target, match).to_dict(3)
    for t in (-0.1, 1.1, float("nan")):
        with pytest.raises(sc.InvalidInput):
            blend(t)


def test_roles(table, tmp_path):
    tables = [sc.roles.LabelledShape(table(1 + 0.1 * i, 0.6 + 0.05 * i), "table",
                                     {"top": ("top", ""), **{f"leg_{k}": "leg" for k in range(4)}}) for i in range(5)]
    model = sc.roles.train(tables, trees=10)
    assert model.categories == ["table"] and model.roles("table") == ["leg", "top"]
    model.save(tmp_path / "my.roles")
    found = sc.roles.predict(table(1.33), tmp_path / "my.roles", category="table")
    assert {part.name: part.coarse for part in found.parts} == {"top": "top", **{f"leg_{k}": "leg" for k in range(4)}}
    shipped = sc.roles.load()
    extended = sc.roles.extend(None, [tables[0]._replace(category="my table"), tables[1]._replace(category="my table")])
    assert set(extended.categories) == {*shipped.categories, "my table"}
    assert sc.match(table(1.33), table(1.1), roles=extended, category="my table").category == "my table"
    exact = sc.match(table(1.33), table(1.1), search_method="exact", role_weight=1, roles=extended, category="my table")
    assert exact.category == "my table"
    assert sc.match(table(1.33), table(1.1), search_method="exact").category is None
    with pytest.raises(sc.InvalidInput, match="leg_0"):
        sc.roles.train([sc.roles.LabelledShape(table(), "table", {"top": "top"})])
    assert "chair" in sc.roles.load().categories

# Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
# SPDX-License-Identifier: GPL-3.0-or-later
"""Meshes of trimesh and PyVista by stand-ins, dictionaries, labels of faces; results in a notebook and a browser."""

import base64
import re
import sys
import types
import webbrowser
import zlib
from types import SimpleNamespace

import numpy as np
import pytest

import shape_correspondence as sc


class Trimesh(SimpleNamespace):
    def __init__(self, vertices, faces, process=True):
        super().__init__(vertices=vertices, faces=faces)


class Scene:
    """The graph of a scene tells transform and geometry of a node."""

    def __init__(self):
        self.geometry, self.placed = {}, {}

    @property
    def graph(self):
        placed = self.placed

        class Nodes:
            nodes_geometry = list(placed)

            def __getitem__(self, node):
                return placed[node]

        return Nodes()

    def add_geometry(self, mesh, node_name, geom_name, transform=np.eye(4)):
        self.geometry[geom_name] = mesh
        self.placed[node_name] = (transform, geom_name)


class PolyData:
    """Faces are a flat array of counts and indices."""

    def __init__(self, points, quads):
        self.points, self.quads = points, quads
        self.faces = np.hstack([np.full((len(quads), 1), quads.shape[1]), quads]).ravel()

    def triangulate(self):
        faces = self.quads if self.quads.shape[1] == 3 else np.vstack([self.quads[:, :3], self.quads[:, [0, 2, 3]]])
        return PolyData(self.points, faces)


class MultiBlock(dict):
    """Blocks have numbers, and names."""

    n_blocks = property(len)

    def __getitem__(self, index):
        return list(self.values())[index]


def same(shape, table):
    assert [part.name for part in shape.parts] == [name for name, _, _ in table]
    for part, (_, vertices, faces) in zip(shape.parts, table):
        np.testing.assert_allclose(part.vertices[part.faces], np.asarray(vertices)[faces], atol=1e-12)


def test_dictionaries_and_pairs(table):
    triples = table()
    same(sc.Shape({name: (v, f) for name, v, f in triples}), triples)
    same(sc.Shape([(name, Trimesh(v, f)) for name, v, f in triples]), triples)
    same(sc.Shape({name: PolyData(v, f) for name, v, f in triples}), triples)
    same(sc.Shape(MultiBlock({name: PolyData(v, f) for name, v, f in triples})), triples)
    for wrong in ([("leg", 3)], [3], {"leg": "mesh"}):
        with pytest.raises(sc.InvalidInput, match="mesh"):
            sc.Shape(wrong)


def test_polygons_and_volumes():
    quad = PolyData(np.array([[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0.]]), np.array([[0, 1, 2, 3]]))
    volume = SimpleNamespace(points=quad.points, extract_surface=lambda: quad)
    for mesh in (quad, volume):
        assert len(sc.Shape({"plate": mesh}).parts[0].faces) == 2


def test_a_scene_has_transforms(table):
    scene, mirror = Scene(), np.diag([-1., 1, 1, 1])
    mirror[0, 3] = 5
    for name, vertices, faces in table():
        scene.add_geometry(Trimesh(vertices, faces), name, "geometry of " + name, mirror)
    same(sc.Shape(scene), [(name, vertices * [-1, 1, 1] + [5, 0, 0], faces[:, ::-1]) for name, vertices, faces in table()])
    assert len(sc.match(scene, table()).pairs) == 5


def test_a_single_mesh_is_divided_as_a_file_is(table):
    triples = table()
    first = np.cumsum([0] + [len(v) for _, v, _ in triples])
    mesh = Trimesh(np.concatenate([v for _, v, _ in triples]), np.concatenate([f + n for (_, _, f), n in zip(triples, first)]))
    assert len(sc.Shape(mesh).parts) == 5
    assert len(sc.match(mesh, {"a": triples[0][1:], "b": triples[1][1:]}).pairs) > 0


def test_from_segmentation(table):
    triples = table()
    first = np.cumsum([0] + [len(v) for _, v, _ in triples])
    vertices = np.concatenate([v for _, v, _ in triples])
    faces = np.concatenate([f + n for (_, _, f), n in zip(triples, first)])
    labels = np.repeat([name for name, _, _ in triples], 12)
    same(sc.Shape.from_segmentation(vertices, faces, labels), sorted(triples, key=lambda part: part[0]))
    assert [part.name for part in sc.Shape.from_segmentation(vertices, faces, np.arange(60) // 12).parts] == list("01234")
    with pytest.raises(sc.InvalidInput, match="60 faces"):
        sc.Shape.from_segmentation(vertices, faces, labels[1:])
    with pytest.raises(sc.InvalidInput, match="none of the 40"):
        sc.Shape.from_segmentation(vertices, faces + 1, labels)


def test_to_trimesh(table, monkeypatch):
    try:
        import trimesh
    except ImportError:
        trimesh = types.ModuleType("trimesh")
        trimesh.Scene, trimesh.Trimesh = Scene, Trimesh
        monkeypatch.setitem(sys.modules, "trimesh", trimesh)
    same(sc.Shape(sc.Shape(table()).to_trimesh()), table())


def test_a_collection_of_named_shapes(table):
    found = sc.collection({"small": table(), "wide": {name: (v, f) for name, v, f in table(width=2)}})
    assert [shape.name for shape in found.shapes] == ["small", "wide"]
    assert repr(found) == f"<Collection of 2 shapes: {len(found.clusters)} clusters of parts>"
    assert "2 shapes" in found._repr_html_()
    with pytest.raises(sc.InvalidInput, match="html=FILE"):
        found.show()


def test_the_page_of_a_collection_is_shown(table, monkeypatch, tmp_path):
    opened = []
    monkeypatch.setattr(webbrowser, "open", opened.append)
    found = sc.collection({"small": table(), "wide": table(width=2)}, html=tmp_path / "page.html")
    assert found.show() == str(tmp_path / "page.html") and opened[-1].endswith("page.html")
    assert len(found._repr_html_()) < 10000
    assert "_page" not in found.to_dict()


def test_a_match_in_a_notebook_is_a_picture_and_a_table(table):
    match = sc.match(table(), table(width=2))
    cell = match._repr_html_()
    png = base64.b64decode(re.search("base64,([^\"]+)", cell)[1])
    assert png.startswith(b"\x89PNG") and len(set(zlib.decompress(png[png.index(b"IDAT") + 4:-16]))) > 20
    assert cell.count("<tr>") == 1 + len(match.blocks) and "leg_0" in cell
    assert set(match.labels) == set(match.colours) == {"source", "target"}
    assert list(match.labels["source"]) == match.source_graph.part_names
    assert all(re.fullmatch("#[0-9a-f]{6}", colour) for colour in match.colours["target"].values())
    for block in match.blocks:
        assert len({match.colours["source"][name] for name in block.source} | {match.colours["target"][name] for name in block.target}) == 1


def test_a_match_as_a_table_of_pandas(table, monkeypatch):
    rows = []
    pandas = types.ModuleType("pandas")
    pandas.DataFrame = lambda values, columns: rows.extend(dict(zip(columns, value)) for value in values)
    monkeypatch.setitem(sys.modules, "pandas", pandas)
    match = sc.match(table(), table(width=2))
    match.to_dataframe()
    assert [(row["source"], row["target"]) for row in rows] == match.pairs
    assert all(row["source"] in match.blocks[row["block"]].source for row in rows)
    assert [row["confidence"] for row in rows] == match.confidences


def test_results_are_shown(table, monkeypatch):
    opened = []
    monkeypatch.setattr(webbrowser, "open", opened.append)
    match = sc.match(table(), table(width=2))
    assert len(repr(match)) < 100 and "5 pairs" in repr(match)
    for result in (match, match.source_graph, sc.blend(None, None, match)):
        cell = result._repr_html_()
        assert cell.startswith('<img src="data:image/png;base64,') and 2000 < len(cell) <= 150_000
        file = result.show()
        assert opened[-1].endswith(file) and "<html" in open(file, encoding="utf-8").read()

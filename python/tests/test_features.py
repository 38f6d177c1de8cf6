# Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
# SPDX-License-Identifier: GPL-3.0-or-later
"""Features of faces and vertices: arrays and files, of shapes of arrays and of files."""

import numpy as np
import pytest

import shape_correspondence as sc


def faces_of(folder):
    """The number of faces of each OBJ file, sorted by name."""
    return [sum(line.startswith("f ") for line in path.read_text().splitlines()) for path in sorted((folder / "parts").iterdir())]


def one_hot(counts):
    """Rows that tell the parts apart."""
    return np.repeat(np.eye(len(counts)), counts, axis=0)


def test_arrays_and_files_are_the_same(data, tmp_path, json_of_program, cache):
    table = data / "table_four_legged"
    features = one_hot(faces_of(table))
    np.save(tmp_path / "f.npy", features.astype(np.float32))
    by_array = sc.match(table, table, source_features=features, target_features=np.asfortranarray(features), cache=cache)
    by_file = sc.match(str(table), table, source_features=tmp_path / "f.npy", target_features=str(tmp_path / "f.npy"),
                       cache=cache)
    assert by_array.features == sc.ComparedFeatures(features.shape[1], by_array.features.weight, False)
    assert any("not calibrated" in warning for warning in by_array.warnings)
    of_program = json_of_program("match", table, table, "--source-features", tmp_path / "f.npy", "--target-features",
                                 tmp_path / "f.npy", "--cache", cache)
    for match in (by_array, by_file):
        found = match.to_dict()
        assert {**found, "seconds": 0} == {**of_program, "seconds": 0}
    assert sc.match(table, table, cache=cache).features is None
    assert sc.Match.from_dict(of_program).features == by_array.features


def test_weight(data, cache):
    a, b = data / "chair_four_legged", data / "chair_slatted"
    features = {"source_features": one_hot(faces_of(a))[:, :7], "target_features": one_hot(faces_of(b))[:, :7]}
    without, none = sc.match(a, b, cache=cache), sc.match(a, b, **features, feature_weight=0, cache=cache)
    assert (none.pairs, none.confidences, none.features) == (without.pairs, without.confidences, None)
    some = sc.match(a, b, **features, feature_weight=9, cache=cache)
    assert some.features.weight == 9
    assert some.confidences != without.confidences
    assert sc.blend(a, b, **features, cache=cache)
    with pytest.raises(sc.InvalidInput, match="feature"):
        sc.match(a, b, **features, feature_weight=-1, cache=cache)


def test_shapes_of_arrays(table):
    parts = table()
    of_faces = one_hot([len(faces) for _, _, faces in parts])
    of_vertices = one_hot([len(vertices) for _, vertices, _ in parts])
    graphs = [sc.build_graph(parts, features=features) for features in (of_faces, of_vertices, of_faces.astype(int).tolist())]
    for graph in graphs:
        assert sc.match(graphs[0], graph).features.dimension == len(parts)
    assert sc.match(graphs[0], sc.build_graph(parts)).features is None
    with pytest.raises(ValueError, match="is built already"):
        sc.match(graphs[0], parts, source_features=of_faces, target_features=of_faces)


def test_one_mesh_that_is_divided(table):
    class Mesh:
        vertices = np.vstack([vertices for _, vertices, _ in table()])
        faces = np.vstack([faces + 8 * i for i, (_, _, faces) in enumerate(table())])

    graph = sc.build_graph(Mesh, features=np.ones((len(Mesh.faces), 4)))
    assert sc.match(graph, graph).features.dimension == 4


def test_a_shape_that_was_read_keeps_its_labels_of_faces(tmp_path):
    boxes = [[(x + i, y, z) for z in (0, 1) for y in (0, 1) for x in (0, 1)] for i in (0, 1)]
    quads = [(0, 2, 3, 1), (4, 5, 7, 6), (0, 1, 5, 4), (2, 6, 7, 3), (0, 4, 6, 2), (1, 3, 7, 5)]
    lines = [f"v {x} {y} {z}" for box in boxes for x, y, z in box]
    lines += ["f " + " ".join(str(v + 1 + 8 * i) for v in quad) for i in (0, 1) for quad in quads]
    model, labels = tmp_path / "boxes.obj", tmp_path / "labels.txt"
    model.write_text("\n".join(lines) + "\n")
    labels.write_text("\n".join(["left"] * 6 + ["right"] * 6) + "\n")
    features = np.repeat(np.eye(2), 6, axis=0)
    shape = sc.read(model, parts_from=labels)
    assert [part.name for part in shape.parts] == ["left", "right"]
    graph = sc.build_graph(shape, features=features)
    assert sc.match(graph, sc.build_graph(model, parts_from=str(labels), features=features)).features.dimension == 2


@pytest.mark.parametrize("features, words", [
    (np.ones(12), "give an"),
    (np.ones((3, 4)), "3 rows"),
    (np.ones((0, 4)), "give an"),
    (np.full((60, 4), np.nan), "not finite"),
    (np.full((60, 4), 1e300), "not finite"),
    (np.full((60, 4), "a"), "array of numbers"),
    (np.full((60, 4), None), "array of numbers"),
    (np.ones((60, 4), complex), "array of numbers"),
    ("missing.npy", "missing.npy"),
])
def test_features_that_cannot_be_used(table, features, words):
    with pytest.raises(ValueError, match=words):
        sc.build_graph(table(), features=features)


def test_features_of_one_shape_and_of_a_saved_graph(table, tmp_path):
    graph = sc.build_graph(table())
    graph.save(tmp_path / "graph.json")
    with pytest.raises(ValueError, match="structural graph"):
        sc.build_graph(tmp_path / "graph.json", features=np.ones((60, 4)))
    with pytest.raises(ValueError, match="give those of the other"):
        sc.match(table(), table(), source_features=np.ones((60, 4)))

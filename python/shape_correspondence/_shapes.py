# Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
# SPDX-License-Identifier: GPL-3.0-or-later
"""Segmented shapes and their structural graphs."""

from __future__ import annotations

import html
import itertools
import json
import os
from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any, Callable, Dict, Iterable, List, NamedTuple, Optional, Sequence, Tuple, Union

import numpy as np

from . import _core
from ._inputs import is_mesh, parts_of
from ._options import defaults, with_options
from ._pages import Page
from ._pictures import MOST_TRIANGLES, picture
from ._records import Record

Path = Union[str, "os.PathLike[str]"]
Progress = Optional[Callable[[float, str], Any]]
Features = Any  # an (n, d) array, a file, or None


class Part(NamedTuple):
    """A part of a shape and its triangle mesh."""

    name: str  #: unique in the shape
    vertices: np.ndarray  #: (n, 3) float64
    faces: np.ndarray  #: (m, 3) integers, rows of `vertices`


Parts = Union[Iterable[Tuple[Any, ...]], "Mapping[str, Any]", Any]


class Shape:
    """A segmented shape: a list of named parts, each a triangle mesh.

    :param parts: triples (name, V, F): V is an (n, 3) array of points, F an (m, 3) array of rows of V. Or pairs
        (name, mesh), or a dictionary of these; a mesh is (V, F), or one of trimesh or PyVista. Or a Scene of trimesh or
        a MultiBlock of PyVista. A single mesh is divided into parts as a file is
    :param name: names the shape in messages and results
    :param up: the upright direction: ``"x"``, ``"y"``, ``"z"``, ``"-x"``, ``"-y"``, ``"-z"``, a vector, or
        ``"auto"``, the axis along which the shape stands most stably
    :raises InvalidInput: if a name is empty or taken, a mesh has an invalid index or coordinate, or no area
    """

    def __init__(self, parts: Parts, name: str = "shape", up: Union[str, Sequence[float]] = "y"):
        arrays = [(part, *_mesh_arrays(part, vertices, faces)) for part, vertices, faces in parts_of(parts)]
        whole = arrays if is_mesh(parts) else []
        if whole:
            divided = _core.divide_mesh(*whole[0]).parts()
            arrays = [(part, *_mesh_arrays(part, vertices, faces)) for part, vertices, faces in divided]
        self._handle = _core.make_shape(arrays, name, _direction(up), whole)

    @classmethod
    def from_segmentation(
        cls, vertices: Any, faces: Any, labels: Any, name: str = "shape", up: Union[str, Sequence[float]] = "y"
    ) -> "Shape":
        """The shape of one mesh whose faces have labels: the faces of one label are a part.

        :param vertices: (n, 3) points
        :param faces: (m, 3) rows of `vertices`
        :param labels: m numbers or texts; the parts are named after them
        :param name: see `Shape`
        :param up: see `Shape`
        :raises InvalidInput: if there is not one label for each face, or a part cannot be used
        """
        points, triangles, labels = np.asarray(vertices), np.asarray(faces), np.asarray(labels)
        if labels.shape != triangles.shape[:1]:
            raise _core.InvalidInput(f"labels are an array of shape {labels.shape}; give one for each of the "
                                     f"{len(triangles)} faces")
        points, triangles = _mesh_arrays(name, points, triangles)
        if triangles.size and not 0 <= triangles.min() <= triangles.max() < len(points):
            raise _core.InvalidInput(f"{name}: a face has a vertex that is none of the {len(points)}")
        parts = []
        for label in np.unique(labels):
            used, rows = np.unique(triangles[labels == label], return_inverse=True)
            parts.append((str(label), points[used], rows.reshape(-1, 3)))
        return cls(parts, name, up)

    @classmethod
    def _of(cls, handle: Any) -> "Shape":
        result = cls.__new__(cls)
        result._handle = handle
        return result

    @property
    def name(self) -> str:
        """The name of the shape."""
        return self._handle.name

    @property
    def file(self) -> str:
        """The file that the shape was read from; else its name."""
        return self._handle.file

    @property
    def up(self) -> np.ndarray:
        """The upright direction, a unit vector."""
        return np.array(self._handle.up)

    @property
    def parts(self) -> List[Part]:
        """The parts, in the order in which they were given or read. Arrays are copies."""
        return [Part(*part) for part in self._handle.parts()]

    @property
    def warnings(self) -> List[str]:
        """What was estimated or left out when the shape was read, in whole sentences."""
        return self._handle.warnings

    def save(self, path: Path) -> None:
        """Writes the shape as ``.obj`` (one object per part) or ``.ply`` (binary, with the part of every face)."""
        self._handle.save(os.fspath(path))

    def to_trimesh(self) -> Any:
        """The shape as a Scene of trimesh, which must be installed: a mesh for each part, with its name."""
        import trimesh

        scene = trimesh.Scene()
        for part in self.parts:
            mesh = trimesh.Trimesh(part.vertices, part.faces, process=False)
            scene.add_geometry(mesh, node_name=part.name, geom_name=part.name)
        return scene

    def __repr__(self) -> str:
        return f"<Shape {self.name!r}: {len(self.parts)} parts>"


@dataclass(eq=False)
class PartAbstraction(Record):
    """The curve or sheet that approximates a part."""

    name: str  #: name of the part
    type: str  #: ``"curve"`` or ``"sheet"``
    volume: float  #: of the enclosed solid; 0 where unknown
    hull_volume: float  #: of its convex hull; 0 where unknown or flat
    area: float  #: of the surface; 0 where unknown
    closed: Optional[bool] = None  #: of a curve: its last control point is joined to the first
    points: Optional[np.ndarray] = None  #: of a curve: (n, 3) control points
    grid: Optional[np.ndarray] = None  #: of a sheet: (rows, columns, 3) control points


@dataclass(eq=False)
class PartGroup(Record):
    """Parts that are symmetric to each other, or a single part."""

    parts: List[str]  #: names, in the order along the generator
    symmetry: str  #: ``"self"`` (a single part), ``"reflection"``, ``"rotation"`` or ``"translation"``
    order: Optional[int] = None  #: of a rotation: n of n-fold


class Graph(Page):
    """The structural graph of a shape: a curve or sheet for every part, groups of symmetric parts, and contacts.

    `build_graph()` makes it. `to_dict()` has all of it.
    """

    def __init__(self, handle: Any):
        self._handle = handle

    @property
    def name(self) -> str:
        """The name of the shape."""
        return self._handle.name

    @property
    def file(self) -> str:
        """The file that the shape was read from; else its name."""
        return self._handle.file

    @property
    def part_names(self) -> List[str]:
        """The names of the parts, in the order of all indices."""
        return self._handle.part_names()

    @property
    def parts(self) -> List[PartAbstraction]:
        """The curve or sheet of every part."""
        return [PartAbstraction.from_dict(part) for part in self.to_dict()["parts"]]

    @property
    def groups(self) -> List[PartGroup]:
        """The symmetry groups. Every part is in one of them."""
        return [PartGroup.from_dict(group) for group in self.to_dict()["groups"]]

    @property
    def contacts(self) -> List[Tuple[str, str]]:
        """The pairs of parts in contact, one for each region in which they touch."""
        return [tuple(contact["parts"]) for contact in self.to_dict()["contacts"]]

    @property
    def shape(self) -> Optional[Shape]:
        """The shape that the graph was built from; None for a graph that was read without its surfaces."""
        handle = self._handle.shape()
        return None if handle is None else Shape._of(handle)

    @property
    def warnings(self) -> List[str]:
        """What was approximated, in whole sentences."""
        return self._handle.warnings

    def to_dict(self) -> Dict[str, Any]:
        """The graph as ``shape_correspondence graph --json`` writes it."""
        return json.loads(self._handle.json())

    def save(self, path: Path) -> None:
        """Writes the graph as ``.json``, which `build_graph()` reads, ``.graphml`` or ``.dot``, or a picture of it as
        ``.glb`` or ``.html``."""
        self._handle.save(os.fspath(path))

    def _repr_html_(self) -> str:
        """A still picture; `show()` and `save()` have the page."""
        labels, colours = self._handle.looks()
        image = picture([list(zip(self._handle.drawn_parts(0, MOST_TRIANGLES), colours))])
        return image + f"<p>{html.escape(self.name)}: {html.escape(', '.join(labels[:40]))}</p>"

    def __repr__(self) -> str:
        return f"<Graph of {self.name!r}: {len(self.part_names)} parts>"


Input = Union[Graph, Shape, Path, Parts]


@with_options
def read(path: Path, **options: Any) -> Shape:
    """Reads a segmented shape.

    :param path: an OBJ (``o`` and ``g`` are parts), PLY, STL, OFF, glTF, COLLADA, FBX, 3DS, 3MF, DXF, AC3D or URDF file
        with one object, node or link for each part; or a folder of part meshes, one file for each part
    :raises InvalidInput: if the file cannot be read
    """
    return Shape._of(_core.read(os.fspath(path), options))


@with_options
def build_graph(shape: Input, *, features: Features = None, progress: Progress = None, **options: Any) -> Graph:
    """Builds the structural graph of a shape: a curve or sheet for every part, symmetry groups and contacts.

    :param shape: a `Shape`, what makes a `Shape`, a model file, or a saved graph (``.json``)
    :param features: features of the surface, such as those of a neural network, which `match()` compares: an (n, d) array
        of numbers or a ``.npy`` file, with a row for each face, or else for each vertex, in the order of the model file
        (OBJ, OFF, PLY, STL, or a folder of these), or of the arrays of the shape, part by part. A saved graph has none
    :param progress: called with the fraction done, in [0, 1], and the name of the current step
    :raises InvalidInput: if the shape has fewer than two parts or more than 2000, or an option is out of its range
    """
    return _graphs([shape], False, options, progress, [features])[0]


def _graphs(shapes: Sequence[Input], is_pair: bool, options: Dict[str, Any], progress: Progress,
            features: Sequence[Features] = ()) -> List[Graph]:
    """The graphs of inputs: files all at once, other inputs one by one."""
    arrays = [None if given is None else _feature_array(given) for given in features]
    for shape, array in zip(shapes, arrays):
        if isinstance(shape, Graph) and array is not None:
            raise _core.InvalidInput(f"{shape!r} is built already; give its features to build_graph()")
    paths = [os.fspath(shape) for shape in shapes if isinstance(shape, (str, os.PathLike))]
    is_pair = is_pair and len(paths) == 2
    loaded = iter(_core.load_graphs(paths, is_pair, options, progress) if paths else [])
    result = []
    # What the paper's method asks of graphs may be given beside graphs of another kind: a match warns of them
    further = {name for name, value in options.items() if value is not None} - {"cache", "threads", "allow_outside_files"}
    further -= {"paper"} if options.get("abstraction") != "flow" else {"paper", "abstraction"}
    for shape, array in itertools.zip_longest(shapes, arrays):
        given = None
        done = further if isinstance(shape, Graph) else further & {*defaults("read")} if isinstance(shape, Shape) else {}
        if done:
            raise TypeError(f"{shape!r} is read already; leave {', '.join(sorted(done))} out")
        if isinstance(shape, Graph):
            result.append(shape)
        elif isinstance(shape, (str, os.PathLike)):
            result.append(Graph(next(loaded)))
        else:
            given = (shape if isinstance(shape, Shape) else Shape(shape, up=options.get("up") or "y"))._handle
            result.append(Graph(_core.build_graph(given, options, progress)))
        if array is not None:
            _core.add_features(result[-1]._handle, given, array)
    return result


def _feature_array(features: Any) -> np.ndarray:
    """An (n, d) array of float32."""
    if isinstance(features, (str, os.PathLike)):
        return _core.read_features(os.fspath(features))
    array = np.asarray(features)
    if array.ndim != 2 or array.dtype.kind not in "fiu" or 0 in array.shape:
        raise _core.InvalidInput(f"features are an array of {array.dtype} of shape {array.shape}; give an (n, d) array of "
                                 "numbers with a row for each face or vertex")
    with np.errstate(over="ignore"):  # too large numbers become infinite, and are reported as not finite
        return np.ascontiguousarray(array, np.float32)


def _direction(up: Union[str, Sequence[float]]) -> Optional[Tuple[float, float, float]]:
    axes = {"x": (1, 0, 0), "y": (0, 1, 0), "z": (0, 0, 1), "auto": None}
    axes.update({"-x": (-1, 0, 0), "-y": (0, -1, 0), "-z": (0, 0, -1)})
    if isinstance(up, str):
        if up.removeprefix("+") not in axes:
            raise _core.InvalidInput(f"up cannot be {up!r}; known are: {', '.join(axes)}, or a vector")
        return axes[up.removeprefix("+")]
    x, y, z = up
    return (x, y, z)


def _mesh_arrays(name: str, vertices: Any, faces: Any) -> Tuple[np.ndarray, np.ndarray]:
    points, indices = np.asarray(vertices), np.asarray(faces)
    if points.ndim != 2 or points.shape[1] != 3 or points.dtype.kind not in "fiu":
        raise _core.InvalidInput(f"part '{name}': its vertices are an array of {points.dtype} of shape {points.shape};"
                                 " give an (n, 3) array of numbers")
    if indices.ndim != 2 or indices.shape[1] != 3 or indices.dtype.kind not in "iu":
        raise _core.InvalidInput(f"part '{name}': its faces are an array of {indices.dtype} of shape {indices.shape};"
                                 " give an (m, 3) array of integers")
    return np.ascontiguousarray(points, float), np.ascontiguousarray(indices, np.int64)

# Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
# SPDX-License-Identifier: GPL-3.0-or-later
"""Parts of meshes of trimesh and PyVista, dictionaries and pairs. Neither package is imported: only attributes count."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any, List, Tuple

import numpy as np

from ._core import InvalidInput

Triple = Tuple[str, Any, Any]


def is_mesh(thing: Any) -> bool:
    """Whether it is one mesh, of which no parts are given."""
    return _is_trimesh(thing) or _is_pyvista(thing)


def parts_of(shape: Any) -> List[Triple]:
    """The parts (name, V, F) of what a user gives as a shape."""
    if is_mesh(shape):
        return [("part", *_arrays(shape, "part"))]
    if hasattr(shape, "geometry") and hasattr(shape, "graph"):
        return _parts_of_scene(shape)
    if hasattr(shape, "n_blocks") and hasattr(shape, "keys"):
        shape = {name or f"block_{i}": shape[i] for i, name in enumerate(shape.keys()) if shape[i] is not None}
    if isinstance(shape, Mapping):
        shape = shape.items()
    return [_triple(part) for part in shape]


def _is_trimesh(thing: Any) -> bool:
    return hasattr(thing, "vertices") and hasattr(thing, "faces")


def _is_pyvista(thing: Any) -> bool:
    return hasattr(thing, "points") and (hasattr(thing, "faces") or hasattr(thing, "extract_surface"))


def _parts_of_scene(scene: Any) -> List[Triple]:
    """The nodes of a Scene of trimesh, in its coordinates."""
    parts = []
    for node in scene.graph.nodes_geometry:
        transform, geometry = scene.graph[node]
        vertices, faces = _arrays(scene.geometry[geometry], node)
        if np.linalg.det(transform[:3, :3]) < 0:
            faces = faces[:, ::-1]
        parts.append((str(node), vertices @ transform[:3, :3].T + transform[:3, 3], faces))
    return parts


def _triple(part: Any) -> Triple:
    if not isinstance(part, (tuple, list)) or not 2 <= len(part) <= 3:
        raise InvalidInput(f"a part is (name, vertices, faces) or (name, mesh), not {type(part).__name__}")
    if len(part) == 3:
        return tuple(part)
    name, mesh = part
    return (str(name), *_arrays(mesh, name))


def _arrays(mesh: Any, name: Any) -> Tuple[Any, Any]:
    """Vertices and triangles of one mesh."""
    if _is_trimesh(mesh):
        return np.asarray(mesh.vertices), np.asarray(mesh.faces)
    if _is_pyvista(mesh):
        surface = (mesh if hasattr(mesh, "faces") else mesh.extract_surface()).triangulate()
        return np.asarray(surface.points), np.asarray(surface.faces).reshape(-1, 4)[:, 1:]
    if isinstance(mesh, (tuple, list)) and len(mesh) == 2:
        return mesh[0], mesh[1]
    raise InvalidInput(f"part '{name}': {type(mesh).__name__} is no mesh; give (vertices, faces), or a mesh of trimesh or "
                       "PyVista")

# Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
# SPDX-License-Identifier: GPL-3.0-or-later
"""Roles of parts, such as the legs and the seat of a chair, learned from labelled shapes."""

from __future__ import annotations

import json
import os
from dataclasses import dataclass
from typing import Any, ClassVar, Dict, List, Mapping, NamedTuple, Optional, Sequence, Tuple, Union

from . import _core
from ._records import Record
from ._shapes import Graph, Input, Path, Progress, _graphs

RoleModel = _core.RoleModel
Model = Union[str, "os.PathLike[str]", RoleModel]


@dataclass
class PartRole(Record):
    """The role of a part."""

    name: str  #: name of the part
    coarse: str  #: its role
    fine: Optional[str] = None  #: its fine label, if the model knows one
    probability: Optional[float] = None  #: of the role


@dataclass
class PartRoles(Record):
    """The roles of the parts of a shape. `to_dict()` is what ``shape_correspondence label --output`` writes."""

    _header: ClassVar[Dict[str, Any]] = {"format": "shape_correspondence/labels"}

    category: str  #: of the shape
    parts: List[PartRole]  #: by part


class LabelledShape(NamedTuple):
    """A shape from which roles are learned; it must be upright and face +z."""

    shape: Input  #: the shape
    category: str  #: such as chair
    labels: Mapping[str, Union[str, Tuple[str, str]]]  #: role, or role and fine label, by name of a part
    weight: float = 1  #: weight in the training; less for generated shapes than for real ones


def load(path: Optional[Path] = None) -> RoleModel:
    """The role model of a file; without a path, the one that comes with the package.

    :raises InvalidInput: if the file is no role model
    """
    return _core.shipped_roles() if path is None else _core.load_roles(os.fspath(path))


def predict(shape: Input, model: Optional[Model] = None, *, category: str = "", cache: Optional[Path] = None,
            threads: int = 0, progress: Progress = None) -> PartRoles:
    """Predicts the roles of the parts of a shape, which must be upright and face +z.

    :param shape: the shape
    :param model: a role model or its file; None: the one that comes with the package
    :param category: category of the shape; empty: the one whose labelled parts are most similar to its parts
    :param cache: see `build_graph()`
    :param threads: see `build_graph()`
    :param progress: see `build_graph()`
    :raises InvalidInput: if the shape is of no category that the model knows
    """
    graph = _graphs([shape], False, {"cache": cache, "threads": threads}, progress)[0]
    known = model if isinstance(model, RoleModel) else load(model)
    return PartRoles.from_dict(json.loads(_core.predict_roles(graph._handle, known, category)))


def train(shapes: Union[Path, Sequence[Union[Path, LabelledShape]]], *, trees: int = 80, seed: int = 0,
          cache: Optional[Path] = None, threads: int = 0, progress: Progress = None) -> RoleModel:
    """Learns a role model. A category should have at least five shapes; twenty or more are better.

    :param shapes: folders of labelled shapes, as for ``shape_correspondence roles train``, with the same model; or
        `LabelledShape` objects
    :param trees: number of trees in the forest of a category, from 1 to 1000
    :param seed: seed of the random numbers
    :param cache: see `build_graph()`
    :param threads: see `build_graph()`
    :param progress: see `build_graph()`
    :raises InvalidInput: if a shape cannot be used, or a part has no label
    """
    every = [shapes] if isinstance(shapes, (str, os.PathLike)) else list(shapes)
    if all(isinstance(shape, (str, os.PathLike)) for shape in every):
        options = {"cache": cache, "threads": threads}
        return _core.train_roles_of_folders([os.fspath(shape) for shape in every], trees, seed, options, progress)
    return _core.train_roles(_examples(every, {"cache": cache, "threads": threads}, progress), trees, seed, progress)


def extend(model: Optional[Model], shapes: Sequence[LabelledShape], *, seed: int = 0, cache: Optional[Path] = None,
           threads: int = 0, progress: Progress = None) -> RoleModel:
    """Learns roles from labelled shapes in addition to those that a model was learned from, such as a few of your own.

    :param model: a role model or its file; None: the one that comes with the package
    :param shapes: the labelled shapes; in a category that the model has, labels must have the same meaning
    :param seed: seed of the random numbers
    :param cache: see `build_graph()`
    :param threads: see `build_graph()`
    :param progress: see `build_graph()`
    :raises InvalidInput: if a shape cannot be used, or a part has no label
    """
    known = model if isinstance(model, RoleModel) else load(model)
    return _core.extend_roles(known, _examples(shapes, {"cache": cache, "threads": threads}, progress), seed, progress)


def _examples(shapes: Sequence[LabelledShape], of_graphs: Dict[str, Any], progress: Progress) -> List[Any]:
    examples = []
    for labelled in shapes:
        graph = _graphs([labelled.shape], False, of_graphs, progress)[0]
        labels = [_label(labelled.labels, part, graph) for part in graph.part_names]
        examples.append((graph._handle, labelled.category, labels, labelled.weight))
    return examples


def _label(labels: Mapping[str, Union[str, Tuple[str, str]]], part: str, graph: Graph) -> Tuple[str, str]:
    if part not in labels:
        raise _core.InvalidInput(f"{graph.file}: there is no label of the part '{part}'")
    label = labels[part]
    return (label, "") if isinstance(label, str) else (label[0], label[1] or "")


def _model_of(roles: Optional[Model], search: Mapping[str, Any]) -> Optional[RoleModel]:
    """The model that a search takes: roles are for matching by parts, or have a weight in the energy."""
    has_roles = search.get("search_method", "beam" if search.get("paper") else "parts") == "parts" or search.get("role_weight", 0) > 0
    if not has_roles and not (roles is None or roles == "auto"):
        raise _core.InvalidInput('roles need search_method="parts", or a role_weight')
    if roles is None or not has_roles:
        return None
    if isinstance(roles, RoleModel):
        return roles
    return load() if roles == "auto" else load(roles)

# Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
# SPDX-License-Identifier: GPL-3.0-or-later
"""Part correspondences of two shapes."""

from __future__ import annotations

import html
import json
import os
from dataclasses import dataclass, field
from typing import Any, ClassVar, Dict, List, Mapping, Optional, Sequence, Tuple, Union

import numpy as np

from . import _core
from ._options import defaults, with_options
from ._pages import Page
from ._pictures import MOST_TRIANGLES, picture
from ._records import Record
from ._shapes import Features, Graph, Input, Path, Progress, _graphs
from .roles import RoleModel, _model_of

_MOST_ROWS, _MOST_NAMES = 30, 6  # limits of a table in a notebook: rows, and names in a cell

Names = Sequence[Union[str, int]]
Pairs = Sequence[Tuple[Union[str, int], Union[str, int]]]


@dataclass
class EnergyTerms(Record):
    """The terms of the deformation energy (Eq. 1 of the paper), before weighting."""

    distortion: float  #: E_d, Eq. 2 and 3
    connectedness: float  #: E_c, Eq. 4 with its sign corrected
    split: Optional[float] = None  #: E_s, Eq. 5; None for a group
    unmatched: Optional[float] = None  #: cost of unmatched groups; None if there are none
    roles: Optional[float] = None  #: disagreement of roles; None without a `role_weight`


@dataclass
class GroupMatch(Record):
    """A symmetry group of the deformed shape and its counterpart."""

    source: List[str]  #: parts of the source
    target: List[str]  #: parts of the target
    operation: str  #: match, split, duplicate, merge, cut, join, or none: unmatched
    energy: float  #: its share of E_d + w_c E_c
    terms: EnergyTerms  #: its share of E_d and E_c
    solidity_ratio: float  #: S_i of Eq. 5
    min_marginal: Optional[float] = None  #: increase of the least energy if the group may not have this match


@dataclass
class ContactEnergy(Record):
    """The energy of a contact of the deformed shape."""

    parts: Tuple[str, str]  #: the two parts
    distortion: float  #: its share of E_d
    connectedness: float  #: its share of E_c, before weighting


@dataclass
class PairRoles(Record):
    """The roles of the parts of both shapes."""

    source: Dict[str, str]  #: the most probable role of every source part, by its name
    target: Dict[str, str]  #: the same for the target parts


@dataclass
class ComparedFeatures(Record):
    """The features of both shapes that were compared."""

    dimension: int  #: numbers for each face or vertex
    weight: float  #: weight of their cosine distance in the cost of a pair of parts
    calibrated: bool  #: whether confidences were calibrated with them: False


@dataclass
class Block(Record):
    """A set of source parts and a set of target parts that correspond as wholes."""

    source: List[str]  #: parts of the source
    target: List[str]  #: parts of the target
    role: Optional[str] = None  #: role of most of its parts; None if roles are not known
    operation: str = "match"  #: match, split, duplicate, merge, cut or join
    confidence: Optional[float] = None  #: mean probability of its pairs; None if the method does not compute it


@dataclass
class Seconds(Record):
    """Seconds of each phase of a match."""

    read: float  #: reading both models
    abstraction: float  #: abstracting their parts
    structure: float  #: finding symmetry groups, contacts and roles
    search: float  #: finding the correspondence


@dataclass
class SearchSummary(Record):
    """How the search went."""

    method: str  #: parts, beam or exact
    states: int  #: search states kept
    evaluations: int  #: states whose energy, or a lower bound of it, was computed
    lower_bound: float  #: no correspondence in this direction has a lower energy


@dataclass
class Solution(Record):
    """One of the best correspondences."""

    energy: float  #: its energy
    terms: EnergyTerms  #: the terms of its energy
    pairs: List[Tuple[str, str]]  #: its pairs of parts


@dataclass
class Match(Record, Page):
    """The part correspondence of two shapes.

    `to_dict()` is what ``shape_correspondence match --json`` writes.
    """

    _header: ClassVar[Dict[str, Any]] = {"format": "shape_correspondence/match", "version": 1}

    source: str  #: file or name of the source
    target: str  #: file or name of the target
    energy: float  #: E of Eq. 1
    terms: EnergyTerms  #: the terms of the energy
    direction: str  #: which shape was deformed: ``"source_to_target"`` or ``"target_to_source"``
    target_quarter_turns: int  #: turns of the target by 90° about up that align it with the source
    complete: bool  #: every group is assigned, or left unmatched where that is allowed
    optimal: bool  #: the energy is proven minimal, for this direction and turn of the target
    pairs: List[Tuple[str, str]]  #: parts that correspond, (source, target)
    confidences: Optional[List[float]] = None  #: probability of each pair; None if the method does not compute it
    category: Optional[str] = None  #: category whose roles were used; None: no roles were used
    roles: Optional[PairRoles] = None  #: roles of the parts, if there is a category
    features: Optional[ComparedFeatures] = None  #: features that were compared; None: there are none
    blocks: List[Block] = field(default_factory=list)  #: parts that correspond as wholes, each part in one block
    groups: List[GroupMatch] = field(default_factory=list)  #: by group of the deformed shape
    contacts: List[ContactEnergy] = field(default_factory=list)  #: by contact of the deformed shape
    unmatched_source: List[str] = field(default_factory=list)  #: source parts without counterpart
    unmatched_target: List[str] = field(default_factory=list)  #: target parts without counterpart
    seconds: Optional[Seconds] = None  #: seconds of each phase
    search: Optional[SearchSummary] = None  #: how the search went
    warnings: List[str] = field(default_factory=list)  #: what was approximated or ended early, in whole sentences
    solutions: Optional[List[Solution]] = None  #: the best correspondences, if several were asked for
    _handle: Any = field(default=None, repr=False, compare=False)

    @property
    def source_graph(self) -> Graph:
        """The structural graph of the source."""
        return Graph(self._handle.source)

    @property
    def target_graph(self) -> Graph:
        """The structural graph of the target."""
        return Graph(self._handle.target)

    @property
    def labels(self) -> Dict[str, Dict[str, str]]:
        """By side, ``"source"`` or ``"target"``, and name of a part: what pages call it, a short name or its role."""
        return self._looks(0)

    @property
    def colours(self) -> Dict[str, Dict[str, str]]:
        """By side and name of a part: its colour on pages, #rrggbb; one for each role."""
        return self._looks(1)

    def _looks(self, which: int) -> Dict[str, Dict[str, str]]:
        graphs = {"source": self.source_graph, "target": self.target_graph}
        return {side: dict(zip(graphs[side].part_names, looks[which])) for side, looks in self._handle.looks().items()}

    def to_dataframe(self) -> Any:
        """A pandas `DataFrame` of the pairs: source, target, their labels, role, operation, confidence, block."""
        import pandas

        blocks = {(a, b): i for i, block in enumerate(self.blocks) for a in block.source for b in block.target}
        labels = self.labels
        rows = []
        for (source, target), confidence in zip(self.pairs, self.confidences or [None] * len(self.pairs)):
            index = blocks.get((source, target))
            block = None if index is None else self.blocks[index]
            rows.append((source, target, labels["source"][source], labels["target"][target], block and block.role,
                         block and block.operation, confidence, index))
        return pandas.DataFrame(rows, columns=["source", "target", "source_label", "target_label", "role", "operation",
                                               "confidence", "block"])

    def _repr_html_(self) -> str:
        """A small table and a still picture; `show()` and `save()` have the page."""
        labels, colours = self.labels, self.colours
        image = picture([list(zip(graph._handle.drawn_parts(turns, MOST_TRIANGLES), colours[side].values())) for side, graph, turns in (
            ("source", self.source_graph, 0), ("target", self.target_graph, self.target_quarter_turns))])
        rows = ""
        for block in self.blocks[:_MOST_ROWS]:
            names = [", ".join(labels[side][name] for name in getattr(block, side)[:_MOST_NAMES])
                     + (" …" if len(getattr(block, side)) > _MOST_NAMES else "") for side in ("source", "target")]
            sure = "" if block.confidence is None else f"{block.confidence:.0%}"
            swatch = f'<span style="color: {colours["source"][block.source[0]]}">&#9632;</span>'
            cells = [html.escape(text) for text in ((block.role or "").replace("_", " "), *names, block.operation, sure)]
            rows += f"<tr><td>{swatch}</td>" + "".join(f"<td>{cell}</td>" for cell in cells) + "</tr>"
        more = len(self.blocks) - _MOST_ROWS
        heads = ("", "role", self.source_graph.name, self.target_graph.name, "operation", "confidence")
        return (image + "<table><tr>" + "".join(f"<th>{html.escape(head)}</th>" for head in heads) + f"</tr>{rows}</table>"
                + (f"<p>and {more} more</p>" if more > 0 else ""))

    def counterparts(self, source_part: str) -> List[str]:
        """The target parts that correspond to a source part."""
        return [target for source, target in self.pairs if source == source_part]

    def save(self, path: Path) -> None:
        """Writes the match as ``.json``, or a picture of it as ``.glb`` or ``.html``."""
        self._handle.save(os.fspath(path))

    def __repr__(self) -> str:
        return f"<Match of {self.source!r} and {self.target!r}: {len(self.pairs)} pairs in {len(self.blocks)} blocks>"


@with_options
def match(
    source: Input,
    target: Input,
    *,
    part_matching: Optional[Mapping[str, Any]] = None,
    roles: Union[None, str, "os.PathLike[str]", RoleModel] = "auto",
    pinned: Pairs = (),
    forbidden: Pairs = (),
    source_parts: Names = (),
    target_parts: Names = (),
    source_features: Features = None,
    target_features: Features = None,
    cache: Optional[Path] = None,
    threads: int = 0,
    progress: Progress = None,
    **options: Any,
) -> Match:
    """Finds which parts of two shapes correspond. A part may correspond to several, or to none.

    Shapes are `Graph`, `Shape`, what makes a `Shape`, or files. Options of `read()` and `build_graph()` may be given, too,
    for both shapes. Options may have their names in the program, such as ``search`` or ``allow_unmatched``.

    :param source: the source shape
    :param target: the target shape
    :param part_matching: options of ``"parts"`` other than the defaults: weights of the terms in the cost of a pair of
        parts (``overlap``, ``extent``, ``ground``, ``place``, ``orientation``, ``chamfer``), other costs (``whole``,
        ``excess``, ``confident_excess``), lengths in the unit box (``tolerance``, ``warp_width``,
        ``side_depth``, ``wall_width``), shares (``anchor``, ``main_surface``, ``clearly_better``,
        ``category_ratio``), a distance (``category_distance``), the size of a regular arrangement
        (``repetition``), and which sets of parts are matched as a whole (``panels``, ``support``); see
        `Part_matching_options` of the library
    :param roles: role model for ``"parts"``, and for a `role_weight`; shapes must be upright and face +z: ``"auto"`` (the
        model that comes with the package), None (no roles), a model, or its file
    :param pinned: pairs of parts (source, target), by name or index, that must correspond, and to no other parts
    :param forbidden: pairs of parts that must not correspond
    :param source_parts: only these parts of the source, by name or index; empty: all
    :param target_parts: the same for the target
    :param source_features: features of the surface of the source, see `build_graph()`; those of both shapes are compared
    :param target_features: the same for the target
    :param cache: see `build_graph()`
    :param threads: see `build_graph()`
    :param progress: see `build_graph()`; if it returns False, the search ends with what it has found
    :raises InvalidInput: if a shape cannot be used, or an option is out of its range
    """
    of_shapes = {name: options.pop(name) for name in (*defaults("read"), *defaults("build_graph")) if name in options}
    features = (source_features, target_features)
    if sum(given is None for given in features) == 1 and not any(isinstance(shape, Graph) for shape in (source, target)):
        raise _core.InvalidInput("features of one shape are given; give those of the other, too, as both are compared")
    graphs = _graphs([source, target], True, {**of_shapes, "cache": cache, "threads": threads}, progress, features)
    paper = of_shapes.get("paper", False)
    search: Dict[str, Any] = {**options, "part_matching": part_matching, "paper": paper}
    for name, parts, graph in zip(("source_parts", "target_parts"), (source_parts, target_parts), graphs):
        search[name] = _part_indices(parts, graph)
    for name, pairs in (("pinned", pinned), ("forbidden", forbidden)):
        search[name] = [tuple(_part_indices([part], graph)[0] for part, graph in zip(pair, graphs)) for pair in pairs]
    abstraction = of_shapes.get("abstraction", "flow" if paper else "fitted")
    handle = _core.match(graphs[0]._handle, graphs[1]._handle, abstraction, _model_of(roles, search), threads, search,
                         progress)
    return Match.from_dict(json.loads(handle.json()), _handle=handle)


def transfer(
    match: Match,
    values: Union[Mapping[str, Any], Sequence[Any]],
    none: Any = np.nan,
    *,
    progress: Progress = None,
) -> Dict[str, np.ndarray]:
    """Transfers values at the vertices of the source to the vertices of the target, along a match.

    Values that are numbers are interpolated over triangles; integers, booleans and strings are labels, taken from the
    nearest corner.

    :param match: the result of `match()`
    :param values: by name of a source part, or in the order of the parts: an array with one row for each vertex
    :param none: the value at vertices of parts without counterpart
    :return: by name of a target part: an array with one row for each vertex
    :raises InvalidInput: if a shape has no surface, or values do not fit the source
    """
    arrays = _arrays_by_part(match, values)
    example = arrays[0]
    are_labels = example.dtype.kind not in "fc"
    dtype = np.result_type(*arrays, np.asarray(none)) if are_labels else np.result_type(*arrays, float)
    result = {}
    names = match.target_graph.part_names
    for name, (parts, corners, weights) in zip(names, match._handle.surface_places(progress)):
        out = np.full((len(parts), *example.shape[1:]), none, dtype)
        for part in np.unique(parts[parts >= 0]):
            rows = np.flatnonzero(parts == part)
            out[rows] = _interpolated(arrays[part], corners[rows], weights[rows], are_labels)
        result[name] = out
    return result


@dataclass
class TransferredPart(Record):
    """What was transferred to a part of the target."""

    name: str  #: the target part
    #: where its materials, textures and colours come from: source, neighbour (a part that it touches), target (its own),
    #: or neutral (grey)
    looks: str
    sources: List[str]  #: the source parts that it is mapped to; without labels, the one whose looks it has is the first
    neighbour: Optional[str] = None  #: the target part that it touches and looks like
    label: Optional[str] = None  #: the label of most of its faces, where labels were transferred


@dataclass
class TransferredLooks(Record):
    """The result of `transfer_looks()`. `to_dict()` is what ``shape_correspondence transfer --json`` writes."""

    _header: ClassVar[Dict[str, Any]] = {"format": "shape_correspondence/transfer", "version": 1}

    source: str  #: file or name of the source
    target: str  #: file or name of the target
    output: str  #: the file that was written
    texture_size: int  #: width and height of the texture in pixels
    texture_coordinates: str  #: given (those of the target) or new
    labels: Optional[List[str]] = None  #: names of labels by number, where labels were transferred
    parts: List[TransferredPart] = field(default_factory=list)  #: by target part
    warnings: List[str] = field(default_factory=list)  #: what is missing or damaged, in whole sentences


def transfer_looks(
    match: Match, output: Path, *, size: int = 1024, labels: Optional[Path] = None, new_coordinates: bool = False
) -> TransferredLooks:
    """Transfers materials, textures and colours, or labels, from the source to the target along a match, and writes the
    target with them, baked into a texture. The source must be a file, unless labels are transferred.

    :param match: the result of `match()`
    :param output: ``.glb``, ``.obj`` (with ``.mtl`` and ``.png`` beside it) or ``.ply``
    :param size: width and height of the texture in pixels
    :param labels: None, ``"parts"`` (the names of the source's parts) or the file ``labels.json`` of the source
    :param new_coordinates: lay out new texture coordinates even if those of the target can be used
    :raises InvalidInput: if the source has no looks, or a file cannot be read or written
    """
    text = match._handle.transfer_looks(os.fspath(output), size, "" if labels is None else os.fspath(labels),
                                        new_coordinates)
    return TransferredLooks.from_dict(json.loads(text))


def _interpolated(values: np.ndarray, corners: np.ndarray, weights: np.ndarray, are_labels: bool) -> np.ndarray:
    if are_labels:
        return values[corners[np.arange(len(corners)), weights.argmax(axis=1)]]
    weights = weights.reshape(*weights.shape, *[1] * (values.ndim - 1))
    return sum(values[corners[:, k]] * weights[:, k] for k in range(3))


def _arrays_by_part(match: Match, values: Union[Mapping[str, Any], Sequence[Any]]) -> List[np.ndarray]:
    shape = match.source_graph.shape
    if shape is None:
        raise _core.InvalidInput(f"{match.source}: it is a structural graph without surfaces, which values are "
                                 "transferred between; give the model that it was built from")
    parts = shape.parts
    if isinstance(values, Mapping):
        missing = [part.name for part in parts if part.name not in values]
        if missing:
            raise _core.InvalidInput(f"{match.source}: there are no values of the part '{missing[0]}'")
        values = [values[part.name] for part in parts]
    arrays = [np.asarray(array) for array in values]
    if len(arrays) != len(parts):
        raise _core.InvalidInput(f"{match.source}: there are values of {len(arrays)} parts; it has {len(parts)}")
    for part, array in zip(parts, arrays):
        if array.shape[:1] != (len(part.vertices),) or array.shape[1:] != arrays[0].shape[1:]:
            raise _core.InvalidInput(f"{match.source}: the values of part '{part.name}' are of shape {array.shape}; "
                                     f"the part has {len(part.vertices)} vertices")
    return arrays


def _part_indices(parts: Names, graph: Graph) -> List[int]:
    names = graph.part_names
    result = []
    for part in parts:
        if isinstance(part, str) and part not in names:
            raise _core.InvalidInput(f"{graph.file}: there is no part '{part}' to choose; its parts are "
                                     + ", ".join(names))
        index = names.index(part) if isinstance(part, str) else part
        if not 0 <= index < len(names):
            raise _core.InvalidInput(f"{graph.file}: there is no part {index} to choose; it has {len(names)} parts")
        result.append(index)
    return result

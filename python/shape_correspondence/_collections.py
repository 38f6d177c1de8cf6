# Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
# SPDX-License-Identifier: GPL-3.0-or-later
"""Sets of shapes, and scores against labelled parts."""

from __future__ import annotations

import html
import json
import os
import webbrowser
from collections.abc import Mapping
from dataclasses import dataclass, field
from pathlib import Path as _Path
from typing import Any, ClassVar, Dict, List, Optional, Sequence, Tuple, Union

import numpy as np

from . import _core
from ._matches import Match
from ._options import defaults, with_names_of_program, with_options
from ._records import Record
from ._shapes import Graph, Input, Path, Progress, Shape, _graphs
from .roles import LabelledShape, PartRole, PartRoles, _examples, _model_of


@dataclass
class CollectionShape(Record):
    """A shape of a collection."""

    name: str  #: its name, unique in the collection
    file: str  #: the file that it was read from
    parts: List[str]  #: names of its parts


@dataclass
class Medoid(Record):
    """The shape that represents a collection."""

    shape: str  #: its name
    mean_distance: float  #: mean of the distances to the other shapes


@dataclass
class TreeEdge(Record):
    """Two shapes that are joined in the spanning tree."""

    shapes: Tuple[str, str]  #: their names
    distance: float  #: mean of the energies of both directions


@dataclass
class Bridge(Record):
    """Two shapes that match better through others."""

    source: str  #: the source shape
    target: str  #: the target shape
    chain: List[str]  #: the source, the shapes in between, the target
    energy: float  #: the sum of the energies of the steps
    direct_energy: float  #: the energy without a shape in between
    pairs: List[Tuple[str, str]]  #: parts that correspond along the chain
    confidences: List[float]  #: by pair


@dataclass
class CoAnalysis(Record):
    """How many pairs of parts were clustered."""

    shape_pairs: int  #: pairs of shapes whose part maps are clustered
    part_pairs: int  #: pairs of parts
    rejected_part_pairs: int  #: further pairs of parts, left out since too few third shapes confirm them


@dataclass
class Cluster(Record):
    """Parts that correspond over the whole set."""

    label: int  #: 0 is the largest
    parts: List[Tuple[str, str]]  #: (shape, part)


@dataclass
class PairMatch(Record):
    """The corresponding parts of two shapes of a collection."""

    source: str  #: the source shape
    target: str  #: the target shape
    pairs: List[Tuple[str, str]]  #: parts that correspond
    confidences: List[float]  #: by pair


@dataclass(eq=False)
class Collection(Record):
    """The analysis of a set of shapes.

    `to_dict()` is what ``shape_correspondence collection --json`` writes.
    """

    _header: ClassVar[Dict[str, Any]] = {"format": "shape_correspondence/collection", "version": 1}

    shapes: List[CollectionShape]  #: the shapes
    medoid: Medoid  #: the shape of least mean distance to the others
    spanning_tree: List[TreeEdge]  #: a minimum spanning tree by distance
    bridge_count: int  #: ordered pairs of shapes for which a chain costs less
    bridges: List[Bridge]  #: the 100 of these with the largest gain
    co_analysis: CoAnalysis  #: how many pairs of parts were clustered
    clusters: List[Cluster]  #: parts that correspond over the whole set
    energies: Optional[np.ndarray] = None  #: energies, source × target; 0 on the diagonal; None for over 1000 shapes
    matches: Optional[List[PairMatch]] = None  #: of ordered pairs of shapes, if they were asked for
    warnings: List[str] = field(default_factory=list)  #: what was approximated, in whole sentences
    _page: Optional[str] = field(default=None, repr=False, compare=False)

    def show(self) -> str:
        """Opens the page that `collection()` wrote in the browser. Returns its file.

        :raises InvalidInput: if `collection()` was not called with ``html``
        """
        if self._page is None:
            raise _core.InvalidInput("there is no page of this collection; call collection(..., html=FILE)")
        webbrowser.open(_Path(self._page).absolute().as_uri())
        return self._page

    def _repr_html_(self) -> str:
        """A small table of the clusters; the page that `collection()` wrote is shown by `show()`."""
        rows = "".join(f"<tr><td>{html.escape(cluster.parts[0][1])}</td><td>{len(cluster.parts)}</td>"
                       f"<td>{len({shape for shape, _ in cluster.parts})}</td></tr>" for cluster in self.clusters[:30])
        return (f"<p>{len(self.shapes)} shapes, {len(self.clusters)} clusters of parts; medoid: {html.escape(self.medoid.shape)}</p>"
                f"<table><tr><th>cluster of</th><th>parts</th><th>shapes</th></tr>{rows}</table>")

    def __repr__(self) -> str:
        return f"<Collection of {len(self.shapes)} shapes: {len(self.clusters)} clusters of parts>"


@dataclass
class NearShape(Record):
    """A shape that is near to a query."""

    name: str  #: its name
    file: str  #: the file that it was read from
    category: str  #: its category by the roles of its parts, or empty
    distance: float  #: mean of the energies of both directions
    pairs: List[Tuple[str, str]]  #: parts that correspond, (query, shape)
    confidences: List[float]  #: by pair


@dataclass
class Nearest(Record):
    """The shapes that are nearest to a query."""

    _header: ClassVar[Dict[str, Any]] = {"format": "shape_correspondence/nearest", "version": 1}

    query: str  #: its file or name
    category: str  #: category of the query by the roles of its parts, or empty
    shapes: int  #: number of shapes in the collection
    evaluations: int  #: shapes that were matched with the query
    #: shapes of the query's category first, then those of none that is known; among them the nearest first
    nearest: List[NearShape]
    warnings: List[str]  #: what was approximated, in whole sentences


@with_options
def collection(
    shapes: Union[Path, Sequence[Input]],
    *,
    html: Optional[Path] = None,
    roles: Any = "auto",
    cache: Optional[Path] = None,
    threads: int = 0,
    progress: Progress = None,
    **further: Any,
) -> Collection:
    """Matches all ordered pairs of a set of shapes.

    :param shapes: the shapes, a dictionary of them by name, or a folder of them
    :param html: a web page to write
    :param roles: see `match()`
    :param cache: see `build_graph()`
    :param threads: see `build_graph()`
    :param progress: see `build_graph()`
    :param further: options of `match()`
    :raises InvalidInput: if a shape cannot be used, or there are fewer than two
    """
    own = {name: further.pop(name) for name in defaults("collection") if name in further}
    graphs = _collection_graphs(shapes, _of_graphs(further, cache, threads), progress)
    text = _core.collection([graph._handle for graph in graphs], _model_of(roles, further), threads, further, own,
                            "" if html is None else os.fspath(html), progress)
    return Collection.from_dict(json.loads(text), _page=None if html is None else os.fspath(html))


@with_names_of_program
def nearest(
    query: Input,
    shapes: Union[Path, Sequence[Input]],
    count: int = 5,
    *,
    unmatched_energy: float = 0.5,
    roles: Any = "auto",
    cache: Optional[Path] = None,
    threads: int = 0,
    progress: Progress = None,
    **options: Any,
) -> Nearest:
    """Finds the shapes of a set that are nearest to a query, without matching it with all.

    :param query: the query
    :param shapes: the shapes, a dictionary of them by name, or a folder of them
    :param count: number of shapes to find
    :param unmatched_energy: see `collection()`
    :param roles: see `match()`
    :param cache: see `build_graph()`
    :param threads: see `build_graph()`
    :param progress: see `build_graph()`
    :param options: further ones of `match()`
    :raises InvalidInput: if a shape cannot be used
    """
    of_graphs = _of_graphs(options, cache, threads)
    graphs = _collection_graphs(shapes, of_graphs, progress)
    graph = _graphs([query], False, of_graphs, progress)[0]
    text = _core.nearest(graph._handle, [graph._handle for graph in graphs], count, _model_of(roles, options), threads,
                         options, {"unmatched_energy": unmatched_energy}, progress)
    return Nearest.from_dict(json.loads(text))


@with_names_of_program
def transfer_labels(
    source: LabelledShape,
    shapes: Union[Path, Sequence[Input]],
    *,
    roles: Any = "auto",
    cache: Optional[Path] = None,
    threads: int = 0,
    progress: Progress = None,
    **options: Any,
) -> List[PartRoles]:
    """Transfers the labels of one shape to the parts of others. Each part gets the label of the part to which it
    corresponds most probably; a part that the options leave out of the match gets none.

    :param source: the labelled shape
    :param shapes: the shapes that get labels, or a folder of them
    :param roles: see `match()`
    :param cache: see `build_graph()`
    :param threads: see `build_graph()`
    :param progress: see `build_graph()`
    :param options: further ones of `match()`
    :raises InvalidInput: if a shape cannot be used, or a part of the source has no label
    """
    of_graphs = _of_graphs(options, cache, threads)
    (graph, _, labels, _), = _examples([source], of_graphs, progress)
    targets = _collection_graphs(shapes, of_graphs, progress)
    found = _core.transfer_labels(graph, labels, [target._handle for target in targets], _model_of(roles, options),
                                  threads, options, progress)
    return [PartRoles(source.category, [PartRole(name, coarse, fine or None, probability)
                                        for name, (coarse, fine, probability) in zip(target.part_names, parts)
                                        if coarse])
            for target, parts in zip(targets, found)]


def _of_graphs(options: Dict[str, Any], cache: Optional[Path], threads: int) -> Dict[str, Any]:
    """The options of graphs, which are taken out of those of `match()`."""
    chosen = {"abstraction": options.pop("abstraction")} if "abstraction" in options else {}
    if "paper" in options:
        chosen["paper"] = options["paper"]
    return {**chosen, "cache": cache, "threads": threads}


def _collection_graphs(shapes: Union[Path, Sequence[Input]], of_graphs: Dict[str, Any],
                       progress: Progress) -> List[Graph]:
    if isinstance(shapes, (str, os.PathLike)):
        shapes = _core.collection_paths([os.fspath(shapes)])
    elif isinstance(shapes, Mapping):
        shapes = [Shape(shape, name) if not isinstance(shape, (Graph, Shape, str, os.PathLike)) else shape
                  for name, shape in shapes.items()]
    return _graphs(shapes, False, of_graphs, progress)


@dataclass
class MeanScore(Record):
    """The scores of several results."""

    category: Optional[str] = None  #: of the shapes; None: the mean of all, in which every category weighs the same
    results: int = 0  #: number of results
    precision: float = 0  #: right pairs among those found
    recall: float = 0  #: pairs found among the right ones
    f1: float = 0  #: harmonic mean of precision and recall


@dataclass
class Score(Record):
    """The score of one result."""

    file: str  #: file of the result, or the names of its shapes
    category: str  #: of the shapes
    source: str  #: name of the source
    target: str  #: name of the target
    precision: float  #: right pairs among those found
    recall: float  #: pairs found among the right ones
    f1: float  #: harmonic mean of precision and recall
    right: List[Tuple[str, str]]  #: pairs that are right
    wrong: List[Tuple[str, str]]  #: pairs that are not
    missed: List[Tuple[str, str]]  #: right pairs that were not found


@dataclass
class Evaluation(Record):
    """Scores of results against labelled parts.

    `to_dict()` is what ``shape_correspondence evaluate --json`` writes.
    """

    _header: ClassVar[Dict[str, Any]] = {"format": "shape_correspondence/evaluation", "version": 2}

    categories: List[MeanScore]  #: by category
    mean: MeanScore  #: every category weighs the same
    results: List[Score]  #: by result

    def __repr__(self) -> str:
        return f"<Evaluation of {len(self.results)} results: F1 {self.mean.f1:.3f}>"


def evaluate(results: Union[Match, Path, Sequence[Union[Match, Path]]],
             ground_truth: Union[Path, Sequence[Path]]) -> Evaluation:
    """Scores results against labelled parts: precision, recall, F1.

    The labels of a shape are found by the name of the folder of its ``labels.json``, which must be in the path or name of
    the shape that was matched.

    :param results: matches, files of ``match --json``, or folders of them
    :param ground_truth: files ``labels.json``, or folders of them
    :raises InvalidInput: if a result is of shapes that have no labels
    """
    every = [results] if isinstance(results, (Match, str, os.PathLike)) else list(results)
    labels = [ground_truth] if isinstance(ground_truth, (str, os.PathLike)) else list(ground_truth)
    matches = [result._handle for result in every if isinstance(result, Match)]
    files = [os.fspath(result) for result in every if not isinstance(result, Match)]
    return Evaluation.from_dict(json.loads(_core.evaluate(files, matches, [os.fspath(l) for l in labels])))

# Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
# SPDX-License-Identifier: GPL-3.0-or-later
"""Part correspondences of segmented 3D shapes, by the CGAL package Shape_correspondence.

>>> import shape_correspondence as sc
>>> result = sc.match("chair_a.obj", "chair_b.glb")
>>> result.pairs
[('seat', 'rush_seat'), ...]

Shapes are files, `Shape`, triples (name, vertices, faces) of NumPy arrays, dictionaries of meshes, meshes and scenes of
trimesh and PyVista, or structural graphs (`build_graph()`). Options are keyword arguments with the names and defaults
of the library; names of the program's options are taken, too. Results are dataclasses; their `to_dict()` is
the JSON that the program ``shape_correspondence`` writes. Work runs without Python's global lock; Ctrl-C ends most of
it (see the manual). Input that cannot be used raises `InvalidInput`, a `ValueError`.
"""

from . import roles
from ._blends import Blend, BlendTask, blend, schedule_names
from ._collections import (
    Bridge,
    Cluster,
    CoAnalysis,
    Collection,
    CollectionShape,
    Evaluation,
    MeanScore,
    Medoid,
    Nearest,
    NearShape,
    PairMatch,
    Score,
    TreeEdge,
    collection,
    evaluate,
    nearest,
    transfer_labels,
)
from ._core import InvalidInput, __version__
from ._matches import (
    Block,
    ComparedFeatures,
    ContactEnergy,
    EnergyTerms,
    GroupMatch,
    Match,
    PairRoles,
    SearchSummary,
    Seconds,
    Solution,
    TransferredLooks,
    TransferredPart,
    match,
    transfer,
    transfer_looks,
)
from ._shapes import Graph, Part, PartAbstraction, PartGroup, Shape, build_graph, read

__all__ = [
    "Blend", "BlendTask", "Block", "Bridge", "Cluster", "CoAnalysis", "Collection", "CollectionShape",
    "ComparedFeatures", "ContactEnergy", "EnergyTerms", "Evaluation", "Graph", "GroupMatch", "InvalidInput", "Match",
    "MeanScore", "Medoid", "Nearest", "NearShape", "PairMatch", "PairRoles", "Part", "PartAbstraction", "PartGroup",
    "Score", "SearchSummary", "Seconds", "Shape", "Solution", "TransferredLooks", "TransferredPart", "TreeEdge",
    "blend", "build_graph", "collection", "evaluate", "match", "nearest", "read", "roles", "schedule_names",
    "transfer", "transfer_labels", "transfer_looks",
]

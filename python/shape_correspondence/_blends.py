# Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
# SPDX-License-Identifier: GPL-3.0-or-later
"""Shapes in between two shapes."""

from __future__ import annotations

import json
import os
from dataclasses import dataclass
from pathlib import Path as _Path
from typing import Any, ClassVar, Dict, List, Optional, Union

import numpy as np

from . import _core
from ._matches import Match, match
from ._options import defaults, with_options
from ._pages import Page
from ._pictures import picture
from ._records import Record
from ._shapes import Input, Path, Progress, Shape, _graphs


@dataclass
class BlendTask(Record):
    """What happens to one part during a blend, and when."""

    task: str  #: morph, split, merge, shrink, grow or exchange
    begin: float  #: time at which it begins, in [0, 1]
    end: float  #: time at which it ends
    source: Optional[str] = None  #: the source part, if there is one
    target: Optional[str] = None  #: the target part, if there is one
    #: why the part does not become its counterpart: its surface is too different (``"torn"``), or the two are too ``"unlike"``
    obstacle: Optional[str] = None


class Blend(Page):
    """The shapes in between two shapes, made by `blend()`. Called with a time in [0, 1], it returns the shape then."""

    def __init__(self, handle: Any):
        self._handle = handle

    def __call__(self, t: float) -> Shape:
        """The shape at a time: the source at 0, the target at 1.

        :raises InvalidInput: if t is not in [0, 1]
        """
        return Shape._of(self._handle.shape(t, False))

    def solid(self, t: float) -> Shape:
        """The shape at a time as one closed surface, for printing and Boolean operations: a shape with one part.

        :raises InvalidInput: if t is not in [0, 1]
        """
        return Shape._of(self._handle.shape(t, True))

    def _repr_html_(self) -> str:
        """Five still pictures; `show()` and `save()` have the page."""
        shapes = [self(t) for t in (0, 0.25, 0.5, 0.75, 1)]
        turn = np.array([[1, 0, 0], [0, 0, -1], [0, 1, 0]] if abs(shapes[0].up[2]) > 0.5 else np.eye(3))  # y is up in pictures
        return picture([[(part.vertices[part.faces].reshape(-1, 3) @ turn, "#3b8ede") for part in shape.parts] for shape in shapes], 190, 190)

    @property
    def tasks(self) -> List[BlendTask]:
        """What happens to which part, and when."""
        return [BlendTask.from_dict(task) for task in self.to_dict(frames=2)["tasks"]]

    def different(self) -> List["Blend"]:
        """The same blend by each of the schedules that make different in-between shapes, the best first."""
        return [Blend(handle) for handle in self._handle.different()]

    def to_dict(self, frames: int = 25, output: Path = "") -> Dict[str, Any]:
        """The tasks and their times, and the quality of every frame, as ``shape_correspondence blend --json`` writes
        them.

        :param frames: number of frames, at equal time steps
        :param output: the name of the file or folder that the blend is written to
        """
        return json.loads(self._handle.json(os.fspath(output), frames))

    def save(self, path: Path, frames: int = 25) -> None:
        """Writes an animation if the path ends in ``.glb``, a web page if it ends in ``.html``, otherwise a folder with
        one OBJ file for each frame."""
        path = _Path(path)
        if path.suffix == ".html":
            self._handle.save_page(str(path), frames)
            return
        if path.suffix == ".glb":
            self._handle.save_glb(str(path), frames)
            return
        if frames < 2:
            raise _core.InvalidInput(f"frames must be at least 2, not {frames}")
        path.mkdir()
        for frame in range(frames):
            self(frame / (frames - 1)).save(path / f"frame_{frame:03}.obj")


def schedule_names() -> List[str]:
    """The names of the schedules, the orders in which the tasks of a blend can take place."""
    return _core.schedule_names()


@with_options
def blend(
    source: Input,
    target: Input,
    correspondence: Union[None, Match, Path] = None,
    *,
    cache: Optional[Path] = None,
    threads: int = 0,
    progress: Progress = None,
    **further: Any,
) -> Blend:
    """Prepares the blend of two shapes, also of different topology.

    :param source: the source shape; ignored where `correspondence` is a `Match`
    :param target: the target shape; likewise
    :param correspondence: a `Match`, a file of ``match --json``, or None: it is searched for
    :param cache: see `build_graph()`
    :param threads: see `build_graph()`
    :param progress: see `build_graph()`
    :param further: options of `match()`, if the correspondence is searched for, and of the shapes
    :raises InvalidInput: if a shape cannot be used, or has no surface
    """
    own = {name: further.pop(name) for name in defaults("blend") if name in further}
    common = {"cache": cache, "threads": threads}
    if correspondence is not None and further:
        raise TypeError(f"the correspondence is given; leave {', '.join(further)} out")
    if correspondence is None:
        correspondence = match(source, target, progress=progress, **common, **further)
    if isinstance(correspondence, Match):
        handle = correspondence._handle
    else:
        pair = _graphs([source, target], True, common, progress)
        handle = _core.read_match(os.fspath(correspondence), pair[0]._handle, pair[1]._handle)
    return Blend(_core.blend(handle, threads, own, progress))

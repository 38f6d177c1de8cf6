# Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
# SPDX-License-Identifier: GPL-3.0-or-later
"""Dataclasses that mirror the package's JSON files."""

from __future__ import annotations

import dataclasses
import math
import typing
from typing import Any, ClassVar, Dict

import numpy as np


class Record:
    """Base of results: dataclasses whose fields are the keys of a JSON object, in the same order."""

    _header: ClassVar[Dict[str, Any]] = {}

    def to_dict(self) -> Dict[str, Any]:
        """The result as the program writes it with ``--json``: lists, dictionaries, strings, numbers."""
        result = dict(self._header)
        for field in dataclasses.fields(self):  # type: ignore[arg-type]
            value = getattr(self, field.name)
            if value is not None and not field.name.startswith("_"):
                result[field.name] = _plain(value)
        return result

    @classmethod
    def from_dict(cls, values: Dict[str, Any], **others: Any) -> Any:
        """The result from a dictionary, as `to_dict()` returns it or ``--json`` writes it."""
        hints = typing.get_type_hints(cls)
        names = [f.name for f in dataclasses.fields(cls) if not f.name.startswith("_")]  # type: ignore[arg-type]
        known = {name: _typed(hints[name], values[name]) for name in names if name in values}
        return cls(**known, **others)


def _plain(value: Any) -> Any:
    if isinstance(value, Record):
        return value.to_dict()
    if isinstance(value, np.ndarray):
        return value.tolist()
    if isinstance(value, (list, tuple)):
        return [_plain(element) for element in value]
    if isinstance(value, float) and math.isinf(value):
        return "infinite"  # JSON has no infinity
    return value


def _typed(hint: Any, value: Any) -> Any:
    arguments = typing.get_args(hint)
    if type(None) in arguments:
        hint, arguments = arguments[0], typing.get_args(arguments[0])
    if isinstance(hint, type) and issubclass(hint, Record):
        return hint.from_dict(value)
    if hint is np.ndarray:
        return np.array(value)
    if typing.get_origin(hint) is list:
        return [_typed(arguments[0], element) for element in value]
    if typing.get_origin(hint) is tuple:
        return tuple(value)
    return math.inf if value == "infinite" else value

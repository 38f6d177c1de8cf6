# Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
# SPDX-License-Identifier: GPL-3.0-or-later
"""Keyword arguments that stand in the program's table of options: their names, defaults and descriptions."""

import difflib
import functools
import inspect
import re
import textwrap
from typing import Any, Callable, Dict, List, Optional, Sequence, TypeVar

from . import _core

Function = TypeVar("Function", bound=Callable[..., Any])


def defaults(function: str) -> Dict[str, Any]:
    """The defaults of a function's options, by name."""
    return {name: default for name, default, _ in _core.options_of(function)}


def _one_of(name: str, value: Any, words: Dict[str, Any]) -> Any:
    if value not in words:
        raise _core.InvalidInput(f"{name} cannot be {value!r}; known are: {', '.join(words)}")
    return words[value]


def _words(value: Any) -> Any:
    return value.split(",") if isinstance(value, str) else value


def _pairs(value: Any) -> List[Any]:
    """Pairs of parts, also as texts A=B."""
    every = [value] if isinstance(value, str) else value
    return [tuple(pair.split("=", 1)) if isinstance(pair, str) else pair for pair in every]


# Options that have another name or other values in the program: functions that convert their values for the module
_OF_PROGRAM: Dict[str, Callable[[Any], Dict[str, Any]]] = {
    "search": lambda value: {} if value == "auto" else {"search_method": value},
    "roles": lambda value: {"roles": None if isinstance(value, str) and value == "none" else value},
    "alignments": lambda value: {} if value == "auto" else {"alignments": value},
    "source_parts": lambda value: {"source_parts": _words(value)},
    "target_parts": lambda value: {"target_parts": _words(value)},
    "max_parts": lambda value: {"maximum_parts": value},
    "front": lambda value: _one_of("front", value, {"given": {"front_is_sure": True}, "likely": {"front_is_sure": False},
                                                   "auto": {"alignments": 0}}),
    "no_cut": lambda value: {"cut_curves": not value},
    "allow_unmatched": lambda value: {"unmatched_cost": 0.5 if value is True else value},
    "pin": lambda value: {"pinned": _pairs(value)},
    "forbid": lambda value: {"forbidden": _pairs(value)},
    "no_symmetry": lambda value: {"detect_symmetry": not value},
    "symmetries": lambda value: {f"detect_{kind}s": kind in _words(value) for kind in (
        "reflection", "rotation", "translation")},
    "part_kind": lambda value: {"part_kinds": dict(_pairs(value)) if isinstance(value, (str, list)) else value},
    "max_iterations": lambda value: {"maximum_iterations": value},
    "segment": lambda value: {"parts": "segments"} if value else {},
    "cycle_support": lambda value: {"least_cycle_support": value},
}


def with_options(function: Function) -> Function:
    """Names the options of a function, which takes them by `**options`, in its signature and description, and lets it
    take those of the program."""
    options = _core.options_of(function.__name__)
    keywords = {name.replace("_", "-"): name for name, _, _ in options}
    signature = inspect.signature(function)
    own = [p for p in signature.parameters.values() if p.kind is not p.VAR_KEYWORD]
    rest = [p for p in signature.parameters.values() if p.kind is p.VAR_KEYWORD and p.name == "further"]
    listed = [inspect.Parameter(name, inspect.Parameter.KEYWORD_ONLY, default=default, annotation=_type_of(default))
              for name, default, _ in options if name not in signature.parameters]
    lines = "".join(_line(name, text, keywords) for name, _, text in options if name not in signature.parameters)
    result = with_names_of_program(function, [parameter.name for parameter in listed])
    result.__signature__ = signature.replace(parameters=own + listed + rest)  # type: ignore[attr-defined]
    result.__doc__ = inspect.cleandoc(function.__doc__ or "").replace(":raises", lines + ":raises", 1)  # as Python 3.13 has it
    return result


def with_names_of_program(function: Function, options: Sequence[str] = ()) -> Function:
    """Lets a function take the names of options of the program, too, and refuses others with a suggestion."""
    name = function.__name__
    parameters = inspect.signature(function).parameters.values()
    known = {*options, *(p.name for p in parameters if p.kind is not p.VAR_KEYWORD)}
    if "roles" in known or name == "blend":
        known |= {*defaults("match"), "part_matching", "roles", "pinned", "forbidden", "source_parts", "target_parts",
                  "source_features", "target_features",
                  "abstraction"}
    if name in ("match", "blend", "build_graph"):
        known |= {*defaults("read"), *defaults("build_graph")}

    @functools.wraps(function)
    def call(*arguments: Any, **values: Any) -> Any:
        result: Dict[str, Any] = {}
        for given, value in values.items():
            for key, of_key in _OF_PROGRAM.get(given, lambda value: {given: value})(value).items():
                if key not in known:
                    raise TypeError(f"{name}() has no option '{given}'{_suggestion(given, known)}")
                if key != given and key in values:
                    raise TypeError(f"{name}() takes '{key}' or, as the program calls it, '{given}', not both")
                result[key] = of_key
        return function(*arguments, **result)

    return call  # type: ignore[return-value]


def _suggestion(name: str, known: Any) -> str:
    close = difflib.get_close_matches(name, [*known, *_OF_PROGRAM], 1)
    return f"; did you mean '{close[0]}'?" if close else ""


def _type_of(default: Any) -> Any:
    return Optional[str] if default is None else type(default)


def _line(name: str, text: str, keywords: Dict[str, str]) -> str:
    text = re.sub(r"--([a-z][a-z-]*)", lambda match: f"`{keywords.get(match[1], match[1])}`", text)
    return textwrap.fill(f":param {name}: {text}", 116, subsequent_indent="    ") + "\n"

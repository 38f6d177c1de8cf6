# Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
# SPDX-License-Identifier: GPL-3.0-or-later
"""Keyword arguments that stand in the program's table of options: their names, defaults and descriptions."""

import inspect
import re
import textwrap
from typing import Any, Callable, Dict, Optional, TypeVar

from . import _core

Function = TypeVar("Function", bound=Callable[..., Any])


def defaults(function: str) -> Dict[str, Any]:
    """The defaults of a function's options, by name."""
    return {name: default for name, default, _ in _core.options_of(function)}


def with_options(function: Function) -> Function:
    """Names the options of a function, which takes them by `**options`, in its signature and description."""
    options = _core.options_of(function.__name__)
    keywords = {name.replace("_", "-"): name for name, _, _ in options}
    signature = inspect.signature(function)
    own = [p for p in signature.parameters.values() if p.kind is not p.VAR_KEYWORD]
    rest = [p for p in signature.parameters.values() if p.kind is p.VAR_KEYWORD and p.name == "further"]
    listed = [inspect.Parameter(name, inspect.Parameter.KEYWORD_ONLY, default=default, annotation=_type_of(default))
              for name, default, _ in options if name not in signature.parameters]
    function.__signature__ = signature.replace(parameters=own + listed + rest)  # type: ignore[attr-defined]
    lines = "".join(_line(name, text, keywords) for name, _, text in options if name not in signature.parameters)
    function.__doc__ = (function.__doc__ or "").replace("    :raises", lines + "    :raises", 1)
    return function


def _type_of(default: Any) -> Any:
    return Optional[str] if default is None else type(default)


def _line(name: str, text: str, keywords: Dict[str, str]) -> str:
    text = re.sub(r"--([a-z][a-z-]*)", lambda match: f"`{keywords.get(match[1], match[1])}`", text)
    return textwrap.fill(f":param {name}: {text}", 120, initial_indent="    ", subsequent_indent="        ") + "\n"

# Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
# SPDX-License-Identifier: GPL-3.0-or-later
"""Results that are looked at on a web page."""

import html
import tempfile
import webbrowser
from pathlib import Path
from typing import Any


class Page:
    """Base of results whose `save()` writes a web page."""

    save: Any

    def show(self) -> str:
        """Opens the page in the browser. Returns its file, which stays in the folder of temporary files."""
        file = Path(tempfile.mkdtemp(prefix="shape_correspondence_")) / f"{type(self).__name__.lower()}.html"
        self.save(file)
        webbrowser.open(file.as_uri())
        return str(file)

    def _repr_html_(self) -> str:
        with tempfile.TemporaryDirectory() as folder:
            file = Path(folder) / "page.html"
            self.save(file)
            return framed(file)


def framed(file: Path) -> str:
    """A page as a notebook shows it."""
    page = html.escape(file.read_text(encoding="utf-8"))
    return f'<iframe srcdoc="{page}" style="width: 100%; height: 600px; border: 0"></iframe>'

# Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
# SPDX-License-Identifier: GPL-3.0-or-later
"""Results that are looked at on a web page."""

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

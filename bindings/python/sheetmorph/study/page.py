# SPDX-License-Identifier: LGPL-2.1-or-later
"""The page of a study in one offline file: table, plots and thumbnails."""

from __future__ import annotations

import base64
import html
import json
from pathlib import Path
from typing import Any

from ..base.packaged import packaged_text
from .rows import PICTURE, folder_name

# Largest number of thumbnails; of more variants an even selection is shown.
_MOST_THUMBNAILS = 300


def page_of(summary: dict[str, Any], out: Path) -> str:
    """Return the page as text; pictures come from the folders of the variants."""
    text = packaged_text(__package__, "page.html")
    runs = [run["run"] for run in summary["runs"]]
    step = max(1, -(-len(runs) // _MOST_THUMBNAILS))
    pictures = {run: _picture(out / folder_name(run) / PICTURE) for run in runs[::step]}
    data = {**summary, "pictures": {run: found for run, found in pictures.items() if found}}
    told = json.dumps(data, ensure_ascii=False, allow_nan=False).replace("<", "\\u003c")
    return text.replace("STUDY_NAME", html.escape(summary["study"])).replace("STUDY_DATA", told)


def _picture(path: Path) -> str:
    try:
        return base64.b64encode(path.read_bytes()).decode("ascii")
    except OSError:  # not requested, or missing
        return ""

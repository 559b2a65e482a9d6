# SPDX-License-Identifier: LGPL-2.1-or-later
"""The page of a study: table, parallel coordinates, scatter plots, thumbnails; one offline file."""

from __future__ import annotations

import base64
import html
import json
from importlib import resources
from pathlib import Path
from typing import Any

from .rows import PICTURE, folder_name

# Thumbnails a page holds; of more variants it shows some, evenly chosen.
_MOST_THUMBNAILS = 300


def page_of(summary: dict[str, Any], out: Path) -> str:
    """The page as text; pictures are taken from the folders of the variants."""
    text = resources.files("sheetmorph.study").joinpath("page.html").read_text("utf-8")
    runs = [run["run"] for run in summary["runs"]]
    step = max(1, -(-len(runs) // _MOST_THUMBNAILS))
    pictures = {run: _picture(out / folder_name(run) / PICTURE) for run in runs[::step]}
    data = {**summary, "pictures": {run: found for run, found in pictures.items() if found}}
    told = json.dumps(data, ensure_ascii=False, allow_nan=False).replace("<", "\\u003c")
    return text.replace("STUDY_NAME", html.escape(summary["study"])).replace("STUDY_DATA", told)


def _picture(path: Path) -> str:
    try:
        return base64.b64encode(path.read_bytes()).decode("ascii")
    except OSError:  # not asked for, or the variant has none
        return ""

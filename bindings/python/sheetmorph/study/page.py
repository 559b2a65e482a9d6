# SPDX-License-Identifier: LGPL-2.1-or-later
"""The page of a study in one offline file: table, plots and thumbnails."""

from __future__ import annotations

from contextlib import suppress
from pathlib import Path
from typing import Any

from ..base.pages import page
from .rows import PICTURE, folder_name

# Largest number of thumbnails; of more variants an even selection is shown.
_MOST_THUMBNAILS = 300


def page_of(summary: dict[str, Any], out: Path) -> str:
    """Return the page as text; pictures come from the folders of the variants."""
    runs = summary["runs"]
    pictures = {}
    for run in runs[:: max(1, -(-len(runs) // _MOST_THUMBNAILS))]:
        with suppress(OSError):  # not requested, or missing
            pictures[run["run"]] = (out / folder_name(run["run"]) / PICTURE).read_bytes()
    missing = {run["no_picture"] for run in runs if "no_picture" in run}
    return page("study/page.html", study=summary, pictures=pictures, missing=sorted(missing))

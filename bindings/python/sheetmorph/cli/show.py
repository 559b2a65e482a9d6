# SPDX-License-Identifier: LGPL-2.1-or-later
"""The command `show`: draw what a recipe means."""

from __future__ import annotations

import argparse
import sys

from ..files.atomic import FileSet
from ..morph.showing import show
from .progress import progress_on


def execute(wanted: argparse.Namespace, files: FileSet) -> list[str]:
    """Draw the recipe and return the lines to print."""
    with progress_on(sys.stderr, wanted.quiet) as progress:
        show(
            wanted.recipe, wanted.output, wanted.pose, after=wanted.after, view=wanted.view,
            files=files, progress=progress,
        )  # fmt: skip
    return [f"{wanted.output}: written"]

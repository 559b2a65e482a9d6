# SPDX-License-Identifier: LGPL-2.1-or-later
"""The command `show`: draw what a recipe means."""

from __future__ import annotations

import argparse
import sys

from ..files.atomic import FileSet
from ..morph.showing import show
from .output import Outcome
from .progress import progress_on


def execute(wanted: argparse.Namespace, files: FileSet) -> Outcome:
    """Draw the recipe and return the name of the picture."""
    with progress_on(sys.stderr, wanted.quiet) as progress:
        show(
            wanted.recipe, wanted.output, wanted.pose, after=wanted.after, view=wanted.view,
            files=files, progress=progress,
        )  # fmt: skip
    return Outcome([f"{wanted.output}: written"], {"files": [wanted.output]})

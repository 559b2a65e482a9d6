# SPDX-License-Identifier: LGPL-2.1-or-later
"""The command `init`: write a first recipe of some files, to be edited."""

from __future__ import annotations

import argparse
import sys
from pathlib import Path

from ..base.errors import Fault, RecipeError
from ..files.atomic import FileSet
from ..files.comments import is_toml, parsed
from ..starting import starting_recipe
from .output import Outcome, write_text
from .progress import progress_on


def execute(wanted: argparse.Namespace, files: FileSet) -> Outcome:
    """Write the recipe and return it. Raises RecipeError."""
    output = wanted.output or ""
    if wanted.output and not wanted.force and Path(output).exists():
        what = f"{wanted.output} already exists and may have been edited"
        raise RecipeError([Fault("-o", what, "name another file, or pass --force")])
    with progress_on(sys.stderr, wanted.quiet) as progress:
        text = starting_recipe(
            wanted.files, Path(output).parent, progress, is_toml=is_toml(output), unit=wanted.unit
        )
    recipe = parsed(text, output)
    if not wanted.output:
        return Outcome([text.rstrip("\n")], recipe)
    path = write_text(wanted, text, files)
    return Outcome([f"{path}: written; check it with `show`, edit it, then `run` it"], recipe)

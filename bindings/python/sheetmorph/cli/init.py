# SPDX-License-Identifier: LGPL-2.1-or-later
"""The command `init`: write a first recipe of some files, to be edited."""

from __future__ import annotations

import argparse
import sys
from pathlib import Path

from ..base.errors import Fault, RecipeError
from ..files.atomic import FileSet
from ..starting import starting_recipe
from .output import write_text
from .progress import progress_on


def execute(wanted: argparse.Namespace, files: FileSet) -> list[str]:
    """Write the recipe and return the lines to print. Raises RecipeError."""
    if wanted.output and Path(wanted.output).exists():
        what = f"{wanted.output} already exists and may have been edited"
        raise RecipeError([Fault("-o", what, "name another file, or remove it first")])
    folder = Path(wanted.output).parent if wanted.output else Path()
    with progress_on(sys.stderr, wanted.quiet) as progress:
        is_toml = bool(wanted.output) and Path(wanted.output).suffix.lower() == ".toml"
        text = starting_recipe(wanted.files, folder, progress, is_toml=is_toml, unit=wanted.unit)
    if not wanted.output:
        return [text.rstrip("\n")]
    path = write_text(wanted, text, files)
    return [f"{path}: written; check it with `show`, edit it, then `run` it"]

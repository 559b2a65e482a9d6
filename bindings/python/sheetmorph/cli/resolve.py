# SPDX-License-Identifier: LGPL-2.1-or-later
"""The command `resolve`: a recipe with vertex ids in place of its selectors."""

from __future__ import annotations

import argparse
import os
import sys
from pathlib import Path
from typing import Any

from ..files.atomic import FileSet
from ..morph.running import resolve
from ..recipe.writing import recipe_text
from .output import Outcome, write_text
from .progress import progress_on


def execute(wanted: argparse.Namespace, files: FileSet) -> Outcome:
    """Resolve the recipe and write it, or return it. Raises RecipeError, FileError."""
    remarks: list[str] = []
    with progress_on(sys.stderr, wanted.quiet) as progress:
        recipe = resolve(wanted.recipe, progress, remarks)
    for remark in remarks:
        print(f"warning: {remark}", file=sys.stderr)
    if wanted.output is None:
        return Outcome([recipe_text(recipe).rstrip("\n")], recipe)
    path, source = Path(wanted.output), Path(wanted.recipe)
    files.reads.append(source)
    files.reads += (source.parent / part["file"] for part in recipe["parts"] if "file" in part)
    recipe = _seen_from(recipe, source.parent, path.parent)
    write_text(wanted, recipe_text(recipe, path), files)
    return Outcome([f"{path}: {wanted.recipe} with vertex ids"], recipe)


def _seen_from(recipe: dict[str, Any], old: Path, new: Path) -> dict[str, Any]:
    """Return the recipe with its relative paths adapted to another folder."""
    if old.resolve() == new.resolve():
        return recipe
    parts = []
    for part in recipe["parts"]:
        if "file" in part and not os.path.isabs(part["file"]):
            moved = os.path.relpath((old / part["file"]).resolve(), new.resolve())
            part = {**part, "file": moved}
        parts.append(part)
    return {**recipe, "parts": parts}

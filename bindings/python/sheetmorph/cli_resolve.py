# SPDX-License-Identifier: LGPL-2.1-or-later
"""The command `resolve`: a recipe with vertex ids in place of its selectors."""

from __future__ import annotations

import argparse
import os
import sys
from pathlib import Path
from typing import Any

from .cli_find import one_line_each
from .cli_progress import progress_on
from .files.atomic import FileSet


def add_resolve_arguments(commands: Any) -> None:
    """Add `resolve` to the commands of a parser."""
    text = "print a recipe with vertex ids in place of its selectors"
    resolve = commands.add_parser("resolve", help=text)
    resolve.add_argument("recipe", help="JSON file; the part files are relative to it")
    resolve.add_argument("-o", "--output", metavar="FILE", help="write to FILE instead of printing")
    resolve.add_argument("--quiet", action="store_true", help="do not print progress to stderr")


def run_resolve(wanted: argparse.Namespace, files: FileSet) -> list[str]:
    """Resolve the recipe and write it, or return it. Raises RecipeError, FileError."""
    # Imported here, so that --help answers at once.
    from .running import resolve

    remarks: list[str] = []
    with progress_on(sys.stderr, wanted.quiet) as progress:
        recipe = resolve(wanted.recipe, progress, remarks)
    for remark in remarks:
        print(f"warning: {remark}", file=sys.stderr)
    if wanted.output is None:
        return [one_line_each(recipe)]
    path, source = Path(wanted.output), Path(wanted.recipe)
    files.reads.append(source)
    files.reads += (source.parent / part["file"] for part in recipe["parts"] if "file" in part)
    with files:
        text = one_line_each(_seen_from(recipe, source.parent, path.parent))
        files.temporary_for(path).write_text(text + "\n", "utf-8")
        files.commit()
    return [f"{path}: {wanted.recipe} with vertex ids"]


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

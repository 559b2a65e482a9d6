# SPDX-License-Identifier: LGPL-2.1-or-later
"""Protection of files that recipes in the output folder read."""

from __future__ import annotations

from collections.abc import Collection
from pathlib import Path

from ..base.errors import FileError
from .comments import parsed
from .reading import read_text


def require_unread(path: Path, replaced: Collection[Path]) -> None:
    """Check that no recipe in the folder of `path` reads the file. Raises FileError.

    Recipes among the replaced files do not count, because their content changes.
    """
    if not path.exists():
        return
    place = path.resolve()
    for recipe in sorted(path.parent.iterdir()):
        if recipe in replaced or _is_temporary(recipe):
            continue
        if recipe.suffix.lower() in (".json", ".toml") and place in _read_by(recipe):
            what = f'the recipe "{recipe.name}" next to it reads this file'
            raise FileError(path, what, "choose another folder")


def _is_temporary(path: Path) -> bool:
    """Return whether a file still has its temporary name, from a running or a killed process."""
    return path.name.startswith(".") and path.stem.endswith(".tmp")


def _read_by(path: Path) -> set[Path]:
    """Return the mesh files of a recipe, or an empty set for any other file."""
    try:
        text = read_text(path)
        recipe = parsed(text, path)
    except (OSError, ValueError, RecursionError):
        return set()
    parts = recipe.get("parts") if isinstance(recipe, dict) and "sheetmorph" in recipe else None
    entries = [part for part in parts if isinstance(part, dict)] if isinstance(parts, list) else []
    names = [part["file"] for part in entries if isinstance(part.get("file"), str)]
    return {(path.parent / name).resolve() for name in names if "\0" not in name}

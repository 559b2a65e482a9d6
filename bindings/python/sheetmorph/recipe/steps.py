# SPDX-License-Identifier: LGPL-2.1-or-later
"""The option `run --step`, which writes every part of a CAD file also as STEP."""

from __future__ import annotations

from typing import Any

from ..base.errors import Fault, RecipeError
from ..files import is_cad


def with_step(recipe: Any) -> Any:
    """Add `"write": "step"` to every entry of a CAD file without `write`.

    Raises RecipeError if the recipe has no CAD file.
    """
    entries = recipe.get("parts") if isinstance(recipe, dict) else None
    if not isinstance(entries, list):
        return recipe
    asked = [_asked(entry) for entry in entries]
    if not any(isinstance(entry, dict) and "write" in entry for entry in asked):
        what = "no part of the recipe is in a CAD file"
        raise RecipeError([Fault("--step", what, "leave it out: meshes are written as meshes")])
    return {**recipe, "parts": asked}


def _asked(entry: Any) -> Any:
    file = entry.get("file") if isinstance(entry, dict) else None
    if not isinstance(file, str) or not is_cad(file):
        return entry
    return {"write": "step", **entry}

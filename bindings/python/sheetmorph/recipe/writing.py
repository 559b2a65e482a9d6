# SPDX-License-Identifier: LGPL-2.1-or-later
"""Recipes, findings and their values as JSON and TOML."""

from __future__ import annotations

import json
import re
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any

from ..files.comments import is_toml


def recipe_text(recipe: dict[str, Any], path: str | Path = "") -> str:
    """Return a recipe as text, with one line for every entry of a list.

    The text is TOML for a path that ends in .toml, and JSON for any other.
    """
    if is_toml(path):
        known = {key: value for key, value in recipe.items() if value is not None}
        return "\n".join(_lines(known, toml_value, lambda key: f"{_bare(key)} = ")) + "\n"
    lines = list(_lines(recipe, json_value, lambda key: f"  {json_value(key)}: "))
    return "{\n" + ",\n".join(lines) + "\n}\n"


def _lines(
    recipe: dict[str, Any], text_of: Callable[[Any], str], start: Callable[[str], str]
) -> Iterator[str]:
    for key, value in recipe.items():
        is_table = isinstance(value, list) and value and isinstance(value[0], dict)
        rows = ",\n    ".join(map(text_of, value)) if is_table else ""
        yield start(key) + (f"[\n    {rows}\n  ]" if is_table else text_of(value))


def toml_value(value: Any) -> str:
    """Return a value as TOML, with inline tables; keys without a value are left out."""
    if isinstance(value, dict):
        entries = (
            f"{_bare(key)} = {toml_value(one)}" for key, one in value.items() if one is not None
        )
        return f"{{ {', '.join(entries)} }}"
    if isinstance(value, (list, tuple)):
        return f"[{', '.join(map(toml_value, value))}]"
    return _toml_text(value)


def json_value(value: Any) -> str:
    """Return a value as JSON on one line."""
    return json.dumps(value, ensure_ascii=False, allow_nan=False)


def _bare(key: str) -> str:
    return key if re.fullmatch(r"[A-Za-z0-9_-]+", key) else _toml_text(key)


def _toml_text(value: Any) -> str:
    return json_value(value).replace("\x7f", "\\u007f")

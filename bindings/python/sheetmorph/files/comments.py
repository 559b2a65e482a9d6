# SPDX-License-Identifier: LGPL-2.1-or-later
"""JSON as people write it, with comments and commas before closing brackets, and TOML."""

from __future__ import annotations

import json
import re
import tomllib
from pathlib import Path
from typing import Any

_STRING_OR_COMMENT = re.compile(r'"(?:\\.|[^"\\\n])*"|//[^\n]*|/\*.*?\*/', re.DOTALL)
_STRING_OR_LAST_COMMA = re.compile(r'"(?:\\.|[^"\\\n])*"|,(?=\s*[}\]])')


def parsed(text: str, path: str | Path) -> Any:
    """Return the content of a text: TOML if the path ends in .toml, otherwise JSON.

    Raises ValueError.
    """
    return tomllib.loads(text) if is_toml(path) else json.loads(plain_json(text))


def is_toml(path: str | Path) -> bool:
    """Return whether a file is TOML by its name."""
    return Path(path).suffix.lower() == ".toml"


def plain_json(text: str) -> str:
    """Replace comments and trailing commas by blanks, so that error positions stay correct."""
    for pattern, start in ((_STRING_OR_COMMENT, "/"), (_STRING_OR_LAST_COMMA, ",")):
        text = pattern.sub(
            lambda found: _blank(found[0]) if found[0][0] == start else found[0], text
        )
    return text


def _blank(text: str) -> str:
    return re.sub(r"[^\n]", " ", text)

# SPDX-License-Identifier: LGPL-2.1-or-later
"""JSON files of people: recipes and poses, with faults that give line and column."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

from ..errors import Fault, RecipeError


def read_json(path: str | Path) -> Any:
    """The content of a JSON file. Raises RecipeError with one fault."""
    try:
        text = Path(path).read_text("utf-8-sig")
    except OSError as error:
        what = f"cannot be read ({error.strerror or error})"
        raise _error(path, what, "check the path and its rights") from None
    except UnicodeDecodeError:
        raise _error(path, "is not text in UTF-8", "save it as UTF-8") from None
    try:
        return json.loads(text, object_pairs_hook=_without_repeats)
    except json.JSONDecodeError as error:
        where = f"{path}, line {error.lineno}, column {error.colno}"
        raise _error(where, f"not JSON: {error.msg}", "correct it there or just before") from None
    except _Repeated as error:
        what = f'the key "{error}" stands twice in one object'
        raise _error(path, what, "keep one of them") from None
    except (RecursionError, ValueError) as error:
        raise _error(path, f"not JSON that can be used: {error}", "simplify it") from None


class _Repeated(ValueError):
    """A key that stands twice in one object; JSON would keep the last one silently."""


def _without_repeats(pairs: list[tuple[str, Any]]) -> dict[str, Any]:
    found: dict[str, Any] = {}
    for key, value in pairs:
        if key in found:
            raise _Repeated(key)
        found[key] = value
    return found


def _error(where: str | Path, what: str, todo: str) -> RecipeError:
    return RecipeError([Fault(str(where), what, todo)])

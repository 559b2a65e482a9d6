# SPDX-License-Identifier: LGPL-2.1-or-later
"""Recipes and poses from JSON, JSON with comments and TOML; faults have line and column."""

from __future__ import annotations

import json
import re
import tomllib
from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from dataclasses import replace
from pathlib import Path
from typing import Any

from ..base.errors import Fault, RecipeError
from ..files import suffixes, unpacked_name
from ..files.comments import is_toml, plain_json
from ..files.reading import read_text
from .lines import Lines, repeated_key

_TOML_PLACE = re.compile(r" \((?:at line (\d+), column (\d+)|at end of document)\)$")


def read_json(path: str | Path) -> Any:
    """Read the content of a recipe or a pose. Raises RecipeError with one fault.

    A file with the suffix .toml is TOML 1.0. Any other file is JSON, which may have // and /* */
    comments and trailing commas.
    """
    _refuse_part(path)
    text = _text_of(path)
    if is_toml(path):
        return _read_toml(path, text)
    try:
        return json.loads(plain_json(text), object_pairs_hook=_without_repeats)
    except json.JSONDecodeError as error:
        where = f"{path}, line {error.lineno}, column {error.colno}"
        raise _error(where, f"not JSON: {error.msg}", "correct it there or just before") from None
    except _Repeated as error:
        line, column = repeated_key(plain_json(text)) or (1, 1)
        what = f'the key "{error}" appears twice in one object'
        raise _error(f"{path}, line {line}, column {column}", what, "keep one of them") from None
    except (RecursionError, ValueError) as error:
        raise _error(path, f"not JSON that can be used: {error}", "simplify it") from None


def given(data: str | Path | dict[str, Any], name: str = "recipe") -> tuple[Any, Path]:
    """Return the content of a file, or data in memory, with the path that names it in messages.

    The folder of the path is the base of relative paths: for data in memory the working folder.
    Raises RecipeError.
    """
    if isinstance(data, dict):
        return data, Path(f"<{name}>")
    return read_json(data), Path(data)


@contextmanager
def named_in(path: Path) -> Iterator[None]:
    """Add the path of the recipe, line and column to the faults raised inside."""
    try:
        yield
    except RecipeError as error:
        faults = _with_lines(path, error.faults)
        faults = [replace(fault, where=f"{path}, {fault.where}") for fault in faults]
        raise RecipeError(faults) from error


def _with_lines(path: str | Path, faults: Sequence[Fault]) -> list[Fault]:
    """Return the faults with the line of each entry; faults without one stay unchanged."""
    try:
        text = _text_of(path)
        lines = Lines(text if is_toml(path) else plain_json(text), read_json(path), is_toml(path))
    except RecipeError:  # the file changed in the meantime
        return list(faults)
    return [lines.of(fault) for fault in faults]


def _refuse_part(path: str | Path) -> None:
    """Raise RecipeError for a mesh, deck or CAD file in place of a recipe."""
    if unpacked_name(path).suffix.lower() in suffixes():
        name = Path(path).name
        what = "is a part file, not a recipe"
        raise _error(path, what, f"`init {name}` writes a recipe for it")


def _text_of(path: str | Path) -> str:
    try:
        return read_text(path)
    except OSError as error:
        what = f"cannot be read ({error.strerror or error})"
        raise _error(path, what, "check the path and its rights") from None
    except UnicodeDecodeError:
        raise _error(path, "is not text in UTF-8", "save it as UTF-8") from None


def _read_toml(path: str | Path, text: str) -> Any:
    try:
        return tomllib.loads(text)
    except tomllib.TOMLDecodeError as error:
        said = str(error)
        place = _TOML_PLACE.search(said)
        what = f"not TOML: {said[:place.start()] if place else said}"
        where = str(path)
        if place and place[1]:
            where += f", line {place[1]}, column {place[2]}"
        elif place:
            where += f", line {text.count(chr(10)) + 1}"
        raise _error(where, what, "correct it there or just before") from None
    except RecursionError as error:
        raise _error(path, f"not TOML that can be used: {error}", "simplify it") from None


class _Repeated(ValueError):
    """A duplicate key in one object, of which JSON would silently keep the last."""


def _without_repeats(pairs: list[tuple[str, Any]]) -> dict[str, Any]:
    found: dict[str, Any] = {}
    for key, value in pairs:
        if key in found:
            raise _Repeated(key)
        found[key] = value
    return found


def _error(where: str | Path, what: str, todo: str) -> RecipeError:
    return RecipeError([Fault(str(where), what, todo)])

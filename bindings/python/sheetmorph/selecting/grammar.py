# SPDX-License-Identifier: LGPL-2.1-or-later
"""The grammar of selectors: one key gives the kind, others are options of it."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from typing import Any

from ..finding.options import HOLES
from .chosen import SelectorError
from .volumes import VOLUMES, unit

# The admissible options of each kind of selector.
WITH: dict[str, tuple[str, ...]] = {
    "vertices": (),
    **dict.fromkeys(VOLUMES, ()),
    "face_at": ("crease_angle",),
    "rim_at": ("rings", "alone", "crease_angle"),
    "border_at": (),
    "borders_longer": (),
    "piece_at": (),
    "group": (),
    "cad_face_at": ("kind", "name", "number"),
    "cad_edge_at": (),
    "found": ("near", "diameter", "count"),
    "all": (),
    "drawn": (),
    "union": (),
    "intersection": (),
    "minus": (),
    "grow": ("of",),
    "shrink": ("of",),
}
JOINING = ("union", "intersection", "minus")
# Every selector may give an expected number.
_ALWAYS = ("holes",)
_DIRECTIONS = {"half_space": "normal", "slab": "normal", "cylinder": "direction"}

Path = tuple[str | int, ...]


def key_of(selector: Mapping[str, Any]) -> str:
    """Return the key that gives the kind of a selector.

    Raises SelectorError if there is not exactly one.
    """
    keys = [key for key in selector if key in WITH]
    if not keys:
        raise SelectorError("it has no key that selects anything", f"give one of {', '.join(WITH)}")
    if len(keys) > 1:
        what = f'one selector has both "{keys[0]}" and "{keys[1]}"'
        raise SelectorError(what, 'combine two with "union", "intersection" or "minus"')
    return keys[0]


def operands(selector: Any) -> list[tuple[Path, Any]]:
    """Return the selectors inside a selector, with their paths; its form is already checked."""
    if isinstance(selector, list):
        return [((k,), inner) for k, inner in enumerate(selector)]
    for key in JOINING:
        if key in selector:
            return [((key, k), inner) for k, inner in enumerate(selector[key])]
    return [(("of",), selector["of"])] if "of" in selector else []


def form_faults(selector: Any, path: Path = ()) -> Iterator[SelectorError]:
    """Yield faults of a selector that the schema cannot express, each with its path."""
    if isinstance(selector, dict):
        try:
            _check_keys(selector, key_of(selector))
        except SelectorError as error:
            yield error.below(path)
    for place, inner in operands(selector):
        yield from form_faults(inner, (*path, *place))


def _check_keys(selector: Mapping[str, Any], key: str) -> None:
    for other in selector:
        if other != key and other not in WITH[key] and other not in _ALWAYS:
            goes = [f'"{name}"' for name in WITH[key]] or ["nothing"]
            todo = f'leave it out; "{key}" can have {" or ".join(goes)}'
            raise SelectorError(f'"{key}" does not use "{other}"', todo, (other,))
    if "of" in WITH[key] and "of" not in selector:
        raise SelectorError(f'"{key}" has no selector to start from', 'add "of": a selector')
    if key in _DIRECTIONS:
        try:
            unit(selector[key][_DIRECTIONS[key]], _DIRECTIONS[key])
        except SelectorError as error:
            raise error.below((key,)) from None
    if key == "found" and "holes" in selector and selector["found"] not in HOLES:
        raise SelectorError(
            f'a {selector["found"]} is not a hole', 'give the number as "count"', ("holes",)
        )

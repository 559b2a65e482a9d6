# SPDX-License-Identifier: LGPL-2.1-or-later
"""Recipe keys and values that are reserved but not available in this version."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

from ..base.errors import Fault
from .places import place_of
from .values import copied

_ANY = object()


@dataclass(frozen=True)
class _Reserved:
    """A path, in which "*" stands for every entry, a value or any, and the remedy."""

    path: tuple[str, ...]
    value: Any = _ANY
    todo: str = "leave it out"


_OPTIONS = ("margin", "criteria", "modes")
_RESERVED = (
    *(_Reserved((key,)) for key in _OPTIONS),
    *(
        _Reserved((key,), todo="give it to a part")
        for key in ("remesh", "weld", "thin", "thickness")
    ),
    *(_Reserved(("parts", "*", key)) for key in ("refine", *_OPTIONS)),
    *(_Reserved(("features", "*", key)) for key in ("groups", "coaxial", "distance")),
)


def take_out(recipe: dict[str, Any]) -> tuple[dict[str, Any], list[Fault]]:
    """Return a copy of the recipe without unavailable entries, and a fault for each of them."""
    rest = copied(recipe)
    faults = []
    for reserved in _RESERVED:
        for holder, key, place in _matches(rest, reserved.path):
            value = holder[key]
            if reserved.value is _ANY or value == reserved.value:
                text = key if reserved.value is _ANY else f'{key} "{value}"'
                what = f"not available in this version: {text}"
                faults.append(Fault(place_of(recipe, place), what, reserved.todo))
                del holder[key]
    return rest, faults


def _matches(
    node: Any, path: tuple[str, ...], place: tuple[str | int, ...] = ()
) -> list[tuple[dict[str, Any], str, tuple[str | int, ...]]]:
    """Return (holder, key, place) of every value at `path` below `node`."""
    head, rest = path[0], path[1:]
    if head == "*":
        if isinstance(node, dict):
            inner = list(node.items())
        else:
            inner = list(enumerate(node)) if isinstance(node, list) else []
        return [found for key, child in inner for found in _matches(child, rest, (*place, key))]
    if not isinstance(node, dict) or head not in node:
        return []
    if not rest:
        return [(node, head, (*place, head))]
    return _matches(node[head], rest, (*place, head))

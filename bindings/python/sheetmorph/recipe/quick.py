# SPDX-License-Identifier: LGPL-2.1-or-later
"""A pose of a form that is beyond doubt: what every frame of a drag gives, without the schema."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

# Well within what the schema allows of lengths, mm, and angles, degrees.
_FAR = 1e9
_TURNS = 1e6


def is_plainly_sound(pose: Any) -> bool:
    """Whether a pose has the form of the schema; False leaves the verdict, and words, to that."""
    return type(pose) is dict and all(map(_is_entry, pose.items()))


def _is_entry(item: tuple[Any, Any]) -> bool:
    name, entry = item
    return (
        type(name) is str
        and name.isascii()
        and "\0" not in name
        and type(entry) is dict
        and all(key in _CHECKS and _CHECKS[key](value) for key, value in entry.items())
    )


def _is_number(value: Any, largest: float = _FAR) -> bool:
    return type(value) in (float, int) and -largest <= value <= largest


def _is_vector(value: Any) -> bool:
    return type(value) is list and len(value) == 3 and all(map(_is_number, value))


def _is_rotation(value: Any) -> bool:
    return (
        type(value) is dict
        and value.keys() == {"axis", "degrees"}
        and _is_vector(value["axis"])
        and _is_number(value["degrees"], _TURNS)
    )


def _is_size(value: Any) -> bool:
    return _is_number(value) and value > 0


_CHECKS: dict[str, Callable[[Any], bool]] = {
    "translation": _is_vector,
    "pivot": _is_vector,
    "target": _is_vector,
    "rotation": _is_rotation,
    "size": _is_size,
}

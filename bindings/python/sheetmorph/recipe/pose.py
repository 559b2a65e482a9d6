# SPDX-License-Identifier: LGPL-2.1-or-later
"""A pose: motions by name, as recipe entries or as typed objects."""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass, field
from typing import Any, Protocol, TypeGuard

from .feature_entries import Vector, number_of, vector_of

# Within the limits of the schema for lengths, mm, and angles, degrees.
_FAR = 1e9
_TURNS = 1e6


@dataclass(frozen=True)
class Rotation:
    """A rotation by `radians` about `axis`, of any non-zero length; whole turns count."""

    axis: Vector
    radians: float


class Moved(Protocol):
    """The motion of a handle, form feature or point; None keeps the value of the recipe.

    The workbench passes its own motions to the kernel in this form.
    """

    translation: Vector | None
    rotation: Rotation | None
    pivot: Vector | None
    target: Vector | None
    size: float | None

    def entry(self) -> dict[str, Any]:
        """Return the motion as a recipe entry."""


_MEMBERS = ("translation", "rotation", "pivot", "target", "size", "entry")

Pose = dict[str, Any]
"""Name to a Moved or to an entry of a recipe's pose."""


@dataclass
class PoseEntry:
    """An entry of a recipe's pose as a Moved."""

    translation: Vector | None = None
    rotation: Rotation | None = None
    pivot: Vector | None = None
    target: Vector | None = None
    size: float | None = None
    told: dict[str, Any] = field(default_factory=dict)

    def entry(self) -> dict[str, Any]:
        """Return the original entry."""
        return self.told


def pose_of(pose: Pose) -> dict[str, Moved]:
    """Return a pose with typed entries, from a pose of checked form."""
    return {name: _moved(entry) for name, entry in pose.items()}


def entries_of(pose: Any) -> Any:
    """Return a pose as recipe entries; other values stay for the schema to reject."""
    if not isinstance(pose, dict):
        return pose
    return {k: one.entry() if _has_form(one) else one for k, one in pose.items()}


def rotation_of(value: Any) -> Rotation | None:
    """Return the rotation of a recipe entry, or None if it has no numbers."""
    if not isinstance(value, dict):
        return None
    return Rotation(vector_of(value["axis"]), math.radians(value["degrees"]))


def _has_form(entry: Any) -> TypeGuard[Moved]:
    """Return whether a value is a Moved.

    `isinstance` with a data protocol fails inside FreeCAD since Python 3.13.
    """
    return all(hasattr(entry, name) for name in _MEMBERS)


def _moved(entry: Any) -> Moved:
    if type(entry) is not dict:
        moved: Moved = entry
        return moved
    return PoseEntry(
        vector_of(entry.get("translation")),
        rotation_of(entry.get("rotation")),
        vector_of(entry.get("pivot")),
        vector_of(entry.get("target")),
        number_of(entry.get("size")),
        entry,
    )


# -- a fast check for the usual form, because every frame of a drag checks its pose


def is_plainly_sound(pose: Any) -> bool:
    """Return whether a pose is valid; False means that the schema must decide."""
    return type(pose) is dict and all(map(_is_entry, pose.items()))


def _is_entry(item: tuple[Any, Any]) -> bool:
    name, entry = item
    return (
        type(name) is str
        and name.isascii()
        and "\0" not in name
        and (_is_plain(entry) if type(entry) is dict else _is_moved(entry))
    )


def _is_plain(entry: dict[str, Any]) -> bool:
    return all(key in _CHECKS and _CHECKS[key](value) for key, value in entry.items())


def _is_moved(entry: Any) -> bool:
    if not _has_form(entry):
        return False
    vectors = [v for v in (entry.translation, entry.pivot, entry.target) if v is not None]
    turn, size = entry.rotation, entry.size
    if turn is not None:
        vectors.append(turn.axis)
    return (
        all(len(v) == 3 and all(map(_is_number, v)) for v in vectors)
        and (turn is None or _is_number(turn.radians, math.radians(_TURNS)))
        and (size is None or _is_size(size))
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

# SPDX-License-Identifier: LGPL-2.1-or-later
"""A pose: what moves, by name, as a recipe has it or typed by who moves it."""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass, field
from typing import Any, Protocol, TypeGuard

from .feature_entries import Vector, number_of, vector_of

# Well within what the schema allows of lengths, mm, and angles, degrees.
_FAR = 1e9
_TURNS = 1e6


@dataclass(frozen=True)
class Rotation:
    """A turn by `radians` about `axis` (any length but zero); whole turns are kept."""

    axis: Vector
    radians: float


class Moved(Protocol):
    """How one handle, form feature or point moves; None: as the recipe says. The workbench passes
    its own motions down to the kernel as such."""

    translation: Vector | None
    rotation: Rotation | None
    pivot: Vector | None
    target: Vector | None
    size: float | None

    def entry(self) -> dict[str, Any]:
        """The same as a recipe has it."""


_MEMBERS = ("translation", "rotation", "pivot", "target", "size", "entry")

Pose = dict[str, Any]
"""By name a Moved, or an entry of a recipe's pose."""


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
        """The entry itself."""
        return self.told


def pose_of(pose: Pose) -> dict[str, Moved]:
    """A pose of sound form with all its entries typed."""
    return {name: _moved(entry) for name, entry in pose.items()}


def entries_of(pose: Any) -> Any:
    """A pose as a recipe has it; what is none is left to the schema."""
    if not isinstance(pose, dict):
        return pose
    return {k: one.entry() if _has_form(one) else one for k, one in pose.items()}


def rotation_of(value: Any) -> Rotation | None:
    """The turn that a recipe tells; None if it tells none in numbers."""
    if not isinstance(value, dict):
        return None
    return Rotation(vector_of(value["axis"]), math.radians(value["degrees"]))


def _has_form(entry: Any) -> TypeGuard[Moved]:
    """Whether something is a Moved. `isinstance` of a protocol with data fails inside FreeCAD since
    Python 3.13."""
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


# -- the form that is beyond doubt, which every frame of a drag has: no need for the schema


def is_plainly_sound(pose: Any) -> bool:
    """Whether a pose has the form of the schema; False leaves the verdict, and words, to that."""
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

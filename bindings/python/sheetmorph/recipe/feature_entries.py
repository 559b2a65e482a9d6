# SPDX-License-Identifier: LGPL-2.1-or-later
"""What form features may do, what they keep between them, and the plane of symmetry."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

from ..errors import Subject

Vector = tuple[float, float, float]

# Keys of a recipe and the type of the relations in their lists.
RELATIONS = (("groups", "group"), ("coaxial", "coaxial"), ("distance", "distance"))


@dataclass(frozen=True)
class FeatureMotion:
    """What a form feature may do.

    type: "free", "fixed", "translation", "plane", "line" or "axis"; point on the axis, mm;
    direction: of the line or axis, normal of the plane, of any length but zero; keys: those given.
    """

    type: str = "free"
    point: Vector | None = None
    direction: Vector | None = None
    keys: tuple[str, ...] = ()


@dataclass(frozen=True)
class RelationEntry:
    """Form features by name: a "group" that moves as one body, a "coaxial" or a "distance" pair."""

    where: str
    name: str
    type: str
    features: list[str]

    @property
    def subject(self) -> Subject:
        """What a fault names it by."""
        return Subject("group" if self.type == "group" else "pair", self.name)


@dataclass(frozen=True)
class SymmetryEntry:
    """The plane the assembly is symmetric about; normal of any length but zero."""

    point: Vector
    normal: Vector


def feature_motion_of(entry: dict[str, Any]) -> FeatureMotion:
    """The motion of a form feature, of sound form."""
    direction = entry.get("direction", entry.get("normal"))
    return FeatureMotion(
        entry.get("type", "free"), vector_of(entry.get("point")), vector_of(direction), tuple(entry)
    )


def relation_of(kind: str, where: str, k: int, entry: dict[str, Any]) -> RelationEntry:
    """Entry number k of a list of groups or pairs, of sound form."""
    return RelationEntry(where, entry.get("name", f"{kind}{k}"), kind, list(entry["features"]))


def symmetry_of(entry: dict[str, Any] | None) -> SymmetryEntry | None:
    """The plane of symmetry, of sound form."""
    if entry is None:
        return None
    return SymmetryEntry(vector_of(entry["point"]), vector_of(entry["normal"]))


def vector_of(value: Any) -> Any:
    """Three numbers as a Vector; None stays None."""
    return None if value is None else (float(value[0]), float(value[1]), float(value[2]))


def number_of(value: Any) -> float | None:
    """A number as such; None stays None."""
    return None if value is None else float(value)

# SPDX-License-Identifier: LGPL-2.1-or-later
"""Entries for form feature motions, feature groups and pairs, and the symmetry plane."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

from ..base.errors import Subject

Vector = tuple[float, float, float]

# Recipe keys, with the relation type of their entries.
RELATIONS = (("groups", "group"), ("coaxial", "coaxial"), ("distance", "distance"))


@dataclass(frozen=True)
class FeatureMotion:
    """The admissible motion of a form feature.

    type is "free", "fixed", "translation", "plane", "line" or "axis". point lies on the axis, mm.
    direction is that of the line or axis, or the normal of the plane, with any non-zero length.
    keys are the given ones.
    """

    type: str = "free"
    point: Vector | None = None
    direction: Vector | None = None
    keys: tuple[str, ...] = ()


@dataclass(frozen=True)
class RelationEntry:
    """Related features: a "group" that moves as one body, or a "coaxial" or "distance" pair."""

    where: str
    name: str
    type: str
    features: list[str]

    @property
    def subject(self) -> Subject:
        """The entry as named in a fault."""
        return Subject("group" if self.type == "group" else "pair", self.name)


@dataclass(frozen=True)
class SymmetryEntry:
    """The symmetry plane of the assembly; the normal has any non-zero length."""

    point: Vector
    normal: Vector


def feature_motion_of(entry: dict[str, Any]) -> FeatureMotion:
    """Return the motion of a form feature from a checked entry."""
    direction = entry.get("direction", entry.get("normal"))
    return FeatureMotion(
        entry.get("type", "free"), vector_of(entry.get("point")), vector_of(direction), tuple(entry)
    )


def relation_of(kind: str, where: str, k: int, entry: dict[str, Any]) -> RelationEntry:
    """Return entry number k of a list of groups or pairs, from a checked entry."""
    return RelationEntry(where, entry.get("name", f"{kind}{k}"), kind, list(entry["features"]))


def symmetry_of(entry: dict[str, Any] | None) -> SymmetryEntry | None:
    """Return the symmetry plane from a checked entry, or None."""
    if entry is None:
        return None
    return SymmetryEntry(vector_of(entry["point"]), vector_of(entry["normal"]))


def vector_of(value: Any) -> Any:
    """Convert three numbers to a Vector; None stays None."""
    return None if value is None else (float(value[0]), float(value[1]), float(value[2]))


def number_of(value: Any) -> float | None:
    """Convert a number to float; None stays None."""
    return None if value is None else float(value)

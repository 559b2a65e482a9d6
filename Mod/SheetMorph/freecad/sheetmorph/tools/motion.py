# SPDX-License-Identifier: LGPL-2.1-or-later
"""How a region moves: one type from the mouse to the kernel, whose package takes it as it is."""

from __future__ import annotations

import math
from dataclasses import dataclass, replace
from typing import NamedTuple

import numpy as np

Triple = tuple[float, float, float]
CENTROID = "centroid"
"""What scripts and saved poses call a pivot that is none."""
UP = (0.0, 0.0, 1.0)


class Turn(NamedTuple):
    """About an axis of any length."""

    axis: Triple
    radians: float


@dataclass(frozen=True)
class Motion:
    """Always from rest, global: translation mm, axis, angle in degrees, pivot mm.

    translation None: of a form feature, which the sheet moves; axis None: as the sheet turns it;
    pivot None: the centroid; size mm, None: as it is.
    """

    translation: Triple | None = (0.0, 0.0, 0.0)
    axis: Triple | None = UP
    angle: float = 0.0
    pivot: Triple | None = None
    size: float | None = None
    target = None  # points alone have one, and no object in a document

    @property
    def rotation(self) -> Turn | None:
        """What the kernel is told of the turn; None if there is nothing to tell."""
        if self.axis is None or (self.angle == 0.0 and self.translation is not None):
            return None
        return Turn(self.axis if self.angle else UP, math.radians(self.angle))

    def entry(self) -> dict:
        """The same as a recipe has it."""
        told: dict = {}
        if self.translation is not None:
            told["translation"] = list(self.translation)
        if self.rotation is not None:
            told["rotation"] = {"axis": list(self.rotation.axis), "degrees": self.angle}
        if self.pivot is not None:
            told["pivot"] = list(self.pivot)
        return told if self.size is None else {**told, "size": self.size}

    def fault(self) -> str:
        """What is wrong with it, in words; empty if nothing."""
        if self.axis is not None and not any(self.axis):
            return "The axis is zero: give it a direction."
        return ""

    def is_rest(self) -> bool:
        """Whether it moves nothing."""
        return not any(self.translation) and self.angle == 0.0

    def arguments(self) -> dict:
        """The arguments of ``api.set_motion``."""
        pivot = CENTROID if self.pivot is None else self.pivot
        turn = {"axis": self.axis, "angle": self.angle}
        return {"translation": self.translation, **turn, "pivot": pivot}

    def keywords(self) -> dict[str, str]:
        """The same as source text that gives the same numbers."""
        return {name: repr(value) for name, value in self.arguments().items()}

    def shifted(self, shift) -> Motion:
        """The same, farther by (3,) mm."""
        moved = np.asarray(self.translation) + np.asarray(shift)
        return replace(self, translation=rounded(moved))

    def turned(self, translation, axis, angle: float) -> Motion:
        """Another motion about the same pivot; whole turns and axis stay if it turns no farther."""
        other = replace(self, translation=translation)
        if not angle and not self.angle:
            return other
        if angle:
            other = replace(other, axis=axis, angle=angle)
        else:
            other = replace(other, angle=0.0)
        is_same = np.allclose(other.matrix(), self.matrix(), atol=1e-5)
        return replace(self, translation=translation) if is_same else other

    def about(self, pivot, place) -> Motion:
        """The same motion told about another point, the one that has come to ``place`` (3,) mm.

        ``pivot`` (3,) mm: where the present pivot is at rest.
        """
        turn, start = self.matrix(), np.asarray(pivot, float)
        moved = np.asarray(place, float) - start - np.asarray(self.translation)
        found = start + turn.T @ moved
        shift = np.asarray(place, float) - found
        return replace(self, translation=tuple(shift.tolist()), pivot=tuple(found.tolist()))

    def matrix(self) -> np.ndarray:
        """The rotation as a matrix (3, 3)."""
        x, y, z = np.asarray(self.axis, float) / np.linalg.norm(self.axis)
        cross = np.array([[0.0, -z, y], [z, 0.0, -x], [-y, x, 0.0]])
        turn = np.radians(self.angle)
        return np.eye(3) + np.sin(turn) * cross + (1.0 - np.cos(turn)) * (cross @ cross)


def motion_from(entry: dict) -> Motion:
    """What an entry of a recipe's pose tells a handle or a form feature."""
    turn = entry.get("rotation") or {"degrees": 0.0}
    shift = tuple(map(float, entry.get("translation", (0.0, 0.0, 0.0))))
    axis = tuple(map(float, turn["axis"])) if turn["degrees"] else UP
    pivot = tuple(map(float, entry["pivot"])) if "pivot" in entry else None
    return Motion(shift, axis, float(turn["degrees"]), pivot)


def rounded(values) -> Triple:
    """Without digits that no mouse can mean."""
    x, y, z = (round(float(value), 4) + 0.0 for value in values)
    return x, y, z

# SPDX-License-Identifier: LGPL-2.1-or-later
"""The motion of a region, one type from the mouse to the kernel."""

from __future__ import annotations

import math
from dataclasses import dataclass, replace
from typing import NamedTuple

import numpy as np

Triple = tuple[float, float, float]
CENTROID = "centroid"
"""The value of `pivot` in scripts and saved poses for a turn about the centroid."""
UP = (0.0, 0.0, 1.0)


class Turn(NamedTuple):
    """A rotation about an axis of any length."""

    axis: Triple
    radians: float


@dataclass(frozen=True)
class Motion:
    """A motion from rest, global: translation mm, axis, angle in degrees, pivot mm.

    A form feature that follows the sheet has the translation None; an axis None lets the sheet turn
    it. A pivot None is the centroid. A size (mm) None keeps the present size.
    """

    translation: Triple | None = (0.0, 0.0, 0.0)
    axis: Triple | None = UP
    angle: float = 0.0
    pivot: Triple | None = None
    size: float | None = None
    target = None  # only points have a target, and no object of a document has one

    @property
    def rotation(self) -> Turn | None:
        """The rotation for the kernel, None if the motion prescribes none."""
        if self.axis is None or (self.angle == 0.0 and self.translation is not None):
            return None
        return Turn(self.axis if self.angle else UP, math.radians(self.angle))

    def entry(self) -> dict:
        """Return the motion as an entry of a recipe."""
        told: dict = {}
        if self.translation is not None:
            told["translation"] = list(self.translation)
        if self.rotation is not None:
            told["rotation"] = {"axis": list(self.rotation.axis), "degrees": self.angle}
        if self.pivot is not None:
            told["pivot"] = list(self.pivot)
        return told if self.size is None else {**told, "size": self.size}

    def fault(self) -> str:
        """Return the fault of the motion as a sentence, empty if it has none."""
        if self.axis is not None and not any(self.axis):
            return "The axis is zero: give it a direction."
        return ""

    def is_rest(self) -> bool:
        """Return whether the motion moves nothing."""
        return not any(self.translation) and self.angle == 0.0

    def arguments(self) -> dict:
        """Return the arguments of `api.set_motion`."""
        pivot = CENTROID if self.pivot is None else self.pivot
        turn = {"axis": self.axis, "angle": self.angle}
        return {"translation": self.translation, **turn, "pivot": pivot}

    def keywords(self) -> dict[str, str]:
        """Return the arguments as source text that evaluates to the same numbers."""
        return {name: repr(value) for name, value in self.arguments().items()}

    def shifted(self, shift) -> Motion:
        """Return the motion with a further shift (3,) mm."""
        moved = np.asarray(self.translation) + np.asarray(shift)
        return replace(self, translation=rounded(moved))

    def turned(self, translation, axis, angle: float) -> Motion:
        """Return a motion with another translation and rotation about the same pivot.

        Axis and whole turns stay if the rotation is equal to the present one.
        """
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
        """Return the same motion about another pivot, whose moved position is `place` (3,) mm.

        `pivot` (3,) mm is the position of the present pivot at rest.
        """
        turn, start = self.matrix(), np.asarray(pivot, float)
        moved = np.asarray(place, float) - start - np.asarray(self.translation)
        found = start + turn.T @ moved
        shift = np.asarray(place, float) - found
        return replace(self, translation=tuple(shift.tolist()), pivot=tuple(found.tolist()))

    def matrix(self) -> np.ndarray:
        """Return the rotation as a matrix (3, 3)."""
        x, y, z = np.asarray(self.axis, float) / np.linalg.norm(self.axis)
        cross = np.array([[0.0, -z, y], [z, 0.0, -x], [-y, x, 0.0]])
        turn = np.radians(self.angle)
        return np.eye(3) + np.sin(turn) * cross + (1.0 - np.cos(turn)) * (cross @ cross)


def motion_from(entry: dict) -> Motion:
    """Return the motion of a handle or form feature from a recipe's pose entry."""
    turn = entry.get("rotation") or {"degrees": 0.0}
    shift = tuple(map(float, entry.get("translation", (0.0, 0.0, 0.0))))
    axis = tuple(map(float, turn["axis"])) if turn["degrees"] else UP
    pivot = tuple(map(float, entry["pivot"])) if "pivot" in entry else None
    return Motion(shift, axis, float(turn["degrees"]), pivot)


def rounded(values) -> Triple:
    """Return values rounded to 0.0001, since a mouse is less exact."""
    x, y, z = (round(float(value), 4) + 0.0 for value in values)
    return x, y, z

# SPDX-License-Identifier: LGPL-2.1-or-later
"""The motion of a handle as the panel knows it."""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np

Triple = tuple[float, float, float]
CENTROID = "centroid"


@dataclass(frozen=True)
class Motion:
    """Always from rest, global: translation mm, axis, angle in degrees, pivot mm or "centroid"."""

    translation: Triple = (0.0, 0.0, 0.0)
    axis: Triple = (0.0, 0.0, 1.0)
    angle: float = 0.0
    pivot: Triple | str = CENTROID

    def fault(self) -> str:
        """What is wrong with it, in words; empty if nothing."""
        if not any(self.axis):
            return "The axis is zero: give it a direction."
        return ""

    def is_rest(self) -> bool:
        """Whether it moves nothing."""
        return not any(self.translation) and self.angle == 0.0

    def keywords(self) -> dict[str, str]:
        """The arguments of ``api.set_motion`` as source text that gives the same numbers."""
        return {
            "translation": repr(self.translation),
            "axis": repr(self.axis),
            "angle": repr(self.angle),
            "pivot": repr(self.pivot),
        }

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


def rounded(values) -> Triple:
    """Without digits that no mouse can mean."""
    x, y, z = (round(float(value), 4) + 0.0 for value in values)
    return x, y, z

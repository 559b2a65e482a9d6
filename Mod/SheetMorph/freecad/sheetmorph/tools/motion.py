# SPDX-License-Identifier: LGPL-2.1-or-later
"""The motion of a handle as the panel knows it."""

from __future__ import annotations

from dataclasses import dataclass

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

    def keywords(self) -> dict[str, str]:
        """The arguments of ``api.set_motion`` as source text that gives the same numbers."""
        return {
            "translation": repr(self.translation),
            "axis": repr(self.axis),
            "angle": repr(self.angle),
            "pivot": repr(self.pivot),
        }

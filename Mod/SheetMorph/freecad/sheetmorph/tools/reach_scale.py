# SPDX-License-Identifier: LGPL-2.1-or-later
"""The scale of a number with the range that is possible: where what lies on it, from 0 to 1."""

from __future__ import annotations

from dataclasses import dataclass

ROOM = 0.25  # of the range: what is seen beyond each of its ends


@dataclass(frozen=True)
class Scale:
    """The numbers at both ends of a scale."""

    low: float
    high: float

    def place(self, value: float) -> float:
        """Where a number lies, from 0 to 1."""
        return min(1.0, max(0.0, (value - self.low) / (self.high - self.low)))


def scale_for(ends: tuple[float, float], is_limit: tuple[bool, bool], value: float) -> Scale:
    """The scale that shows the ends of a range, something beyond those that are limits, and where
    a value is."""
    room = ROOM * (max(ends[1], value) - min(ends[0], value)) or 1.0
    low = min(ends[0], value) - (room if is_limit[0] or value < ends[0] else 0.0)
    high = max(ends[1], value) + (room if is_limit[1] or value > ends[1] else 0.0)
    return Scale(low, high)

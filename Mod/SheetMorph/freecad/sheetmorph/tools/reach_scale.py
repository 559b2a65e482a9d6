# SPDX-License-Identifier: LGPL-2.1-or-later
"""The scale of a number that shows its possible range, with positions from 0 to 1."""

from __future__ import annotations

from dataclasses import dataclass

ROOM = 0.25  # of the range: what is visible beyond each of its ends


@dataclass(frozen=True)
class Scale:
    """The numbers at both ends of a scale."""

    low: float
    high: float

    def place(self, value: float) -> float:
        """Return the position of a number on the scale, from 0 to 1."""
        return min(1.0, max(0.0, (value - self.low) / (self.high - self.low)))


def scale_for(ends: tuple[float, float], is_limit: tuple[bool, bool], value: float) -> Scale:
    """Return a scale that shows a range, a value and room beyond each end that is a limit."""
    room = ROOM * (max(ends[1], value) - min(ends[0], value)) or 1.0
    low = min(ends[0], value) - (room if is_limit[0] or value < ends[0] else 0.0)
    high = max(ends[1], value) + (room if is_limit[1] or value > ends[1] else 0.0)
    return Scale(low, high)

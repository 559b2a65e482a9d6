# SPDX-License-Identifier: LGPL-2.1-or-later
"""What is to be seen in a picture; nothing here draws."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field


from ..arrays import Floats, Ints

Colour = tuple[float, float, float]

# The colours of the workbench.
SHEET: Colour = (0.80, 0.84, 0.88)
ROLES: dict[str, Colour] = {
    "fixed": (0.12, 0.44, 0.77),
    "handle": (0.94, 0.54, 0.11),
    "form feature": (0.06, 0.64, 0.49),
    "follower": (0.53, 0.34, 0.72),
    "contact, side a": (0.86, 0.16, 0.44),
    "contact, side b": (0.02, 0.66, 0.78),
}
# Where handles go, and about what they turn.
SHIFT: Colour = (0.66, 0.29, 0.02)
TURN: Colour = (0.75, 0.2, 0.6)
# From the grey of the sheet over yellow to dark red.
_RAMP: Sequence[Colour] = (SHEET, (0.99, 0.86, 0.45), (0.93, 0.45, 0.17), (0.62, 0.05, 0.15))


@dataclass(frozen=True, eq=False)
class Sheet:
    """Triangles (m, 3) over points (n, 3) in mm, in one colour or coloured by values (n,).

    lines: (k, 2) point indices of strong lines.
    """

    points: Floats
    triangles: Ints
    colour: Colour = SHEET
    values: Floats | None = None
    lines: Ints | None = None


@dataclass(frozen=True)
class Arrow:
    """From a point to another, mm."""

    start: Sequence[float]
    end: Sequence[float]
    colour: Colour = SHIFT


@dataclass(frozen=True)
class Scene:
    """A picture: what is in it, a title, a legend (text and colour), what values mean with their
    range and colours, and the direction from the middle to the eye."""

    sheets: Sequence[Sheet]
    arrows: Sequence[Arrow] = ()
    title: str = ""
    legend: dict[str, Colour] = field(default_factory=dict)
    values: str = ""
    span: tuple[float, float] = (0.0, 1.0)
    ramp: Sequence[Colour] = _RAMP
    view: tuple[float, float, float] = (0.55, -1.0, 0.75)
    size: tuple[int, int] = (1200, 900)

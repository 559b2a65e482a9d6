# SPDX-License-Identifier: LGPL-2.1-or-later
"""The content of a picture, independent of the drawing."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field


from ..base.arrays import Floats, Ints

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
# Arrows for the shift of a handle, and for its rotation axis.
SHIFT: Colour = (0.66, 0.29, 0.02)
TURN: Colour = (0.75, 0.2, 0.6)
# From the grey of the sheet through yellow to dark red.
_RAMP: Sequence[Colour] = (SHEET, (0.99, 0.86, 0.45), (0.93, 0.45, 0.17), (0.62, 0.05, 0.15))


@dataclass(frozen=True, eq=False)
class Sheet:
    """Triangles (m, 3) over points (n, 3) in mm, in one colour or coloured by values (n,).

    triangles may also be elements (m, 4), with -1 last in a triangle. With is_by_face, the values
    (m,) belong to them and not to the points. lines (k, 2) has the point indices of bold lines.
    """

    points: Floats
    triangles: Ints
    colour: Colour = SHEET
    values: Floats | None = None
    lines: Ints | None = None
    is_by_face: bool = False
    has_edges: bool = False


@dataclass(frozen=True)
class Arrow:
    """An arrow between two points, mm."""

    start: Sequence[float]
    end: Sequence[float]
    colour: Colour = SHIFT


@dataclass(frozen=True)
class Scene:
    """A picture.

    sheets and arrows are its content, and legend maps a text to its colour. values names the
    quantity of the colours, with its range in span and its colours in ramp. view is the direction
    from the centre to the eye.
    """

    sheets: Sequence[Sheet]
    arrows: Sequence[Arrow] = ()
    title: str = ""
    legend: dict[str, Colour] = field(default_factory=dict)
    values: str = ""
    span: tuple[float, float] = (0.0, 1.0)
    ramp: Sequence[Colour] = _RAMP
    view: tuple[float, float, float] = (0.55, -1.0, 0.75)
    size: tuple[int, int] = (1200, 900)

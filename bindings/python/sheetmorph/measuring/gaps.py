# SPDX-License-Identifier: LGPL-2.1-or-later
"""The gap of a contact, measured in one way for table, report, certificate, panel and study."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property
from typing import TYPE_CHECKING

import numpy as np

from ..base.arrays import Floats, Ints
from ..base.kernel import load_kernel

if TYPE_CHECKING:
    from .. import _core


class Surface:
    """A part in one state: vertices (n, 3) in mm and triangles (m, 3)."""

    def __init__(self, places: Floats, triangles: Ints):
        self.places, self.triangles = places, triangles

    @cached_property
    def tree(self) -> _core.PickingTree:
        """Search tree for the nearest point on the surface."""
        found: _core.PickingTree = load_kernel().PickingTree(
            np.ascontiguousarray(self.places), self.triangles
        )
        return found

    def distances(self, points: Floats) -> Floats:
        """Return the distances (k,) in mm from points (k, 3); 0 if the part has no triangles."""
        found: Floats = self.tree.distances(np.ascontiguousarray(points))
        return np.where(np.isfinite(found), found, 0.0)


Pair = tuple[Surface, Surface]
"""The two parts of a contact in one state."""


@dataclass(frozen=True)
class GapChange:
    """The change of a gap from rest to another state.

    before and after are mean gaps and worst is the largest change at a vertex, all in mm. place
    (3,) is the current position of that vertex, None if there are no vertices.
    """

    before: float
    after: float
    worst: float
    place: Floats | None


class ContactGap:
    """The gap of a contact: from every vertex of a side to the nearest point of the other part.

    rest holds both parts at rest, and sides the vertices (k,) that the contact joins on each.
    """

    def __init__(self, rest: Pair, sides: tuple[Ints, Ints]):
        self._sides = sides
        self.rest = self._gaps(rest)

    @cached_property
    def middle(self) -> float:
        """Median gap at rest, mm."""
        return float(np.median(self.rest)) if len(self.rest) else 0.0

    def change(self, now: Pair) -> GapChange:
        """Return the change of the gap from rest to another state of the parts."""
        if not len(self.rest):
            return GapChange(0.0, 0.0, 0.0, None)
        gaps = self._gaps(now)
        changes = np.abs(gaps - self.rest)
        worst = int(changes.argmax())
        places = np.concatenate([part.places[rows] for part, rows in zip(now, self._sides)])
        means = float(self.rest.mean()), float(gaps.mean())
        return GapChange(*means, float(changes[worst]), places[worst])

    def _gaps(self, parts: Pair) -> Floats:
        """Return the gaps (k,) in mm, those of side a first."""
        return np.concatenate(
            [
                other.distances(own.places[rows])
                for own, other, rows in zip(parts, parts[::-1], self._sides)
            ]
        )

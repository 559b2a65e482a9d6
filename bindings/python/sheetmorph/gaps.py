# SPDX-License-Identifier: LGPL-2.1-or-later
"""The gap of a contact, the one measure of it: table, report, certificate, panel and study."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property
from typing import TYPE_CHECKING

import numpy as np

from .arrays import Floats, Ints
from .kernel import load_kernel

if TYPE_CHECKING:
    from . import _core


class Surface:
    """A part in one state: places (n, 3) mm, triangles (m, 3)."""

    def __init__(self, places: Floats, triangles: Ints):
        self.places, self.triangles = places, triangles

    @cached_property
    def tree(self) -> _core.PickingTree:
        """Finds the nearest place on it."""
        found: _core.PickingTree = load_kernel().PickingTree(
            np.ascontiguousarray(self.places), self.triangles
        )
        return found

    def distances(self, points: Floats) -> Floats:
        """(k,) mm from points (k, 3); 0 from a part without triangles."""
        found: Floats = self.tree.distances(np.ascontiguousarray(points))
        return np.where(np.isfinite(found), found, 0.0)


Pair = tuple[Surface, Surface]
"""The two parts of a contact in one state."""


@dataclass(frozen=True)
class GapChange:
    """before, after: the mean gap, mm; worst: the largest change at a vertex, mm, in magnitude;
    place: (3,) where that vertex is now, None without vertices."""

    before: float
    after: float
    worst: float
    place: Floats | None


class ContactGap:
    """The gap of a contact: from every vertex of either side to the nearest place of the other
    part.

    rest: both parts at rest; sides: vertices (k,) of each that the contact joins.
    """

    def __init__(self, rest: Pair, sides: tuple[Ints, Ints]):
        self._sides = sides
        self.rest = self._gaps(rest)

    @cached_property
    def middle(self) -> float:
        """The median gap at rest, mm."""
        return float(np.median(self.rest)) if len(self.rest) else 0.0

    def change(self, now: Pair) -> GapChange:
        """How the gap changes from rest to another state of the parts."""
        if not len(self.rest):
            return GapChange(0.0, 0.0, 0.0, None)
        gaps = self._gaps(now)
        changes = np.abs(gaps - self.rest)
        worst = int(changes.argmax())
        places = np.concatenate([part.places[rows] for part, rows in zip(now, self._sides)])
        means = float(self.rest.mean()), float(gaps.mean())
        return GapChange(*means, float(changes[worst]), places[worst])

    def _gaps(self, parts: Pair) -> Floats:
        """(k,) mm, first from the vertices of side a."""
        return np.concatenate(
            [
                other.distances(own.places[rows])
                for own, other, rows in zip(parts, parts[::-1], self._sides)
            ]
        )

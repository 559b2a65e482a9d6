# SPDX-License-Identifier: LGPL-2.1-or-later
"""Stretch and bending of a sheet in a pose.

They are kinematic: effects of a press or of friction are not included.
"""

from __future__ import annotations

from functools import cached_property

import numpy as np

from ..base.arrays import Floats, Ints
from .strain import areas, curvature_changes, principal_stretches

_MOST_PLACES = 10
_YOUNG = 210e3  # N/mm^2, steel


class SheetStretch:
    """The stretch of a sheet from rest (n, 3) to positions (n, 3), mm, with triangles (m, 3).

    Attributes
    ----------
    rows : array (k,)
        The triangles that are not degenerate; the other arrays have a row for each of them.
    area : array (k,)
        mm^2, at rest.
    stretches : array (k, 2)
        Principal stretches.
    strain : array (k,)
        Largest deviation of a stretch from 1.
    centres : array (k, 3)
        Deformed centroids, mm.
    """

    def __init__(self, rest: Floats, positions: Floats, triangles: Ints):
        stretches = principal_stretches(rest, positions, triangles)
        self.rows: Ints = np.flatnonzero(np.isfinite(stretches).all(axis=1))
        self._shapes = rest, positions, triangles[self.rows]
        self.area: Floats = areas(rest, triangles[self.rows])
        self.stretches: Floats = stretches[self.rows]
        self.strain: Floats = np.abs(self.stretches - 1.0).max(axis=1)
        self.centres: Floats = sum(positions[corner] for corner in triangles[self.rows].T) / 3.0

    def percentile(self, share: float) -> float:
        """Return the strain that a share of the area does not exceed."""
        order = np.argsort(self.strain)
        reached = np.cumsum(self.area[order]) / self.area.sum()
        return float(self.strain[order[np.searchsorted(reached, share)]])

    def share_above(self, strain: float) -> float:
        """Return the share of the area with a larger strain."""
        return float(min(1.0, self.area[self.strain > strain].sum() / self.area.sum()))

    def worst_places(self, apart: float) -> list[int]:
        """Return up to 10 rows with the largest strains, at least `apart` from each other, mm."""
        found: list[int] = []
        left = np.ones(len(self.strain), bool)
        while left.any() and len(found) < _MOST_PLACES:
            worst = int(np.where(left, self.strain, -1.0).argmax())
            found.append(worst)
            left &= np.linalg.norm(self.centres - self.centres[worst], axis=1) > apart
            left[worst] = False
        return found

    @cached_property
    def curvature(self) -> Floats:
        """Principal changes of curvature (k, 2), 1/mm."""
        return _principal(np.nan_to_num(curvature_changes(*self._shapes)))

    def stored(self, thickness: float, poisson: float) -> float:
        """Return the elastic energy of a steel sheet, mJ."""
        strains = 0.5 * (self.stretches**2 - 1.0)
        in_plane = thickness * _energy(strains, poisson)
        bent = thickness**3 / 12.0 * _energy(self.curvature, poisson)
        return float(0.5 * _YOUNG / (1.0 - poisson**2) * (self.area @ (in_plane + bent)))


def _principal(values: Floats) -> Floats:
    """Return the eigenvalues (m, 2) of symmetric matrices (m, 2, 2), ascending."""
    mean, half = 0.5 * (values[:, 0, 0] + values[:, 1, 1]), values[:, 0, 0] - values[:, 1, 1]
    radius = np.hypot(0.5 * half, values[:, 0, 1])
    return np.stack([mean - radius, mean + radius], axis=1)


def _energy(values: Floats, poisson: float) -> Floats:
    """Return (1 - nu) times the sum of squares plus nu times the squared sum of values (m, 2)."""
    found: Floats = (1.0 - poisson) * (values**2).sum(axis=1) + poisson * values.sum(axis=1) ** 2
    return found

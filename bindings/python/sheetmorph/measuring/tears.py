# SPDX-License-Identifier: LGPL-2.1-or-later
"""Cuts in a mesh: coincident vertices of different triangles."""

from __future__ import annotations

import itertools
from dataclasses import dataclass

import numpy as np

from ..base.arrays import Floats, Ints
from ..base.part_mesh import PartMesh

# Shares of the size: coincident vertices are closer than the first; a tear is wider than the
# second.
_SAME, _TORN = 1e-6, 1e-4


@dataclass(frozen=True)
class Tear:
    """A tear: the number of separated vertices, the largest width, mm, and its position (3,)."""

    vertices: int
    width: float
    place: Floats


class Cuts:
    """The cuts of a mesh at rest.

    first (n,) maps every vertex to the first one at the same position.
    """

    def __init__(self, mesh: PartMesh):
        used = np.unique(mesh.triangles)
        points = mesh.points[used]
        self._size = float(np.linalg.norm(np.ptp(points, axis=0))) if len(used) else 0.0
        self._pairs = used[_same_places(points, _SAME * self._size)]
        self.first = np.arange(len(mesh.points))
        for low, high in self._pairs.tolist():
            self.first[high] = self.first[low]

    def tear(self, positions: Floats) -> Tear | None:
        """Return the tear that positions (n, 3) open, or None."""
        ends = positions[self._pairs]
        width = np.linalg.norm(ends[:, 0] - ends[:, 1], axis=1)
        torn = np.flatnonzero(width > _TORN * self._size)
        if not len(torn):
            return None
        widest = int(width.argmax())
        vertices = len(np.unique(self._pairs[torn, 0]))
        return Tear(vertices, float(width[widest]), ends[widest].mean(axis=0))


def _same_places(points: Floats, reach: float) -> Ints:
    """Return pairs (k, 2) of points closer than a distance.

    Points are sorted by the cells of a grid, and of the same grid shifted by half a cell;
    candidates are neighbours in these lists.
    """
    found = [np.empty((0, 2), dtype=np.int64)]
    cell = 2.0 * reach or 1.0
    for shift in itertools.product((0, 1), repeat=3):
        cells = np.floor(points / cell + 0.5 * np.array(shift)).astype(np.int64)
        order = np.lexsort(cells.T)
        same = (cells[order[1:]] == cells[order[:-1]]).all(axis=1)
        found.append(np.stack([order[:-1][same], order[1:][same]], axis=1))
    pairs = np.unique(np.sort(np.concatenate(found), axis=1), axis=0)
    near = np.linalg.norm(points[pairs[:, 0]] - points[pairs[:, 1]], axis=1) <= reach
    result: Ints = pairs[near]
    return result

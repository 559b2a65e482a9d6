# SPDX-License-Identifier: LGPL-2.1-or-later
"""Smallest distance of two parts, and whether they touch."""

from __future__ import annotations

import math

import numpy as np

from ..base.arrays import Floats, Ints
from ..base.kernel import load_kernel
from ..base.part_mesh import PartMesh
from .gaps import Surface

# Vertices to measure before the next check whether the others are too far away.
_AT_ONCE = 1000


class Gap:
    """The distance of two parts."""

    def __init__(self, a: PartMesh, b: PartMesh):
        self._triangles = a.triangles, b.triangles

    def smallest(self, a: Floats, b: Floats) -> float:
        """Return the smallest distance of a vertex of one part from the other, mm; 0 if they touch.

        a and b are positions (n, 3), mm.
        """
        if touching(a, self._triangles[0], b, self._triangles[1]):
            return 0.0
        one, other = (Surface(at, rows) for at, rows in zip((a, b), self._triangles))
        return min(_least(one, other), _least(other, one))


def _least(one: Surface, other: Surface) -> float:
    """Return the smallest distance of a vertex of a surface from another surface, mm."""
    used = one.places[np.unique(one.triangles)]
    low, high = other.places.min(axis=0), other.places.max(axis=0)
    # Vertices are sorted by their distance from the other box, which is a lower bound.
    boxed = np.linalg.norm(np.maximum(0.0, np.maximum(low - used, used - high)), axis=1)
    order, best = np.argsort(boxed, kind="stable"), math.inf
    for first in range(0, len(order), _AT_ONCE):
        if boxed[order[first]] >= best:
            break
        some = used[order[first : first + _AT_ONCE]]
        best = min(best, float(other.distances(some).min()))
    return best


def touching(a: Floats, of_a: Ints, b: Floats, of_b: Ints) -> int:
    """Count the intersecting triangle pairs of two parts: positions (n, 3), triangles (m, 3)."""
    margin = np.minimum(a.max(axis=0), b.max(axis=0)) - np.maximum(a.min(axis=0), b.min(axis=0))
    if (margin < 0.0).any():
        return 0
    low = np.maximum(a.min(axis=0), b.min(axis=0))
    near = [_inside(points, rows, low, low + margin) for points, rows in ((a, of_a), (b, of_b))]
    if not len(near[0]) or not len(near[1]):
        return 0
    core = load_kernel()
    rows = np.concatenate([near[0], near[1] + len(a)]).astype(np.int32)
    mesh = core.TriangleMesh(np.concatenate([a, b]), rows)
    pairs = np.asarray(core.self_intersections(mesh)).reshape(-1, 2)
    return int(((pairs < len(near[0])).sum(axis=1) == 1).sum())


def _inside(points: Floats, rows: Ints, low: Floats, high: Floats) -> Floats:
    """Return the triangles whose box overlaps a box."""
    corners = points[rows]
    meets = (corners.max(axis=1) >= low) & (corners.min(axis=1) <= high)
    found: Floats = rows[meets.all(axis=1)].astype(np.int64)
    return found

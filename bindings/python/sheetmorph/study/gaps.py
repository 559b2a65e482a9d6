# SPDX-License-Identifier: LGPL-2.1-or-later
"""How near two parts come to each other, and whether they touch."""

from __future__ import annotations

import math

import numpy as np

from ..arrays import Floats, Ints
from ..kernel import load_kernel
from ..part_mesh import PartMesh


class Gap:
    """The distance of two parts."""

    def __init__(self, a: PartMesh, b: PartMesh):
        self._triangles = a.triangles, b.triangles

    def smallest(self, a: Floats, b: Floats) -> float:
        """The smallest distance of a vertex of one part from the other, mm; 0 where they touch.

        a, b: positions (n, 3), mm.
        """
        if touching(a, self._triangles[0], b, self._triangles[1]):
            return 0.0
        return min(self._from(0, a, b), self._from(1, b, a))

    def _from(self, which: int, points: Floats, others: Floats) -> float:
        """The smallest distance of points (k, 3) from the other part's triangles."""
        tree = load_kernel().PickingTree(np.array(others), self._triangles[1 - which])
        used = points[np.unique(self._triangles[which])]
        low, high = others.min(axis=0), others.max(axis=0)
        # The nearest by their distance from the other's box first; the rest cannot be nearer.
        boxed = np.linalg.norm(np.maximum(0.0, np.maximum(low - used, used - high)), axis=1)
        best = math.inf
        for k in np.argsort(boxed, kind="stable"):
            if boxed[k] >= best:
                break
            hit = tree.nearest_point(used[k])
            best = min(best, hit.distance)
        return best


def touching(a: Floats, of_a: Ints, b: Floats, of_b: Ints) -> int:
    """How many pairs of triangles of two parts meet; positions (n, 3), triangles (m, 3) of each."""
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
    """The triangles whose box meets a box."""
    corners = points[rows]
    meets = (corners.max(axis=1) >= low) & (corners.min(axis=1) <= high)
    found: Floats = rows[meets.all(axis=1)].astype(np.int64)
    return found

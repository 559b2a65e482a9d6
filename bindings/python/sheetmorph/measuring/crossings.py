# SPDX-License-Identifier: LGPL-2.1-or-later
"""Triangles of a mesh that intersect."""

from __future__ import annotations

import numpy as np

from ..base.arrays import Floats, Ints
from ..base.kernel import load_kernel


def crossings(points: Floats, triangles: Ints) -> Ints:
    """Return sorted pairs (k, 2) of triangles (m, 3) that intersect but share no corner (CGAL)."""
    core = load_kernel()
    pairs = core.self_intersections(core.TriangleMesh(np.array(points), triangles))
    found: Ints = np.asarray(pairs, dtype=np.int64).reshape(-1, 2)
    return found


def new_crossings(pairs: Ints, rest: Ints, corners: Ints) -> Ints:
    """Return the pairs (k, 2) that intersect now, but not at rest.

    corners (m, 3) numbers the corners of all triangles so that vertices at one place have one
    number; triangles that share such a number touch, and do not count.
    """
    width = len(corners)
    is_new = ~np.isin(pairs @ (width, 1), rest @ (width, 1))
    of_pairs = corners[pairs]
    touched = (of_pairs[:, 0, :, None] == of_pairs[:, 1, None, :]).any(axis=(1, 2))
    found: Ints = pairs[is_new & ~touched]
    return found

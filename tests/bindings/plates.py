# SPDX-License-Identifier: LGPL-2.1-or-later
"""Sheets with round holes, made in code: every hole is a ring in a square cell of its own."""

import numpy as np


def plate_with_holes(holes=3, rim=32, rings=5):
    """A row of square cells of 60 mm, a hole of radius 12 mm in each, at z = 0.

    Returns points (n, 3) mm, triangles (m, 3), rims: a list of vertices by hole.
    """
    cell, radius = 60.0, 12.0
    points, triangles, rims, known = [], [], [], {}

    def vertex(p):
        key = tuple(np.round(p, 6))
        if key not in known:
            known[key] = len(points)
            points.append(p)
        return known[key]

    for hole in range(holes):
        centre = np.array([(hole + 0.5) * cell, 0.5 * cell, 0.0])
        ids = np.empty((rings + 1, rim), dtype=int)
        for k in range(rim):
            angle = 2 * np.pi * k / rim
            direction = np.array([np.cos(angle), np.sin(angle), 0.0])
            square = direction * 0.5 * cell / np.abs(direction).max()
            for ring in range(rings + 1):
                t = (ring / rings) ** 1.3
                ids[ring, k] = vertex(centre + (1 - t) * radius * direction + t * square)
        rims.append([int(i) for i in ids[0]])
        for ring in range(rings):
            for k in range(rim):
                a, b = ids[ring, k], ids[ring, (k + 1) % rim]
                c, d = ids[ring + 1, (k + 1) % rim], ids[ring + 1, k]
                triangles += [[a, d, b], [b, d, c]]
    return np.array(points), np.array(triangles, dtype=np.int32), rims


def ends(points):
    """Vertices of the two short borders, (left, right)."""
    x = points[:, 0]
    left = [int(i) for i in np.flatnonzero(x < x.min() + 1e-6)]
    right = [int(i) for i in np.flatnonzero(x > x.max() - 1e-6)]
    return left, right

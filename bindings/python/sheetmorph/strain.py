# SPDX-License-Identifier: LGPL-2.1-or-later
"""How much a mesh was stretched and folded where that is worst, computed from positions alone."""

from __future__ import annotations

import numpy as np

# Of the size: edges that short have no length to compare with.
_NO_LENGTH = 1e-12


def worst_strain(rest: np.ndarray, positions: np.ndarray, triangles: np.ndarray) -> float | None:
    """The largest change of an edge's length over its length at rest; None without edges.

    rest, positions: (n, 3); triangles: (m, 3).
    """
    edges, _ = _edges(triangles)
    before = np.linalg.norm(rest[edges[:, 0]] - rest[edges[:, 1]], axis=1)
    after = np.linalg.norm(positions[edges[:, 0]] - positions[edges[:, 1]], axis=1)
    has_length = before > _NO_LENGTH * np.ptp(rest, axis=0).max(initial=0.0)
    if not has_length.any():
        return None
    return float(np.abs(after[has_length] / before[has_length] - 1.0).max())


def worst_fold(rest: np.ndarray, positions: np.ndarray, triangles: np.ndarray) -> float | None:
    """The largest change of the angle between two triangles with a common edge, degrees; None
    without such.

    rest, positions: (n, 3); triangles: (m, 3).
    """
    edges, owner = _edges(triangles)
    pairs = np.flatnonzero((edges[1:] == edges[:-1]).all(axis=1))
    sides = owner[pairs], owner[pairs + 1]
    change = np.abs(_angles(positions, triangles, sides) - _angles(rest, triangles, sides))
    change = change[np.isfinite(change)]
    return float(np.degrees(change.max())) if len(change) else None


def _edges(triangles: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """(3 m, 2) edges in order, and the triangle (3 m,) each is of."""
    edges = np.sort(np.vstack([triangles[:, [k, (k + 1) % 3]] for k in range(3)]), axis=1)
    order = np.lexsort(edges.T)
    return edges[order], np.tile(np.arange(len(triangles)), 3)[order]


def _angles(points: np.ndarray, triangles: np.ndarray, sides: tuple) -> np.ndarray:
    """(k,) angles between pairs of triangles; NaN where one has no area."""
    corners = points[triangles]
    normals = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    with np.errstate(all="ignore"):
        normals /= np.linalg.norm(normals, axis=1)[:, None]
    a, b = normals[sides[0]], normals[sides[1]]
    return np.arctan2(np.linalg.norm(np.cross(a, b), axis=1), np.einsum("ij,ij->i", a, b))

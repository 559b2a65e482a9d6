# SPDX-License-Identifier: LGPL-2.1-or-later
"""Where two sheets touch: vertices of each that lie within reach of the other's surface."""

from __future__ import annotations

import numpy as np
from scipy.sparse import coo_matrix
from scipy.sparse.csgraph import connected_components
from scipy.spatial import cKDTree

from shapes.planar import mesh_edges
from shapes.sheet import Sheet

CANDIDATES = 16


def touching_patches(
    a: Sheet, b: Sheet, reach: float, margin: float
) -> list[tuple[np.ndarray, np.ndarray]]:
    """Pairs (vertices of a, vertices of b), one per connected patch of a.

    Vertices within `reach` mm of the other surface touch; those within `margin` mm of them are
    taken in too, as a person does who draws a figure around a weld on a coarse mesh.
    """
    low = np.maximum(a.points.min(axis=0), b.points.min(axis=0)) - reach
    high = np.minimum(a.points.max(axis=0), b.points.max(axis=0)) + reach
    if np.any(low > high):
        return []
    near_a = distances(a.points, b) <= reach
    near_b = distances(b.points, a) <= reach
    core = np.vstack([a.points[near_a], b.points[near_b]])
    if len(core) < 3:
        return []
    tree = cKDTree(core)
    near_a |= tree.query(a.points)[0] <= margin
    near_b = np.flatnonzero(near_b | (tree.query(b.points)[0] <= margin))
    patches = [patch for patch in _patches(a, near_a) if len(patch) >= 3]
    if not patches or len(near_b) < 3:
        return []
    away = np.column_stack(
        [cKDTree(a.points[patch]).query(b.points[near_b])[0] for patch in patches]
    )
    owner = away.argmin(axis=1)
    return [(patch, near_b[owner == k]) for k, patch in enumerate(patches)]


def distances(points: np.ndarray, sheet: Sheet) -> np.ndarray:
    """(n,) distances in mm of (n, 3) points from the nearest of each one's closest triangles."""
    corners = sheet.points[sheet.triangles]
    count = min(CANDIDATES, len(corners))
    _, candidates = cKDTree(corners.mean(axis=1)).query(points, k=count)
    best = np.full(len(points), np.inf)
    for k in range(count):
        best = np.minimum(best, _from_triangles(points, corners[candidates[:, k]]))
    return best


def _patches(sheet: Sheet, chosen: np.ndarray) -> list[np.ndarray]:
    """Connected components of the chosen vertices, in order of their first vertex."""
    edges = mesh_edges(sheet.triangles)
    edges = edges[chosen[edges].all(axis=1)]
    size = len(sheet.points)
    graph = coo_matrix((np.ones(len(edges)), (edges[:, 0], edges[:, 1])), shape=(size, size))
    _, labels = connected_components(graph, directed=False)
    first = {}
    for vertex in np.flatnonzero(chosen):
        first.setdefault(labels[vertex], []).append(int(vertex))
    return [np.array(patch) for patch in first.values()]


def _from_triangles(points: np.ndarray, corners: np.ndarray) -> np.ndarray:
    """(n,) distance of point i from triangle i."""
    first, second = corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0]
    normal = np.cross(first, second)
    square = np.sum(normal**2, axis=1)
    offset = points - corners[:, 0]
    v = np.sum(np.cross(offset, second) * normal, axis=1) / square
    w = np.sum(np.cross(first, offset) * normal, axis=1) / square
    plane = np.abs(np.sum(offset * normal, axis=1)) / np.sqrt(square)
    rim = np.min(
        [_from_segments(points, corners[:, k], corners[:, (k + 1) % 3]) for k in range(3)], axis=0
    )
    return np.where((v >= 0) & (w >= 0) & (v + w <= 1), plane, rim)


def _from_segments(points: np.ndarray, start: np.ndarray, end: np.ndarray) -> np.ndarray:
    span = end - start
    share = np.clip(np.sum((points - start) * span, axis=1) / np.sum(span**2, axis=1), 0, 1)
    return np.linalg.norm(points - start - share[:, None] * span, axis=1)

# SPDX-License-Identifier: LGPL-2.1-or-later
"""The edges of a mesh that are drawn as wires."""

from __future__ import annotations

import numpy as np


def of_faces(faces: np.ndarray) -> np.ndarray:
    """Return the unique edges (k, 2) of faces (e, 4) with -1 as last corner of triangles."""
    corners = np.asarray(faces, dtype=np.int64).reshape(-1, 4)
    last = np.where(corners[:, 3] >= 0, corners[:, 3], corners[:, 0])
    ring = np.concatenate([corners[:, :3], last[:, None]], axis=1)
    ends = np.sort(np.stack([ring, np.roll(ring, -1, axis=1)], axis=2).reshape(-1, 2), axis=1)
    return np.unique(ends[ends[:, 0] != ends[:, 1]], axis=0)


def of_all(meshes) -> np.ndarray:
    """Return the wires (e, 2) of meshes (vertices, triangles), numbered through all meshes."""
    found, first = [np.zeros((0, 2), np.int64)], 0
    for points, triangles in meshes:
        found.append(of_mesh(points, triangles) + first)
        first += len(points)
    return np.concatenate(found)


def of_mesh(points: np.ndarray, triangles: np.ndarray) -> np.ndarray:
    """Return the edges (e, 2) of a mesh without the diagonals of quads.

    A control mesh consists of quads, each cut into two triangles by its longest edge. `points` are
    (n, 3), `triangles` (t, 3).
    """
    corners = np.asarray(triangles, dtype=np.int64)
    if not len(corners):
        return np.zeros((0, 2), np.int64)
    ends = np.stack([corners, np.roll(corners, -1, axis=1)], axis=2)
    lengths = np.linalg.norm(points[ends[..., 1]] - points[ends[..., 0]], axis=2)
    longest = np.zeros(lengths.shape, bool)
    longest[np.arange(len(corners)), lengths.argmax(axis=1)] = True
    edges, inverse = np.unique(np.sort(ends.reshape(-1, 2), axis=1), axis=0, return_inverse=True)
    votes = np.bincount(inverse.ravel(), weights=longest.ravel(), minlength=len(edges))
    return edges[votes < 2]

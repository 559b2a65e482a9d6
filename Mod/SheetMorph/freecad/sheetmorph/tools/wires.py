# SPDX-License-Identifier: LGPL-2.1-or-later
"""Which edges of a mesh are drawn as wires."""

from __future__ import annotations

import numpy as np


def of_faces(faces: np.ndarray) -> np.ndarray:
    """The edges (k, 2), each once, of faces (e, 4) with -1 in the last corner of triangles."""
    corners = np.asarray(faces, dtype=np.int64).reshape(-1, 4)
    last = np.where(corners[:, 3] >= 0, corners[:, 3], corners[:, 0])
    ring = np.concatenate([corners[:, :3], last[:, None]], axis=1)
    ends = np.sort(np.stack([ring, np.roll(ring, -1, axis=1)], axis=2).reshape(-1, 2), axis=1)
    return np.unique(ends[ends[:, 0] != ends[:, 1]], axis=0)


def of_all(meshes) -> np.ndarray:
    """The wires (e, 2) of meshes (vertices, triangles), numbered through all of them."""
    found, first = [np.zeros((0, 2), np.int64)], 0
    for points, triangles in meshes:
        found.append(of_mesh(points, triangles) + first)
        first += len(points)
    return np.concatenate(found)


def of_mesh(points: np.ndarray, triangles: np.ndarray) -> np.ndarray:
    """The edges (e, 2) of a mesh without those that only halve a quad.

    A control mesh is made of quads, each cut into two triangles: the cut is the longest edge of
    both. (m, 3) points, (t, 3) triangles.
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

# SPDX-License-Identifier: LGPL-2.1-or-later
"""Normals for drawing a mesh, smooth over bends and broken at creases.

A slower replacement for `bindings/coin/shading.h` where that cannot be loaded.
"""

from __future__ import annotations

import numpy as np


class Shading:
    """The normal of each corner of each triangle; corners share one across smooth edges."""

    def __init__(self, points: np.ndarray, triangles: np.ndarray, crease: float):
        """Group the corners of a mesh at rest.

        `points` are (n, 3), `triangles` (m, 3). Edges above `crease` radians are sharp.
        """
        self._triangles = np.asarray(triangles, np.int64)
        joined = _joined_corners(np.asarray(points, float), self._triangles, crease)
        _, of_corner = np.unique(joined, return_inverse=True)
        self.of_corner = of_corner.reshape(-1, 3)
        """The row of `normals` of each corner, (m, 3)."""

    def normals(self, points: np.ndarray) -> np.ndarray:
        """Return unit normals (k, 3) at positions (n, 3); zero without an area."""
        areas = np.repeat(_areas(points, self._triangles), 3, axis=0)
        rows, count = self.of_corner.ravel(), int(self.of_corner.max(initial=-1)) + 1
        sums = [np.bincount(rows, weights=areas[:, k], minlength=count) for k in range(3)]
        return _unit(np.stack(sums, axis=1))


def _areas(points: np.ndarray, triangles: np.ndarray) -> np.ndarray:
    """Return twice the areas of triangles as vectors, (m, 3)."""
    a, b, c = (points[triangles[:, k]] for k in range(3))
    return np.cross(b - a, c - a)


def _unit(vectors: np.ndarray) -> np.ndarray:
    """Return vectors (k, 3) scaled to length 1; zero stays zero."""
    length = np.linalg.norm(vectors, axis=1, keepdims=True)
    return np.divide(vectors, length, out=np.zeros_like(vectors), where=length > 0.0)


def _joined_corners(points: np.ndarray, triangles: np.ndarray, crease: float) -> np.ndarray:
    """Return for every corner (3 m,) the least corner with the same normal."""
    one, other = _smooth_pairs(points, triangles, crease)
    least = np.arange(triangles.size)
    while True:
        lower = np.minimum(least[one], least[other])
        before = least.copy()
        np.minimum.at(least, one, lower)
        np.minimum.at(least, other, lower)
        if np.array_equal(before, least):
            return least


def _smooth_pairs(points: np.ndarray, triangles: np.ndarray, crease: float) -> tuple:
    """Return pairs of corners at one vertex on both sides of a smooth edge."""
    corners = np.arange(triangles.size).reshape(-1, 3)
    starts, ends = triangles.ravel(), np.roll(triangles, -1, axis=1).ravel()
    at_start, at_end = corners.ravel(), np.roll(corners, -1, axis=1).ravel()
    turned = starts > ends
    low, high = np.where(turned, ends, starts), np.where(turned, starts, ends)
    at_low, at_high = np.where(turned, at_end, at_start), np.where(turned, at_start, at_end)
    order = np.lexsort((corners.ravel() // 3, high, low))
    low, high, at_low, at_high = low[order], high[order], at_low[order], at_high[order]
    normals = _unit(_areas(points, triangles))[at_low // 3]
    is_same = (low[:-1] == low[1:]) & (high[:-1] == high[1:])
    is_smooth = np.einsum("ij,ij->i", normals[:-1], normals[1:]) >= np.cos(crease)
    chosen = np.flatnonzero(is_same & is_smooth)
    one = np.concatenate([at_low[chosen], at_high[chosen]])
    return one, np.concatenate([at_low[chosen + 1], at_high[chosen + 1]])

# SPDX-License-Identifier: LGPL-2.1-or-later
"""The axes of a handle: its length, its width and the normal of the sheet there."""

from __future__ import annotations

import numpy as np

GLOBAL = np.eye(3)
ROUND = 1e-6  # of the largest spread: two directions that differ by less are equally long


def local_axes(points: np.ndarray, triangles: np.ndarray, vertices: np.ndarray) -> np.ndarray:
    """Return the axes of a handle as the columns of a rotation (3, 3).

    Z is the mean normal of the triangles (m, 3) of `points` (n, 3) mm around the handle's vertices
    (k,), weighted by area. X is the longest direction of the handle across Z. A handle without such
    a direction has X along the global axis that is farthest from Z.
    """
    is_own = np.zeros(len(points), bool)
    is_own[vertices] = True
    count = is_own[triangles].sum(axis=1)
    near = triangles[count == 3] if (count == 3).any() else triangles[count > 0]
    a, b, c = (points[near[:, k]] for k in range(3))
    normal = np.cross(b - a, c - a).sum(axis=0)
    if np.linalg.norm(normal) == 0.0:
        return GLOBAL
    z = normal / np.linalg.norm(normal)
    x = _along(points[vertices], z)
    return np.column_stack([x, np.cross(z, x), z])


def to_local(axes: np.ndarray, vector) -> tuple[float, float, float]:
    """Return the components of a vector (3,) along axes (3, 3), without the noise of `to_global`.

    GLOBAL changes no bit of it.
    """
    return tuple(vector) if axes is GLOBAL else _product(axes.T, vector, 9)


def to_global(axes: np.ndarray, vector) -> tuple[float, float, float]:
    """Return the vector (3,) with these components along axes (3, 3); GLOBAL changes no bit."""
    return tuple(vector) if axes is GLOBAL else _product(axes, vector, 12)


def _product(matrix: np.ndarray, vector, digits: int) -> tuple[float, float, float]:
    x, y, z = (round(float(c), digits) + 0.0 for c in matrix @ np.asarray(vector, float))
    return x, y, z


def _along(points: np.ndarray, z: np.ndarray) -> np.ndarray:
    """Return the longest direction of points (k, 3) across a unit vector, on its positive side."""
    flat = points - points.mean(axis=0)
    flat = flat - np.outer(flat @ z, z)
    spreads, directions = np.linalg.eigh(flat.T @ flat)
    if spreads[2] - spreads[1] > ROUND * spreads[2]:
        x = directions[:, 2] - (directions[:, 2] @ z) * z
    else:
        x = np.eye(3)[int(np.abs(z).argmin())]
        x = x - (x @ z) * z
    x = x / np.linalg.norm(x)
    return x if x[int(np.abs(x).argmax())] > 0.0 else -x

# SPDX-License-Identifier: LGPL-2.1-or-later
"""Quality measures of shell elements; each docstring gives the definition."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np

from ..base.arrays import Floats, Ints
from ..base.blocks import chunks

_GAUSS = 1.0 / np.sqrt(3.0)
_CORNERS = np.array([[-1, -1], [1, -1], [1, 1], [-1, 1]], dtype=float)


def _edges(corners: Floats) -> Floats:
    return np.roll(corners, -1, axis=1) - corners


def _lengths(corners: Floats) -> Floats:
    found: Floats = np.linalg.norm(_edges(corners), axis=2)
    return found


def _angles(corners: Floats) -> Floats:
    """Return the corner angles (m, k) in degrees."""
    ahead = _edges(corners)
    behind = -np.roll(ahead, 1, axis=1)
    cosine = _ratio((ahead * behind).sum(axis=2), _norm(ahead) * _norm(behind), 1.0)
    found: Floats = np.degrees(np.arccos(np.clip(cosine, -1.0, 1.0)))
    return found


def _norm(vectors: Floats) -> Floats:
    found: Floats = np.linalg.norm(vectors, axis=-1)
    return found


def _ratio(above: Floats, below: Floats, otherwise: float) -> Floats:
    return np.divide(above, below, out=np.full(below.shape, otherwise), where=below > 0.0)


def areas(corners: Floats) -> Floats:
    """Return the areas (m,) of triangles (m, 3, 3) or quads (m, 4, 3).

    The area of a quad is half the cross product of its diagonals.
    """
    if corners.shape[1] == 3:
        one, two = corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0]
    else:
        one, two = corners[:, 2] - corners[:, 0], corners[:, 3] - corners[:, 1]
    return 0.5 * _norm(np.cross(one, two))


def aspect(corners: Floats) -> Floats:
    """Return the longest edge over the shortest."""
    length = _lengths(corners)
    return _ratio(length.max(axis=1), length.min(axis=1), 1e9)


def warpage(corners: Floats) -> Floats:
    """Return the angle between the two triangles of a quad, for the worse diagonal, degrees.

    It is 0 for triangles.
    """
    if corners.shape[1] == 3:
        return np.zeros(len(corners))
    worst = np.zeros(len(corners))
    for k in (0, 1):
        a, b, c, d = (corners[:, (k + j) % 4] for j in range(4))
        one, two = np.cross(b - a, c - a), np.cross(c - a, d - a)
        cosine = _ratio((one * two).sum(axis=1), _norm(one) * _norm(two), 1.0)
        worst = np.maximum(worst, np.degrees(np.arccos(np.clip(cosine, -1.0, 1.0))))
    return worst


def skew(corners: Floats) -> Floats:
    """Return the skew in degrees.

    For a quad it is 90 degrees minus the angle between the lines through opposite edge midpoints.
    For a triangle it is 90 degrees minus the smallest angle between a median and the line through
    the midpoints of the other two edges.
    """
    middle = 0.5 * (corners + np.roll(corners, -1, axis=1))
    if corners.shape[1] == 4:
        pairs = [(middle[:, 2] - middle[:, 0], middle[:, 3] - middle[:, 1])]
    else:
        pairs = [
            (corners[:, k] - middle[:, (k + 1) % 3], middle[:, k] - middle[:, (k + 2) % 3])
            for k in range(3)
        ]
    worst = np.zeros(len(corners))
    for one, two in pairs:
        cosine = _ratio(np.abs((one * two).sum(axis=1)), _norm(one) * _norm(two), 1.0)
        angle = np.degrees(np.arccos(np.clip(cosine, 0.0, 1.0)))
        worst = np.maximum(worst, 90.0 - angle)
    return worst


def taper(corners: Floats) -> Floats:
    """Return 1 minus the smallest of the four corner triangles over half the quad.

    It is 0 for triangles.
    """
    if corners.shape[1] == 3:
        return np.zeros(len(corners))
    parts = np.stack([areas(corners[:, [(k - 1) % 4, k, (k + 1) % 4]]) for k in range(4)], axis=1)
    return 1.0 - _ratio(parts.min(axis=1), 0.25 * parts.sum(axis=1), 0.0)


def jacobian(corners: Floats) -> Floats:
    """Return the smallest over the largest determinant at the 2 x 2 Gauss points.

    It is 1 for triangles.
    """
    if corners.shape[1] == 3:
        return np.ones(len(corners))
    normal = np.cross(corners[:, 2] - corners[:, 0], corners[:, 3] - corners[:, 1])
    unit = normal * _ratio(np.ones(len(normal)), _norm(normal), 0.0)[:, None]
    found = []
    for u, v in _GAUSS * _CORNERS:
        across = 0.25 * _CORNERS[:, 0] * (1.0 + v * _CORNERS[:, 1])
        along = 0.25 * _CORNERS[:, 1] * (1.0 + u * _CORNERS[:, 0])
        one = np.einsum("k,mki->mi", across, corners)
        two = np.einsum("k,mki->mi", along, corners)
        found.append((np.cross(one, two) * unit).sum(axis=1))
    values = np.stack(found, axis=1)
    return _ratio(values.min(axis=1), values.max(axis=1), -1.0)


def min_angle(corners: Floats) -> Floats:
    """Return the smallest corner angle, degrees."""
    found: Floats = _angles(corners).min(axis=1)
    return found


def max_angle(corners: Floats) -> Floats:
    """Return the largest corner angle, degrees."""
    found: Floats = _angles(corners).max(axis=1)
    return found


def min_length(corners: Floats) -> Floats:
    """Return the shortest edge, mm."""
    found: Floats = _lengths(corners).min(axis=1)
    return found


def step_length(corners: Floats) -> Floats:
    """Return the characteristic length of a shell for its time step, mm (LS-DYNA's default).

    It is the area, doubled for a triangle, over the longest edge.
    """
    factor = 2.0 if corners.shape[1] == 3 else 1.0
    return _ratio(factor * areas(corners), _lengths(corners).max(axis=1), 0.0)


MEASURES: dict[str, Callable[[Floats], Floats]] = {
    "aspect": aspect,
    "warpage": warpage,
    "skew": skew,
    "taper": taper,
    "jacobian": jacobian,
    "min_angle": min_angle,
    "max_angle": max_angle,
    "min_length": min_length,
}


def measured(measure: Callable[[Floats], Floats], points: Floats, faces: Ints) -> Floats:
    """Return a measure (m,) of faces (m, 4), -1 last for triangles, at points (n, 3)."""
    found = np.empty(len(faces))
    is_quad = faces[:, 3] >= 0
    for rows, count in ((np.flatnonzero(is_quad), 4), (np.flatnonzero(~is_quad), 3)):
        for part in chunks(len(rows)):
            some = rows[part]
            found[some] = measure(points[faces[some, :count]])
    return found

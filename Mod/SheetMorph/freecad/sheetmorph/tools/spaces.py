# SPDX-License-Identifier: LGPL-2.1-or-later
"""The volumes and planes of a selector as small meshes for wireframes."""

from __future__ import annotations

from typing import Any

import numpy as np

from freecad.sheetmorph.tools.rims import extent

SIDES = 24
Shape = tuple[np.ndarray, np.ndarray]


def shapes_of(where: Any, points: np.ndarray) -> list[Shape]:
    """Return vertices (k, 3) and triangles (t, 3) of the spaces in a selector.

    Spaces are boxes, planes, slabs, cylinders and spheres. Planes and endless cylinders are as
    large as the part with `points` (n, 3).
    """
    if isinstance(where, list):
        return [shape for one in where for shape in shapes_of(one, points)]
    if not isinstance(where, dict):
        return []
    found = []
    for key, value in where.items():
        if key in _DRAWN:
            found += _DRAWN[key](value, points)
        elif key in ("union", "intersection", "minus", "of"):
            found += shapes_of(value, points)
    return found


def box(corners: Any, _points: np.ndarray) -> list[Shape]:
    """Return a box between two corners."""
    low, high = np.sort(np.array(corners, float), axis=0)
    unit = np.array([[x, y, z] for x in (0, 1) for y in (0, 1) for z in (0, 1)], float)
    quads = [[0, 1, 3, 2], [4, 5, 7, 6], [0, 1, 5, 4], [2, 3, 7, 6], [0, 2, 6, 4], [1, 3, 7, 5]]
    return [(low + unit * (high - low), halves(quads))]


def plane(told: dict, points: np.ndarray, shift: float = 0.0) -> list[Shape]:
    """Return a square in a plane next to the middle of the part."""
    normal, across, up = axes(told["normal"])
    middle, size = 0.5 * (points.min(axis=0) + points.max(axis=0)), 0.6 * extent(points)
    foot = middle - ((middle - np.array(told["point"], float)) @ normal - shift) * normal
    signs = ((-1, -1), (1, -1), (1, 1), (-1, 1))
    corners = np.array([foot + size * (a * across + b * up) for a, b in signs])
    return [(corners, halves([[0, 1, 2, 3]]))]


def slab(told: dict, points: np.ndarray) -> list[Shape]:
    """Return the two faces of a slab."""
    half = 0.5 * float(told["thickness"])
    return [shape for shift in (-half, half) for shape in plane(told, points, shift)]


def cylinder(told: dict, points: np.ndarray) -> list[Shape]:
    """Return a cylinder around an axis."""
    axis, across, up = axes(told["direction"])
    start = np.array(told["point"], float)
    along = (points - start) @ axis
    ends = (0.0, float(told["length"])) if "length" in told else (along.min(), along.max())
    ring = circle(across, up, float(told["radius"]))
    rings = np.concatenate([start + end * axis + ring for end in ends])
    here = np.arange(SIDES)
    there = (here + 1) % SIDES
    quads = np.stack([here, there, there + SIDES, here + SIDES], axis=1)
    return [(rings, halves(quads))]


def sphere(told: dict, _points: np.ndarray) -> list[Shape]:
    """Return a sphere made of rings."""
    centre, radius = np.array(told["center"], float), float(told["radius"])
    heights = np.linspace(-0.5, 0.5, SIDES // 2 + 1) * np.pi
    x, y, z = np.eye(3)
    rings = [np.cos(h) * circle(x, y, radius) + radius * np.sin(h) * z for h in heights]
    here = np.arange(SIDES)
    there = (here + 1) % SIDES
    quads = [
        np.stack([here, there, there + SIDES, here + SIDES], axis=1) + k * SIDES
        for k in range(len(rings) - 1)
    ]
    return [(centre + np.concatenate(rings), halves(np.concatenate(quads)))]


_DRAWN = {
    "box": box,
    "half_space": plane,
    "slab": slab,
    "cylinder": cylinder,
    "sphere": sphere,
}


def axes(direction: Any) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Return a direction and two more at right angles, each of length 1."""
    first = np.array(direction, float)
    first = first / np.linalg.norm(first)
    second = np.cross(first, np.eye(3)[np.abs(first).argmin()])
    second /= np.linalg.norm(second)
    return first, second, np.cross(first, second)


def circle(across: np.ndarray, up: np.ndarray, radius: float) -> np.ndarray:
    """Return SIDES points (SIDES, 3) of a circle around the origin."""
    angles = 2.0 * np.pi * np.arange(SIDES) / SIDES
    return radius * (np.outer(np.cos(angles), across) + np.outer(np.sin(angles), up))


def halves(quads: Any) -> np.ndarray:
    """Return the triangles (2 k, 3) of quads (k, 4)."""
    corners = np.asarray(quads)
    return np.concatenate([corners[:, [0, 1, 2]], corners[:, [0, 2, 3]]])

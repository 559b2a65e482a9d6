# SPDX-License-Identifier: LGPL-2.1-or-later
"""Meshes of simple sheets and solids for tests: flat ones with holes, folded and revolved ones.

Lengths in mm; `step` is the edge length wanted.
"""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from scipy.spatial import Delaunay, cKDTree

Loop = np.ndarray
NEAR = 1e-6


# -- flat sheets with holes


def circle(center: Sequence[float], radius: float, count: int) -> Loop:
    """(count, 2) points on a circle."""
    angles = 2 * np.pi * np.arange(count) / count
    return np.asarray(center) + radius * np.column_stack([np.cos(angles), np.sin(angles)])


def rounded(center: Sequence[float], size: Sequence[float], radius: float, step: float) -> Loop:
    """The outline of a rectangle with rounded corners; a slot if its radius is half the width."""
    half = np.asarray(size) / 2 - radius
    turns = max(3, int(np.ceil(radius * np.pi / 2 / step))) if radius > 0 else 0
    points = []
    for corner, begin in (((1, 1), 0.0), ((-1, 1), 0.5), ((-1, -1), 1.0), ((1, -1), 1.5)):
        angles = np.pi * (begin + 0.5 * np.arange(turns + 1) / max(turns, 1))
        arc = radius * np.column_stack([np.cos(angles), np.sin(angles)])
        points.append(np.asarray(center) + half * corner + arc)
    corners = np.vstack(points)
    corners = corners[np.linalg.norm(corners - np.roll(corners, 1, axis=0), axis=1) > NEAR]
    return divided(corners, step)


def polygon(corners: Sequence[Sequence[float]], step: float) -> Loop:
    """A closed polygon with edges no longer than a step."""
    return divided(np.asarray(corners, float), step)


def divided(corners: np.ndarray, step: float) -> Loop:
    """A closed polyline with edges of about a step."""
    parts = []
    for a, b in zip(corners, np.roll(corners, -1, axis=0)):
        count = max(1, round(float(np.linalg.norm(b - a)) / step))
        parts.append(a + np.arange(count)[:, None] / count * (b - a))
    return np.vstack(parts)


def inside(loop: Loop, points: np.ndarray) -> np.ndarray:
    """(n,) bool: which of (n, 2) points lie in a polygon."""
    start, end = loop, np.roll(loop, -1, axis=0)
    x, y = points[:, :1], points[:, 1:]
    spans = (start[:, 1] > y) != (end[:, 1] > y)
    rise = np.where(end[:, 1] == start[:, 1], 1.0, end[:, 1] - start[:, 1])
    crossing = start[:, 0] + (y - start[:, 1]) / rise * (end - start)[:, 0]
    return np.count_nonzero(spans & (x < crossing), axis=1) % 2 == 1


def flat(outline: Loop, holes: Sequence[Loop], step: float, lines: Sequence[Loop] = ()) -> tuple:
    """(n, 2) points and triangles of a sheet; loops come first, in their order."""
    given = np.vstack([outline, *holes, *lines])
    low, high = outline.min(axis=0), outline.max(axis=0)
    u, v = np.meshgrid(*(np.arange(a, b, s) for a, b, s in zip(low, high, (step, 0.87 * step))))
    u[1::2] += step / 2
    free = np.column_stack([u.ravel(), v.ravel()])
    keep = inside(outline, free) & (cKDTree(given).query(free)[0] > 0.6 * step)
    for hole in holes:
        keep &= ~inside(hole, free)
    points = np.vstack([given, free[keep]])
    triangles = Delaunay(points).simplices
    corners = points[triangles]
    a, b = corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0]
    area = a[:, 0] * b[:, 1] - a[:, 1] * b[:, 0]
    triangles[area < 0] = triangles[area < 0][:, ::-1]
    center = corners.mean(axis=1)
    keep = inside(outline, center) & (np.abs(area) > 1e-6 * step**2)
    for hole in holes:
        keep &= ~inside(hole, center)
    return points, triangles[keep]


def lifted(points: np.ndarray, height: np.ndarray | float = 0.0) -> np.ndarray:
    """(n, 3) points over (n, 2)."""
    return np.column_stack([points, np.broadcast_to(height, len(points))])


def thickened(points: np.ndarray, triangles: np.ndarray, loops: Sequence[int], depth: float):
    """A solid below a flat sheet whose first vertices are closed loops of these lengths."""
    count = len(points)
    walls, first = [], 0
    for number, length in enumerate(loops):
        a = first + np.arange(length)
        b = first + np.roll(np.arange(length), -1)
        if number:
            a, b = b, a  # the sheet is on the other side of a hole
        walls += [np.column_stack([b, a, a + count]), np.column_stack([b, a + count, b + count])]
        first += length
    solid = np.vstack([triangles, triangles[:, ::-1] + count, *walls])
    return np.vstack([lifted(points, depth), lifted(points)]), solid


# -- sheets on a grid


def grid(rows: np.ndarray, wraps: bool = False) -> tuple[np.ndarray, np.ndarray]:
    """Points and triangles of (r, c, 3) rows of points; every row is closed if it wraps."""
    count, width = rows.shape[:2]
    cells = [(i, j) for i in range(count - 1) for j in range(width if wraps else width - 1)]
    triangles = []
    for i, j in cells:
        a, b = i * width + j, i * width + (j + 1) % width
        c, d = b + width, a + width
        triangles += [(a, b, c), (a, c, d)] if (i + j) % 2 else [(a, b, d), (b, c, d)]
    return rows.reshape(-1, 3), np.array(triangles)


def revolved(profile: np.ndarray, count: int) -> tuple[np.ndarray, np.ndarray]:
    """(k, 2) radii and heights turned around z."""
    angles = 2 * np.pi * np.arange(count) / count
    around = np.column_stack([np.cos(angles), np.sin(angles)])
    rows = [np.column_stack([r * around, np.full(count, z)]) for r, z in profile]
    return grid(np.array(rows), wraps=True)


def profile(runs: Sequence[tuple[float, float]], step: float, facets: int = 4):
    """Of runs of (length, turn in degrees): (n, 2) places, (n,) directions in radians and the run
    of each (the later one where two meet); turns have a number of facets."""
    places, angles, runs_of = [np.zeros(2)], [0.0], [0]
    angle, place = 0.0, np.zeros(2)
    for number, (length, turn) in enumerate(runs):
        count = facets if turn else max(2, round(length / step))
        for _ in range(count):
            half = np.radians(turn) / count / 2
            chord = length / count * (np.sin(half) / half if turn else 1.0)
            angle += half
            place = place + chord * np.array([np.cos(angle), np.sin(angle)])
            angle += half
            places.append(place)
            angles.append(angle)
            runs_of.append(number)
    return np.array(places), np.array(angles), runs_of


def folded(runs: Sequence[tuple[float, float]], width: float, step: float):
    """A strip folded along y: runs of (length, turn in degrees); returns points, triangles and
    (n,) the run of every vertex (the later one where two meet)."""
    places, _, runs_of = profile(runs, step)
    across = np.linspace(0.0, width, max(2, round(width / step)) + 1)
    rows = np.array([[[p[0], y, p[1]] for y in across] for p in places])
    points, triangles = grid(rows)
    return points, triangles, np.repeat(runs_of, len(across))


def folded_solid(runs: Sequence[tuple[float, float]], width: float, step: float, depth: float):
    """The same as a closed solid, `depth` thick towards its left; (n, 3) points, triangles."""
    places, angles, _ = profile(runs, step, facets=8)
    left = np.column_stack([-np.sin(angles), np.cos(angles)])
    around = np.vstack([places, (places + depth * left)[::-1]])
    across = np.linspace(0.0, width, max(2, round(width / step)) + 1)
    rows = np.array([[[p[0], y, p[1]] for p in around] for y in across])
    points, triangles = grid(rows, wraps=True)
    size, count = len(around), len(places)
    caps = []
    for first in (0, len(points) - size):
        for k in range(count - 1):
            a, b, c, d = first + np.array([k, k + 1, size - 2 - k, size - 1 - k])
            caps += [(a, b, c), (a, c, d)] if first else [(a, c, b), (a, d, c)]
    return points, np.vstack([triangles, caps])[:, ::-1]

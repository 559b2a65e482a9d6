# SPDX-License-Identifier: LGPL-2.1-or-later
"""Sheets in space: folded profiles, meshes on a map, flanges lofted around an edge."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass, field

import numpy as np

from shapes.planar import FlatMesh
from shapes.surface import Map


@dataclass
class Sheet:
    """One part: (n, 3) points in mm, (m, 3) triangles, hole rims, washer rings, its outer edge."""

    name: str
    points: np.ndarray
    triangles: np.ndarray
    rims: dict[str, np.ndarray] = field(default_factory=dict)
    washers: dict[str, np.ndarray] = field(default_factory=dict)
    edge: np.ndarray = field(default_factory=lambda: np.empty(0, int))

    def feature(self, hole: str) -> list[int]:
        """The vertices that keep a hole round: its rim and the washer ring around it."""
        return sorted(int(v) for v in [*self.rims[hole], *self.washers.get(hole, [])])


def on_map(name: str, flat: FlatMesh, surface: Map) -> Sheet:
    """The flat mesh carried into space, with edges flipped where that helps the triangles there."""
    points = surface(flat.points)
    exact = np.concatenate([*flat.rims.values(), *flat.washers.values(), np.empty(0, int)])
    rounded = np.round(points, 6)
    rounded[exact.astype(int)] = points[exact.astype(int)]
    keep = {tuple(edge) for edge in np.sort(flat.edges, axis=1).tolist()}
    triangles = flipped_for_angles(rounded, flat.triangles, keep)
    return Sheet(name, rounded, triangles, flat.rims, flat.washers, flat.outline)


def loft(sheet: Sheet, rows: int, place: Callable[[np.ndarray, int], np.ndarray]) -> None:
    """Adds `rows` staggered rows of triangles outside the sheet's outer edge, in place.

    `place(t, row)` gives (k, 3) positions of row 1, 2, ... at parameters t in edge steps.
    """
    inner, count = sheet.edge, len(sheet.edge)
    for row in range(1, rows + 1):
        outer = len(sheet.points) + np.arange(count)
        points = np.round(place(np.arange(count) + row / 2, row), 6)
        after, before = np.roll(inner, -1), np.roll(outer, 1)
        strip = [
            np.column_stack([after, inner, outer]),
            np.column_stack([outer, inner, before]),
        ]
        sheet.points = np.vstack([sheet.points, points])
        sheet.triangles = np.vstack([sheet.triangles, *strip])
        inner = outer
    sheet.edge = inner


def placed(sheet: Sheet, name: str, offset: Sequence[float], turned: bool = False) -> Sheet:
    """A copy of a part, turned half round the z axis first if asked, then moved by `offset` mm."""
    turn = np.array([-1.0, -1.0, 1.0]) if turned else np.ones(3)
    points = sheet.points * turn + np.asarray(offset)
    return Sheet(name, points, sheet.triangles, sheet.rims, sheet.washers, sheet.edge)


def at_steps(values: np.ndarray, steps: np.ndarray) -> np.ndarray:
    """Linear interpolation of (k, d) values around a closed loop at parameters in steps."""
    low = np.floor(steps).astype(int)
    share = (steps - low)[:, None]
    count = len(values)
    return (1 - share) * values[low % count] + share * values[(low + 1) % count]


def corner_angles(points: np.ndarray, triangles: np.ndarray) -> np.ndarray:
    """(m, 3) angles in degrees."""
    corners = points[triangles]
    angles = []
    for k in range(3):
        first = corners[:, (k + 1) % 3] - corners[:, k]
        second = corners[:, (k + 2) % 3] - corners[:, k]
        across = np.linalg.norm(np.cross(first, second), axis=1)
        angles.append(np.degrees(np.arctan2(across, np.sum(first * second, axis=1))))
    return np.column_stack(angles)


def flipped_for_angles(
    points: np.ndarray, triangles: np.ndarray, keep: set[tuple[int, int]]
) -> np.ndarray:
    """Triangles after flipping every edge whose opposite angles exceed 180 degrees in space."""
    triangles = triangles.copy()
    for _ in range(20):
        if not _flip_once(points, triangles, keep):
            break
    return triangles


def _flip_once(points: np.ndarray, triangles: np.ndarray, keep: set[tuple[int, int]]) -> bool:
    sides: dict[tuple[int, int], list[tuple[int, int]]] = {}
    for number, triangle in enumerate(triangles):
        for k in range(3):
            a, b = int(triangle[k]), int(triangle[(k + 1) % 3])
            sides.setdefault((min(a, b), max(a, b)), []).append((number, (k + 2) % 3))
    angles, used, have = corner_angles(points, triangles), set(), set(sides)
    for edge, pair in sorted(sides.items()):
        if len(pair) != 2 or edge in keep or used & {pair[0][0], pair[1][0]}:
            continue
        (one, tip), (two, foot) = pair
        if angles[one, tip] + angles[two, foot] < 180.001:
            continue
        c, d = int(triangles[one, tip]), int(triangles[two, foot])
        if (min(c, d), max(c, d)) in have:
            continue
        a, b = (int(v) for v in np.roll(triangles[one], -tip)[1:])
        triangles[one], triangles[two] = (c, a, d), (c, d, b)
        have.add((min(c, d), max(c, d)))
        used |= {one, two}
    return bool(used)

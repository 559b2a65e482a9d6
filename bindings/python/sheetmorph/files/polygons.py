# SPDX-License-Identifier: LGPL-2.1-or-later
"""Polygons of a file split into triangles: for the stiffness alone, the file keeps its polygons."""

from __future__ import annotations

import heapq
from collections.abc import Callable, Sequence

import numpy as np

from ..arrays import Bools, Floats, Ints

SPLIT_IT = "split it into triangles, or into polygons that do not cross themselves"
# Shares of the square of a polygon's longest side: what counts as no area, and how far a triangle
# may be turned over where the digits of the file cannot say it better.
_NO_AREA, _ROUNDING = 1e-12, 1e-6

# The square of the diagonal that cuts a corner off; the corners before it, itself and behind it.
_Entry = tuple[float, int, int, int]


def _refused(number: int, what: str) -> ValueError:
    return ValueError(f"face {number}: {what}; {SPLIT_IT}")


def triangulate(
    points: Floats,
    faces: Sequence[Sequence[int]],
    refusal: Callable[[int, str], ValueError] = _refused,
) -> Ints:
    """Triangles (m, 3) int32 of faces (each three or more vertex indices), in the faces' order.

    points: (n, 3); refusal: makes the error for a face, by its number and what is wrong with it.
    A face of k vertices gives k - 2 triangles. A quad is cut along its shorter diagonal, the one
    from its first vertex if they are equal to rounding (so that a moved or scaled model is cut
    alike), and along the other one if only that lies inside it. A polygon fans out from its first
    vertex if all of it can be seen from there; any other loses one ear after the other. A polygon
    may touch itself, as one does whose holes are connected to its outline by bridges. Raises the
    error for a polygon that crosses itself.
    """
    sizes = np.fromiter((len(face) for face in faces), dtype=np.int64, count=len(faces))
    owners, triangles = [], []
    for size in np.unique(sizes):
        rows = np.flatnonzero(sizes == size)
        block = np.array([faces[row] for row in rows], dtype=np.int64)
        split = _split_quads(points, block) if size == 4 else _fan(block)
        if size > 4:
            for k in np.flatnonzero(~_are_sound(points, block, split)):
                found = _without_ears(points, block[k])
                if found is None:
                    raise refusal(int(rows[k]), f"the polygon of {size} corners crosses itself")
                split[k] = found
        triangles.append(split.reshape(-1, 3))
        owners.append(np.repeat(rows, split.shape[1]))
    if not triangles:
        return np.empty((0, 3), dtype=np.int32)
    order = np.argsort(np.concatenate(owners), kind="stable")
    return np.ascontiguousarray(np.concatenate(triangles)[order], dtype=np.int32)


def _fan(block: Ints) -> Ints:
    count = block.shape[1] - 2
    corners = [block[:, [0, k + 1, k + 2]] for k in range(count)]
    return np.stack(corners, axis=1)


def _normals(points: Floats, triangles: Ints) -> Floats:
    """Twice the areas of triangles (..., 3) along their normals: (..., 3)."""
    a, b, c = (points[triangles[..., k]] for k in range(3))
    return np.asarray(np.cross(b - a, c - a))


def _are_sound(points: Floats, polygons: Ints, triangles: Ints) -> Bools:
    """(f,) whether all triangles (f, k, 3) of each polygon (f, k + 2) lie on its side."""
    normals = _normals(points, triangles)
    whole = normals.sum(axis=1)
    corners = points[polygons]
    reach = np.square(corners - np.roll(corners, 1, axis=1)).sum(axis=2).max(axis=1)
    area = np.linalg.norm(whole, axis=1)
    least = np.einsum("fki,fi->fk", normals, whole).min(axis=1)
    return np.asarray((area <= _NO_AREA * reach) | (least >= -_NO_AREA * reach * area))


def _split_quads(points: Floats, quads: Ints) -> Ints:
    first = np.linalg.norm(points[quads[:, 0]] - points[quads[:, 2]], axis=1)
    second = np.linalg.norm(points[quads[:, 1]] - points[quads[:, 3]], axis=1)
    ways = [
        quads[:, columns].reshape(-1, 2, 3) for columns in ([0, 1, 2, 0, 2, 3], [0, 1, 3, 1, 2, 3])
    ]
    is_sound = [_are_sound(points, quads, way) for way in ways]
    turned = second < first * (1.0 - 1e-6)
    turned = np.where(is_sound[0] == is_sound[1], turned, is_sound[1])
    return np.asarray(np.where(turned[:, None, None], ways[1], ways[0]))


def _without_ears(points: Floats, polygon: Ints) -> Ints | None:
    """Triangles (k - 2, 3) of a polygon (k,) that touches itself at most; None if it crosses.

    Cuts off ears, those with the shortest diagonal first (Meisters 1975). Corners with a vertex on
    the border of their triangle wait until there is no better one: cut earlier, they would leave a
    polygon without area behind.
    """
    flat, reach = _in_its_plane(points, polygon)
    ears = _Ears(flat, _NO_AREA * reach)
    found = []
    while len(ears.left) > 3:
        ear = ears.next()
        if ear is None:
            return None
        found.append(ear)
    found.append(ears.last())
    corners = np.array(found)
    if _doubled_areas(flat, corners).min() < -_ROUNDING * reach:
        return None
    return np.asarray(polygon[corners])


def _in_its_plane(points: Floats, polygon: Ints) -> tuple[Floats, float]:
    """(k, 2) corners that go round counterclockwise, and the square of the longest side."""
    corners = points[polygon] - points[polygon[0]]
    normal = np.cross(corners, np.roll(corners, -1, axis=0)).sum(axis=0)
    normal /= np.linalg.norm(normal)
    across = np.eye(3)[np.abs(normal).argmin()]
    x = np.cross(across, normal)
    x /= np.linalg.norm(x)
    # Each coordinate alone: equal corners must stay equal to the last bit.
    flat = np.stack([(corners * axis).sum(axis=1) for axis in (x, np.cross(normal, x))], axis=1)
    sides = np.square(corners - np.roll(corners, 1, axis=0)).sum(axis=1)
    return flat, float(sides.max())


def _doubled_areas(flat: Floats, corners: Ints) -> Floats:
    a, b, c = (flat[corners[..., k]] for k in range(3))
    u, v = b - a, c - a
    return np.asarray(u[..., 0] * v[..., 1] - u[..., 1] * v[..., 0])


class _Ears:
    """What is left of a polygon (k, 2), and the corners that may be cut off it."""

    def __init__(self, flat: Floats, no_area: float):
        self.left = set(range(len(flat)))
        self._flat, self._no_area = flat, no_area
        self._before = {k: (k - 1) % len(flat) for k in self.left}
        self._after = {k: (k + 1) % len(flat) for k in self.left}
        self._open = [self._entry(k) for k in self.left]
        heapq.heapify(self._open)
        # By the corner in their way; and those that have corners on their border only.
        self._waiting: dict[int, list[_Entry]] = {}
        self._touched: list[_Entry] = []

    def next(self) -> tuple[int, int, int] | None:
        """The next ear, cut off; None if there is none."""
        while self._open:
            entry = heapq.heappop(self._open)
            if self._is_there(entry) and self._is_ear(entry):
                return self._cut(entry[1:])
        for entry in sorted(set(self._touched)):
            if self._is_there(entry):
                return self._cut(entry[1:])
        return None

    def last(self) -> tuple[int, int, int]:
        """The triangle that is left when all ears are cut off."""
        k = min(self.left)
        return self._before[k], k, self._after[k]

    def _entry(self, k: int) -> _Entry:
        a, b = self._before[k], self._after[k]
        return float(np.square(self._flat[b] - self._flat[a]).sum()), a, k, b

    def _is_there(self, entry: _Entry) -> bool:
        _, a, k, b = entry
        return k in self.left and self._before[k] == a and self._after[k] == b

    def _cut(self, ear: tuple[int, int, int]) -> tuple[int, int, int]:
        a, k, b = ear
        self.left.remove(k)
        self._after[a], self._before[b] = b, a
        for entry in [self._entry(a), self._entry(b), *self._waiting.pop(k, [])]:
            heapq.heappush(self._open, entry)
        return ear

    def _is_ear(self, entry: _Entry) -> bool:
        """Whether nothing lies in a triangle; else it is noted what it waits for."""
        corners = np.array(entry[1:])
        area = float(_doubled_areas(self._flat, corners))
        if area < -self._no_area:
            return False  # it faces the other side, until one of its neighbours is cut off
        rows = np.fromiter(self.left, dtype=np.int64, count=len(self.left))
        others, places = self._flat[rows], self._flat[corners]
        sides = np.roll(places, -1, axis=0) - places
        to = others[:, None] - places[None]
        depth = (sides[:, 0] * to[..., 1] - sides[:, 1] * to[..., 0]).min(axis=1)
        # Corners in the place of one of its own belong to the two sides of a bridge.
        depth[(to == 0.0).all(axis=2).any(axis=1)] = -np.inf
        deepest = int(depth.argmax())
        if area <= self._no_area or depth[deepest] >= -self._no_area:
            if depth[deepest] <= self._no_area:
                self._touched.append(entry)
            if depth[deepest] >= -self._no_area:
                self._waiting.setdefault(int(rows[deepest]), []).append(entry)
            return False
        return True

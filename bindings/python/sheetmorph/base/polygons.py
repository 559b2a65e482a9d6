# SPDX-License-Identifier: LGPL-2.1-or-later
"""Triangulation of polygons, needed for the solver only; the file keeps its polygons."""

from __future__ import annotations

import heapq
from collections.abc import Callable, Sequence

import numpy as np

from .arrays import Bools, Floats, Ints
from .errors import InputError

SPLIT_IT = "split it into triangles, or into polygons that do not cross themselves"
# Shares of the squared longest edge of a polygon: below the first an area counts as zero. Triangles
# may be inverted up to the second, because of the rounding in the file.
_NO_AREA, _ROUNDING = 1e-12, 1e-6

# Squared length of the diagonal that cuts an ear, and its corners: previous, ear, next.
_Entry = tuple[float, int, int, int]


def _refused(number: int, what: str) -> ValueError:
    return InputError(what, SPLIT_IT, f"face {number}")


def triangulate(
    points: Floats,
    faces: Sequence[Sequence[int]],
    refusal: Callable[[int, str], ValueError] = _refused,
) -> Ints:
    """Return triangles (m, 3) int32 of faces with three or more vertices, in the order of the
    faces.

    points is (n, 3). refusal makes the error from a face number and a problem. A face of k vertices
    gives k - 2 triangles.

    A quad is cut along its shorter diagonal, or along the other one if only that lies inside. If
    both are equal up to rounding, the diagonal from the first vertex is used, so that a moved or
    scaled model is cut in the same way.

    A larger polygon becomes a fan around its first vertex if the whole polygon is visible from
    there. Otherwise its ears are cut off. A polygon may touch itself, as with bridges between holes
    and outline. A polygon that crosses itself raises the error.
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
    """Return normals (..., 3) of triangles (..., 3), twice as long as the area."""
    a, b, c = (points[triangles[..., k]] for k in range(3))
    return np.asarray(np.cross(b - a, c - a))


def _are_sound(points: Floats, polygons: Ints, triangles: Ints) -> Bools:
    """Return whether all triangles (f, k, 3) have the orientation of their polygon (f, k + 2)."""
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
    """Return triangles (k - 2, 3) of a polygon (k,), or None if it crosses itself.

    Ears with the shortest diagonal are cut first (Meisters 1975). Corners with a vertex on the
    border of their triangle are cut last, because the remaining polygon could lose its area.
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
    """Return 2D corners (k, 2) in counterclockwise order, and the squared longest edge."""
    corners = points[polygon] - points[polygon[0]]
    normal = np.cross(corners, np.roll(corners, -1, axis=0)).sum(axis=0)
    normal /= np.linalg.norm(normal)
    across = np.eye(3)[np.abs(normal).argmin()]
    x = np.cross(across, normal)
    x /= np.linalg.norm(x)
    # Each coordinate is computed separately, so that equal corners stay bitwise equal.
    flat = np.stack([(corners * axis).sum(axis=1) for axis in (x, np.cross(normal, x))], axis=1)
    sides = np.square(corners - np.roll(corners, 1, axis=0)).sum(axis=1)
    return flat, float(sides.max())


def _doubled_areas(flat: Floats, corners: Ints) -> Floats:
    a, b, c = (flat[corners[..., k]] for k in range(3))
    u, v = b - a, c - a
    return np.asarray(u[..., 0] * v[..., 1] - u[..., 1] * v[..., 0])


class _Ears:
    """The remaining polygon (k, 2), and its candidate ears."""

    def __init__(self, flat: Floats, no_area: float):
        self.left = set(range(len(flat)))
        self._flat, self._no_area = flat, no_area
        self._before = {k: (k - 1) % len(flat) for k in self.left}
        self._after = {k: (k + 1) % len(flat) for k in self.left}
        self._open = [self._entry(k) for k in self.left]
        heapq.heapify(self._open)
        # Ears by the corner that blocks them, and ears with corners only on their border.
        self._waiting: dict[int, list[_Entry]] = {}
        self._touched: list[_Entry] = []

    def next(self) -> tuple[int, int, int] | None:
        """Cut off and return the next ear, or return None."""
        while self._open:
            entry = heapq.heappop(self._open)
            if self._is_there(entry) and self._is_ear(entry):
                return self._cut(entry[1:])
        for entry in sorted(set(self._touched)):
            if self._is_there(entry):
                return self._cut(entry[1:])
        return None

    def last(self) -> tuple[int, int, int]:
        """Return the triangle that remains after all ears are cut off."""
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
        """Return whether a triangle contains no other corner; if it does, store it there."""
        corners = np.array(entry[1:])
        area = float(_doubled_areas(self._flat, corners))
        if area < -self._no_area:
            return False  # it is inverted until a neighbour is cut off
        rows = np.fromiter(self.left, dtype=np.int64, count=len(self.left))
        others, places = self._flat[rows], self._flat[corners]
        sides = np.roll(places, -1, axis=0) - places
        to = others[:, None] - places[None]
        depth = (sides[:, 0] * to[..., 1] - sides[:, 1] * to[..., 0]).min(axis=1)
        # Corners that coincide with its own are the two sides of a bridge.
        depth[(to == 0.0).all(axis=2).any(axis=1)] = -np.inf
        deepest = int(depth.argmax())
        if area <= self._no_area or depth[deepest] >= -self._no_area:
            if depth[deepest] <= self._no_area:
                self._touched.append(entry)
            if depth[deepest] >= -self._no_area:
                self._waiting.setdefault(int(rows[deepest]), []).append(entry)
            return False
        return True

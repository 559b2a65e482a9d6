# SPDX-License-Identifier: LGPL-2.1-or-later
"""Motion of a sheet at its nodes and triangles, and of everything attached there."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from .arrays import Floats, Ints

# Number of nearest attachment nodes that carry each node of a group.
_NEAREST = 12


class Motion:
    """A sheet before and after: positions rest and moved (n, 3), and triangles (m, 3).

    rows (k,) are the nodes for which rotations are computed.
    """

    def __init__(self, rest: Floats, moved: Floats, triangles: Ints, rows: Ints):
        self.rest, self.moved, self.triangles = rest, moved, triangles
        near = (rest != moved).any(axis=1)
        near[triangles[near[triangles].any(axis=1)]] = True
        self._is_near = near
        self._place = np.full(len(rest), -1, dtype=np.int64)
        self._place[rows] = np.arange(len(rows))
        self._turns = self._all_turns(len(rows))

    def turns(self, rows: Ints) -> Floats:
        """Return the rotation (k, 3, 3) of the sheet around some of its nodes.

        It is the best fit to the edges and normals of the adjacent triangles.
        """
        found: Floats = self._turns[self._place[rows]]
        return found

    def stays(self, rows: Ints) -> bool:
        """Return whether no triangle at these nodes moves."""
        return not self._is_near[rows].any()

    def _all_turns(self, count: int) -> Floats:
        place = self._place
        corners = self.triangles[(place[self.triangles] >= 0).any(axis=1)]
        before, after = _normals(self.rest, corners), _normals(self.moved, corners)
        sums = np.zeros((count, 3, 3))
        for corner in range(3):
            at = place[corners[:, corner]]
            inside = at >= 0
            node = corners[inside, corner]
            for other in (1, 2):
                to = corners[inside, (corner + other) % 3]
                a, b = self.rest[to] - self.rest[node], self.moved[to] - self.moved[node]
                np.add.at(sums, at[inside], b[:, :, None] * a[:, None, :])
            np.add.at(sums, at[inside], after[inside][:, :, None] * before[inside][:, None, :])
        return _rotations(sums)


def _normals(points: Floats, triangles: Ints) -> Floats:
    """Return normals (m, 3) with the square root of twice the area as their length."""
    one = points[triangles[:, 1]] - points[triangles[:, 0]]
    two = points[triangles[:, 2]] - points[triangles[:, 0]]
    normal = np.cross(one, two)
    size = np.linalg.norm(normal, axis=1)
    scale = np.divide(1.0, np.sqrt(size), out=np.zeros_like(size), where=size > 0.0)
    found: Floats = normal * scale[:, None]
    return found


def _rotations(sums: Floats) -> Floats:
    """Return the rotations (k, 3, 3) nearest to sums of b a^T."""
    left, _, right = np.linalg.svd(sums)
    sign = np.where(np.linalg.det(left @ right) < 0.0, -1.0, 1.0)
    left = left.copy()
    left[:, :, 2] *= sign[:, None]
    return left @ right


def rigid_motion(rest: Floats, moved: Floats) -> tuple[Floats, Floats] | None:
    """Return rotation (3, 3) and shift (3,) that map points (k, 3) best to others.

    Return None for collinear points, whose rotation is not unique.
    """
    if len(rest) < 3:
        return None
    middle, other = rest.mean(axis=0), moved.mean(axis=0)
    spread = np.linalg.svd(rest - middle, compute_uv=False)
    if not spread[1] > 1e-6 * spread[0]:
        return None
    turn = _rotations(((moved - other).T @ (rest - middle))[None])[0]
    return turn, other - turn @ middle


def rigid_along(motion: Motion, held: Ints) -> tuple[Floats, Floats]:
    """Return rotation (3, 3) and shift (3,) of a body attached to sheet nodes (j,), j >= 1.

    If the node positions do not define the rotation, the rotation of the sheet completes it.
    """
    rest, moved = motion.rest[held], motion.moved[held]
    found = rigid_motion(rest, moved)
    if found is not None:
        return found
    turn = _rotations(motion.turns(held).sum(axis=0)[None])[0]
    middle, other = rest.mean(axis=0), moved.mean(axis=0)
    along = np.linalg.svd(rest - middle)[2][0]
    wanted = (moved - other).T @ ((rest - middle) @ along)
    if np.linalg.norm(wanted) > 0.0:
        turn = _shortest_turn(turn @ along, wanted / np.linalg.norm(wanted)) @ turn
    return turn, other - turn @ middle


def _shortest_turn(start: Floats, end: Floats) -> Floats:
    """Return the smallest rotation (3, 3) between unit vectors; any if they are opposite."""
    half: Floats = start + end
    if np.linalg.norm(half) < 1e-9:
        across = np.zeros(3)
        across[np.abs(start).argmin()] = 1.0
        half = across - float(across @ start) * start
    half = half / np.linalg.norm(half)
    # The product of two reflections is a rotation by twice the angle from start to half.
    mirrors: list[Floats] = [np.eye(3) - 2.0 * np.outer(a, a) for a in (start, half)]
    found: Floats = mirrors[1] @ mirrors[0]
    return found


def blended(motion: Motion, held: Ints, points: Floats) -> Floats:
    """Return the positions (k, 3) of points that follow the sheet around nodes (j,)."""
    turns = motion.turns(held)
    anchors, targets = motion.rest[held], motion.moved[held]
    found = np.empty_like(points)
    for k, point in enumerate(points):
        away = np.linalg.norm(anchors - point, axis=1)
        near = np.argsort(away, kind="stable")[:_NEAREST]
        if away[near[0]] == 0.0:
            found[k] = targets[near[0]]
            continue
        weight = 1.0 / away[near] ** 2
        carried = targets[near] + np.einsum("kij,kj->ki", turns[near], point - anchors[near])
        found[k] = weight @ carried / weight.sum()
    return found


def on_triangle(motion: Motion, triangle: int, barycentric: Floats, point: Floats) -> Floats:
    """Return the position (3,) of a point that follows a triangle from its foot on it."""
    corners = motion.triangles[triangle]
    foot, target = barycentric @ motion.rest[corners], barycentric @ motion.moved[corners]
    turn = _rotations(motion.turns(corners).sum(axis=0)[None])[0]
    found: Floats = target + turn @ (point - foot)
    return found


def turn_at(places: Sequence[tuple[Motion, int]]) -> Floats:
    """Return the mean rotation (3, 3) of sheets at some of their triangles."""
    turns = [motion.turns(motion.triangles[triangle]).sum(axis=0) for motion, triangle in places]
    found: Floats = _rotations(np.sum(turns, axis=0)[None])[0]
    return found

# SPDX-License-Identifier: LGPL-2.1-or-later
"""Whole turns of handles that the deformed sheet does not follow, measured on its triangles."""

from __future__ import annotations

import math
from collections.abc import Iterator
from dataclasses import dataclass

import numpy as np

from ..base.arrays import Bools, Floats, Ints
from ..base.errors import Caution, Subject
from ..base.words import counted
from ..recipe.pose import pose_of
from ..solving.answer import Answer

# Only turns beyond half a turn can be lost, because a smaller rotation is unique.
_SHORTEST = math.pi
# A triangle whose height is below this share of its longest edge defines no rotation.
_FLAT = 1e-6


@dataclass(frozen=True)
class _Turn:
    """A region with its rotation: unit axis and angle, rad."""

    vertices: Ints
    axis: Floats
    angle: float


def lost_turns(result: Answer) -> Iterator[Caution]:
    """Warn about each handle whose turn the sheet does not follow completely."""
    session = result.session
    pose = pose_of(result.pose)
    turns: dict[str, dict[str, _Turn]] = {}
    for entry in session.model.of_kind("handle"):
        if entry.turning == "free":
            continue
        rotation = pose[entry.name].rotation if entry.name in pose else None
        axis, angle = np.array([0.0, 0.0, 1.0]), 0.0
        if rotation is not None and np.any(rotation.axis):
            axis = np.asarray(rotation.axis, float) / np.linalg.norm(rotation.axis)
            angle = rotation.radians
        turn = _Turn(session.region_vertices(entry), axis, angle)
        turns.setdefault(entry.part, {})[entry.name] = turn
    for part, of_part in turns.items():
        if max(abs(turn.angle) for turn in of_part.values()) > _SHORTEST:
            yield from _lost_on(result, part, of_part)


def _lost_on(result: Answer, part: str, turns: dict[str, _Turn]) -> Iterator[Caution]:
    session = result.session
    mesh = session.meshes[part]
    fixed = [e for e in session.model.of_kind("fixed") if e.part == part]
    still = [_Turn(session.region_vertices(entry), np.zeros(3), 0.0) for entry in fixed]
    first = next(iter(turns.values()))
    followed = FollowedTurns(mesh.points, mesh.triangles, result.positions[part])
    for name, turn in turns.items():
        if abs(turn.angle) <= _SHORTEST or (not still and turn is first):
            continue
        start = [
            (one.vertices, one.angle * float(one.axis @ turn.axis)) for one in still or [first]
        ]
        missed = followed.least_miss(start, turn.vertices, turn.axis, turn.angle)
        if missed is not None and missed > _SHORTEST:
            lost = max(1, round(missed / math.tau))
            yield Caution(
                f'{counted(lost, "whole turn", "whole turns")} of the handle "{name}" '
                f"({math.degrees(turn.angle):.0f} degrees) "
                f'{"is" if lost == 1 else "are"} lost: the triangles of "{part}" '
                "between it and the constraints of the part are too coarse to follow",
                Subject("handle", name),
                code="lost turn",
                todo="remesh the part more finely, or turn the handle less",
            )


class FollowedTurns:
    """Rotation angles of triangles about an axis, tracked from neighbour to neighbour.

    points and positions (n, 3) are the rest and deformed vertices, mm; triangles is (m, 3).
    """

    def __init__(self, points: Floats, triangles: Ints, positions: Floats):
        self._triangles = triangles
        rest, sound_rest = _frames(points[triangles])
        moved, sound_moved = _frames(positions[triangles])
        self._quaternions = quaternions(np.einsum("tij,tkj->tik", moved, rest))
        self._is_sound = sound_rest & sound_moved
        self._pairs = _neighbours(triangles)

    def least_miss(
        self, start: list[tuple[Ints, float]], end: Ints, axis: Floats, angle: float
    ) -> float | None:
        """Return the least difference from angle to the turn of vertices end, rad.

        The turn is about the unit axis. start lists regions as (vertices, own turn about the axis).
        The result is None if no chain of triangles connects both.
        """
        turns = 2.0 * np.arctan2(self._quaternions[:, 1:] @ axis, self._quaternions[:, 0])
        found = np.full(len(turns), np.nan)
        for vertices, own in start:
            touched = self._touching(vertices)
            found[touched] = own + _wrapped(turns[touched] - own)
        while True:
            is_found = ~np.isnan(found)
            steps = is_found[self._pairs[:, 0]] & ~is_found[self._pairs[:, 1]]
            steps &= self._is_sound[self._pairs[:, 1]]
            if not steps.any():
                break
            before, after = self._pairs[steps].T
            after, first = np.unique(after, return_index=True)
            reached = found[before[first]]
            found[after] = reached + _wrapped(turns[after] - reached)
        missed = np.abs(found[self._touching(end)] - angle)
        missed = missed[~np.isnan(missed)]
        return float(missed.min()) if len(missed) else None

    def _touching(self, vertices: Ints) -> Ints:
        is_touched = np.isin(self._triangles, vertices).any(axis=1) & self._is_sound
        touched: Ints = np.flatnonzero(is_touched)
        return touched


def quaternions(rotations: Floats) -> Floats:
    """Return unit quaternions (t, 4), real part first, of rotation matrices (t, 3, 3)."""
    r = rotations
    trace = np.trace(r, axis1=1, axis2=2)
    x, y, z = (r[:, (k + 2) % 3, (k + 1) % 3] - r[:, (k + 1) % 3, (k + 2) % 3] for k in range(3))
    diagonal = [1.0 + 2.0 * r[:, k, k] - trace for k in range(3)]
    xy, xz, yz = (r[:, j, k] + r[:, k, j] for j, k in ((0, 1), (0, 2), (1, 2)))
    # Row k holds four times the quaternion, multiplied by its component k.
    rows = np.stack(
        [
            np.stack([1.0 + trace, x, y, z], axis=1),
            np.stack([x, diagonal[0], xy, xz], axis=1),
            np.stack([y, xy, diagonal[1], yz], axis=1),
            np.stack([z, xz, yz, diagonal[2]], axis=1),
        ],
        axis=1,
    )
    largest = np.argmax(np.einsum("tii->ti", rows), axis=1)
    chosen = rows[np.arange(len(rows)), largest]
    found: Floats = chosen / np.linalg.norm(chosen, axis=1)[:, None]
    return found


def _wrapped(angles: Floats) -> Floats:
    """Map angles to the range from minus half a turn to half a turn."""
    wrapped: Floats = angles - math.tau * np.round(angles / math.tau)
    return wrapped


def _frames(corners: Floats) -> tuple[Floats, Bools]:
    """Return orthonormal frames (t, 3, 3) as columns, and whether each triangle has one."""
    first, second = corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0]
    normal = np.cross(first, second)
    longest = np.maximum((first**2).sum(axis=1), (second**2).sum(axis=1))
    is_sound = np.linalg.norm(normal, axis=1) > _FLAT * longest
    x = first / np.maximum(np.linalg.norm(first, axis=1), 1e-300)[:, None]
    z = normal / np.maximum(np.linalg.norm(normal, axis=1), 1e-300)[:, None]
    return np.stack([x, np.cross(z, x), z], axis=2), is_sound


def _neighbours(triangles: Ints) -> Ints:
    """Return pairs (p, 2) of triangles with a common edge, in both orders."""
    edges = np.sort(triangles[:, [[0, 1], [1, 2], [2, 0]]].reshape(-1, 2), axis=1)
    owner = np.repeat(np.arange(len(triangles)), 3)
    order = np.lexsort(edges.T)
    edges, owner = edges[order], owner[order]
    same = (edges[1:] == edges[:-1]).all(axis=1)
    pairs = np.stack([owner[:-1][same], owner[1:][same]], axis=1)
    both: Ints = np.concatenate([pairs, pairs[:, ::-1]])
    return both

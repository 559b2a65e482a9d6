# SPDX-License-Identifier: LGPL-2.1-or-later
"""Rigid motions that map several points of one state of a part to those of another."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass

import numpy as np

from ..base.arrays import Bools, Floats

# Limits of the work: point pairs that define a motion, motions to try, and points for rotations.
_ANCHORS, _TRIED, _MOST_TURNED = 3, 40, 250


@dataclass(frozen=True, eq=False)
class Motion:
    """The motion x -> turn x + shift, with turn (3, 3) and shift (3,), mm."""

    turn: Floats
    shift: Floats

    def applied(self, places: Floats) -> Floats:
        """Return points (n, 3) after the motion."""
        found: Floats = places @ self.turn.T + self.shift
        return found

    def length(self, places: Floats) -> float:
        """Return the mean displacement of points (n, 3), mm."""
        return float(np.linalg.norm(self.applied(places) - places, axis=1).mean())


def proposed_motions(
    places: tuple[Floats, Floats], axes: tuple[Floats, Floats], allowed: Bools, slack: float
) -> list[Motion]:
    """Return candidate motions between two sets of points with unit axes (n, 3).

    allowed (n, m) states which points can correspond. Motions within slack, mm, are equal.
    """
    if min(len(places[0]), len(places[1])) < 2:
        return []
    slack = max(slack, 1e-9)
    shifts = _shifts(places, allowed, slack)
    turned: list[Motion] = []
    if max(len(places[0]), len(places[1])) <= _MOST_TURNED:
        turned = list(_turned(places, axes, allowed, slack))
        turned.sort(key=lambda motion: motion.length(places[0]))
    return [*shifts, *_distinct(turned, places[0], slack)[:_TRIED]]


def _shifts(places: tuple[Floats, Floats], allowed: Bools, slack: float) -> list[Motion]:
    """Return the translations that most pairs of points share."""
    rows, columns = np.nonzero(allowed)
    shifts = places[1][columns] - places[0][rows]
    cells, first, counts = np.unique(
        np.round(shifts / (4.0 * slack)), axis=0, return_index=True, return_counts=True
    )
    order = np.lexsort((np.linalg.norm(cells, axis=1), -counts))[:_TRIED]
    return [Motion(np.eye(3), shifts[k]) for k in first[order]]


def _turned(
    places: tuple[Floats, Floats], axes: tuple[Floats, Floats], allowed: Bools, slack: float
) -> Iterator[Motion]:
    """Yield motions that map two distant points and an axis to a pair with the same distance."""
    between = [np.linalg.norm(p[:, None, :] - p[None, :, :], axis=2) for p in places]
    for a, b in _anchors(between[0]):
        fits = np.abs(between[1] - between[0][a, b]) <= 2.0 * slack
        fits &= allowed[a][:, None] & allowed[b][None, :]
        for c, d in np.argwhere(fits)[: 8 * _TRIED]:
            for sign in (1.0, -1.0):
                start = _frame(places[0][b] - places[0][a], axes[0][a])
                end = _frame(places[1][d] - places[1][c], sign * axes[1][c])
                if start is None or end is None:
                    continue
                turn = end @ start.T
                yield Motion(turn, places[1][c] - turn @ places[0][a])


def _anchors(between: Floats) -> list[tuple[int, int]]:
    """Return disjoint pairs of points, the most distant first."""
    order = np.argsort(-between, axis=None, kind="stable")
    found: list[tuple[int, int]] = []
    used: set[int] = set()
    for a, b in zip(*np.unravel_index(order, between.shape)):
        if a < b and not {int(a), int(b)} & used:
            found.append((int(a), int(b)))
            used |= {int(a), int(b)}
        if len(found) == _ANCHORS:
            break
    return found


def _frame(along: Floats, axis: Floats) -> Floats | None:
    """Return a frame as columns: direction, perpendicular, orthogonalised axis; or None."""
    length = float(np.linalg.norm(along))
    if not length > 0.0:
        return None
    first = along / length
    third = axis - (axis @ first) * first
    size = float(np.linalg.norm(third))
    if size < 0.1:
        return None
    third = third / size
    return np.column_stack([first, np.cross(third, first), third])


def _distinct(motions: list[Motion], places: Floats, slack: float) -> list[Motion]:
    """Return motions that differ at the first point or at the point farthest from it."""
    far = places[[0, int(np.linalg.norm(places - places[0], axis=1).argmax())]]
    seen: set[bytes] = set()
    found = []
    for motion in motions:
        key = np.round(motion.applied(far) / (4.0 * slack)).astype(np.int64).tobytes()
        if key not in seen:
            seen.add(key)
            found.append(motion)
    return found

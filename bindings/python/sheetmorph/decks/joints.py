# SPDX-License-Identifier: LGPL-2.1-or-later
"""Checks of joints: connected nodes must keep their distance."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass

import numpy as np

from ..base.arrays import Bools, Floats, Ints
from ..measuring.strain import middle_edge
from .deck import Deck
from .model import Elements, Place
from .shells import Sheet
from .welds import WeldGaps, weld_gaps

_JOINTS = ("line", "rigid", "constraint", "weld")
# A joint is broken if it opens by more than the largest of these: half its gap, half the sheet
# thickness, and this share of the median edge length. A rigid body is broken if the rounding in its
# file does not explain the change.
_HALF, _OF_EDGE = 0.5, 0.1
# Largest change of a distance by rounding both ends, in units of the last digit.
_OF_ROUNDING = 3.0**0.5


@dataclass(frozen=True)
class Joint:
    """A joint whose nodes changed their distance.

    place is its card, change the largest change and limit the admissible one, both in mm. is_rigid
    marks a rigid body, which must not stretch at all.
    """

    place: Place
    change: float
    limit: float
    is_rigid: bool = False

    @property
    def is_broken(self) -> bool:
        """Whether the joint opened too far."""
        return self.change > self.limit


@dataclass(frozen=True)
class Joints:
    """The joints of a deck.

    count is the number of joints with a moved node and of welds near a sheet. worst is the worst of
    them, or None. welds has the distances from the sheets.
    """

    count: int
    worst: Joint | None
    broken: list[Joint]
    welds: list[WeldGaps]


def joints_of(deck: Deck, sheet: Sheet, positions: Floats, limit: float | None = None) -> Joints:
    """Return the state of the joints with the nodes at positions (n, 3).

    limit, mm, replaces the one from gap, thickness and edges.
    """
    moved = (positions != deck.points).any(axis=1)
    least = _least(deck, sheet)

    def joint(place: Place, change: float, allowed: float, is_rigid: bool = False) -> Joint:
        return Joint(place, change, allowed if limit is None else limit, is_rigid)

    found: dict[tuple[int, int, str, int], Joint] = {}

    def add(one: Joint) -> None:
        # A weld between two nodes is both an element and a gap, but only one joint.
        key = (one.place.file, one.place.line, one.place.card, one.place.number)
        old = found.get(key)
        if old is None or one.change * old.limit > old.change * one.limit:
            found[key] = one

    for block in deck.elements:
        if block.kind == "rigid":
            for row, change, allowed in _stretches(deck, block, positions, moved):
                add(joint(_place(block, row), change, allowed, True))
        elif block.kind in _JOINTS:
            for row, change, gap in zip(*_changes(deck, block, positions, moved)):
                allowed = max(_HALF * float(gap), least)
                add(joint(_place(block, int(row)), float(change), allowed))
    welds = weld_gaps(deck, sheet, positions) if moved.any() else []
    for weld in welds:
        add(joint(weld.place, weld.change, max(_HALF * sum(weld.before), least)))
    joints = list(found.values())
    worst = max(joints, key=lambda one: one.change / max(one.limit, 1e-30), default=None)
    return Joints(len(joints), worst, [one for one in joints if one.is_broken], welds)


def _stretches(
    deck: Deck, block: Elements, positions: Floats, moved: Bools
) -> Iterator[tuple[int, float, float]]:
    """Yield rows of rigid bodies with a moved node, with change and rounding error, mm.

    The change is the largest of a distance between two nodes.
    """
    index = np.where(block.nodes == 0, -1, deck.find(block.nodes))
    there = index >= 0
    is_moved = (moved[np.maximum(index, 0)] & there).any(axis=1) & (there.sum(axis=1) > 1)
    for row in np.flatnonzero(is_moved).tolist():
        nodes = np.unique(index[row][there[row]])
        before, after = deck.points[nodes], positions[nodes]
        change = 0.0
        for anchor in _anchors(before):
            was = np.linalg.norm(before - before[anchor], axis=1)
            now = np.linalg.norm(after - after[anchor], axis=1)
            change = max(change, float(np.abs(now - was).max()))
        yield row, change, _OF_ROUNDING * max(deck.digit(nodes, at) for at in (before, after))


def _anchors(points: Floats) -> list[int]:
    """Return up to four of points (n, 3) that are far apart.

    A body that keeps its distances from them keeps its shape.
    """
    anchors = [0]
    away = points - points[0]
    for _ in range(3):
        size = np.linalg.norm(away, axis=1)
        far = int(size.argmax())
        if far in anchors or not size[far] > 0.0:
            break
        anchors.append(far)
        # The remainder is perpendicular to the line, then to the plane, through the anchors.
        axis = away[far] / size[far]
        away = away - np.outer(away @ axis, axis)
    return anchors


def _place(block: Elements, row: int) -> Place:
    return Place(block.name, int(block.ids[row]), block.file, int(block.lines[row]))


def _least(deck: Deck, sheet: Sheet) -> float:
    edge = middle_edge(deck.points[sheet.nodes], sheet.triangles)
    thickness = [value for value in deck.raw.thickness.values() if value > 0.0]
    return max(_OF_EDGE * edge, _HALF * min(thickness, default=0.0), 1e-9)


def _changes(
    deck: Deck, block: Elements, positions: Floats, moved: Bools
) -> tuple[Ints, Floats, Floats]:
    """Return rows of elements with a moved node, the largest change, and the distance at rest.

    Distances are measured from the first node to all others.
    """
    index = np.where(block.nodes == 0, -1, deck.find(block.nodes))
    there = index >= 0
    safe = np.maximum(index, 0)
    rows = np.flatnonzero((moved[safe] & there).any(axis=1) & (there.sum(axis=1) > 1))
    if not len(rows):
        none = np.empty(0)
        return rows, none, none
    index, there = safe[rows], there[rows]
    # The first existing node is the reference.
    first = index[np.arange(len(rows)), there.argmax(axis=1)]
    before = np.linalg.norm(deck.points[index] - deck.points[first][:, None], axis=2)
    after = np.linalg.norm(positions[index] - positions[first][:, None], axis=2)
    change = np.where(there, np.abs(after - before), 0.0)
    at = change.argmax(axis=1)
    row = np.arange(len(rows))
    return rows, change[row, at], before[row, at]

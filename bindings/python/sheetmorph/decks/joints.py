# SPDX-License-Identifier: LGPL-2.1-or-later
"""Whether joints hold: what elements tie together keeps its distance."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from ..arrays import Bools, Floats, Ints
from ..strain import middle_edge
from .deck import Deck
from .model import Elements, Place
from .shells import Sheet
from .welds import WeldGaps, weld_gaps

_JOINTS = ("line", "rigid", "weld")
# A joint is broken by half its gap, by half the thickness of the sheet, or by this part of the
# middle length of its edges, whichever is most.
_HALF, _OF_EDGE = 0.5, 0.1


@dataclass(frozen=True)
class Joint:
    """A joint whose nodes changed their distance: where it stands, by how much (mm), and by how
    much it may."""

    place: Place
    change: float
    limit: float

    @property
    def is_broken(self) -> bool:
        """Whether it came apart."""
        return self.change > self.limit


@dataclass(frozen=True)
class Joints:
    """count: how many joints have a node that moved, or are welds near a sheet; worst: of them
    (None if there is none); welds: how far each is from its sheets."""

    count: int
    worst: Joint | None
    broken: list[Joint]
    welds: list[WeldGaps]


def joints_of(deck: Deck, sheet: Sheet, positions: Floats, limit: float | None = None) -> Joints:
    """How the joints of a deck hold with its nodes at (n, 3) positions.

    limit: mm, instead of the one by gap, thickness and edges.
    """
    moved = (positions != deck.points).any(axis=1)
    least = _least(deck, sheet)

    def joint(place: Place, change: float, gap: float) -> Joint:
        return Joint(place, change, max(_HALF * gap, least) if limit is None else limit)

    found = [
        joint(_place(block, int(row)), float(change), float(gap))
        for block in deck.elements
        if block.kind in _JOINTS
        for row, change, gap in zip(*_changes(deck, block, positions, moved))
    ]
    welds = weld_gaps(deck, sheet, positions) if moved.any() else []
    found += [joint(weld.place, weld.change, sum(weld.before)) for weld in welds]
    worst = max(found, key=lambda one: one.change / max(one.limit, 1e-30), default=None)
    return Joints(len(found), worst, [one for one in found if one.is_broken], welds)


def _place(block: Elements, row: int) -> Place:
    return Place(block.name, int(block.ids[row]), block.file, int(block.lines[row]))


def _least(deck: Deck, sheet: Sheet) -> float:
    edge = middle_edge(deck.points[sheet.nodes], sheet.triangles)
    thickness = [value for value in deck.raw.thickness.values() if value > 0.0]
    return max(_OF_EDGE * edge, _HALF * min(thickness, default=0.0), 1e-9)


def _changes(
    deck: Deck, block: Elements, positions: Floats, moved: Bools
) -> tuple[Ints, Floats, Floats]:
    """Rows of elements with a node that moved, the largest change of a distance from the first node
    to another, and that distance at rest."""
    index = np.where(block.nodes == 0, -1, deck.find(block.nodes))
    there = index >= 0
    safe = np.maximum(index, 0)
    rows = np.flatnonzero((moved[safe] & there).any(axis=1) & (there.sum(axis=1) > 1))
    if not len(rows):
        none = np.empty(0)
        return rows, none, none
    index, there = safe[rows], there[rows]
    # The first that is there leads.
    first = index[np.arange(len(rows)), there.argmax(axis=1)]
    before = np.linalg.norm(deck.points[index] - deck.points[first][:, None], axis=2)
    after = np.linalg.norm(positions[index] - positions[first][:, None], axis=2)
    change = np.where(there, np.abs(after - before), 0.0)
    at = change.argmax(axis=1)
    row = np.arange(len(rows))
    return rows, change[row, at], before[row, at]

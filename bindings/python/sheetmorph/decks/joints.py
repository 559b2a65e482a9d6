# SPDX-License-Identifier: LGPL-2.1-or-later
"""Whether joints hold: what elements tie together keeps its distance."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from ..kernel import load_kernel
from .deck import Deck
from .model import Elements, Place
from .shells import Sheet

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
    """count: how many joints have a node that moved; worst: of them (None if there is none)."""

    count: int
    worst: Joint | None
    broken: list[Joint]


def joints_of(
    deck: Deck, sheet: Sheet, positions: np.ndarray, limit: float | None = None
) -> Joints:
    """How the joints of a deck hold with its nodes at (n, 3) positions.

    limit: mm, instead of the one by gap, thickness and edges.
    """
    moved = (positions != deck.points).any(axis=1)
    least = _least(deck, sheet)
    count, worst, broken = 0, None, []
    for block in deck.elements:
        if block.kind not in _JOINTS:
            continue
        found = [_changes(deck, block, positions, moved)]
        if block.kind == "weld":
            found.append(_off_the_sheet(deck, sheet, block, positions))
        for row, change, gap in (one for some in found for one in zip(*some)):
            count += 1
            allowed = max(_HALF * gap, least) if limit is None else limit
            one = Joint(_place(block, int(row)), float(change), float(allowed))
            if worst is None or one.change / one.limit > worst.change / worst.limit:
                worst = one
            if one.is_broken:
                broken.append(one)
    return Joints(count, worst, broken)


def _place(block: Elements, row: int) -> Place:
    return Place(block.name, int(block.ids[row]), block.file, int(block.lines[row]))


def _least(deck: Deck, sheet: Sheet) -> float:
    corners = deck.points[sheet.nodes][sheet.triangles]
    edges = np.linalg.norm(corners - np.roll(corners, 1, axis=1), axis=2)
    edge = float(np.median(edges)) if edges.size else 0.0
    thickness = [value for value in deck.raw.thickness.values() if value > 0.0]
    return max(_OF_EDGE * edge, _HALF * min(thickness, default=0.0), 1e-9)


def _off_the_sheet(
    deck: Deck, sheet: Sheet, block: Elements, positions: np.ndarray
) -> tuple[list[int], list[float], list[float]]:
    """The same of welds by one point: how its distance from the sheet changed."""
    index = np.where(block.nodes == 0, -1, deck.find(block.nodes))
    rows = np.flatnonzero((index >= 0).sum(axis=1) == 1)
    found: tuple[list[int], list[float], list[float]] = ([], [], [])
    rest, after = deck.points[sheet.nodes], positions[sheet.nodes]
    if not len(rows) or np.array_equal(rest, after):
        return found
    kernel = load_kernel()
    trees = [kernel.PickingTree(points, sheet.triangles) for points in (rest, after)]
    for row in rows.tolist():
        node = int(index[row].max())
        hits = [tree.nearest_point(p[node]) for tree, p in zip(trees, (deck.points, positions))]
        if None not in hits:
            gap = float(hits[0].distance)
            for some, value in zip(found, (row, abs(float(hits[1].distance) - gap), gap)):
                some.append(value)
    return found


def _changes(
    deck: Deck, block: Elements, positions: np.ndarray, moved: np.ndarray
) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
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

# SPDX-License-Identifier: LGPL-2.1-or-later
"""Distances of welds and fasteners from their sheets, before and after."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import numpy as np

from ..base.arrays import Floats, Ints
from ..base.kernel import load_kernel
from ..measuring.strain import middle_edge
from .attachment import labels_of
from .deck import Deck
from .model import Elements, Place
from .shells import Sheet

if TYPE_CHECKING:
    from .. import _core

# Largest distance of a weld point from its sheets, in median edge lengths, and number of sheets.
REACH, _MOST = 3.0, 2


@dataclass(frozen=True)
class WeldGaps:
    """A weld with its distances, mm, before and after.

    They are those from the two nearest sheets, from one if no other is near, or between its two
    nodes if these belong to sheets.
    """

    place: Place
    before: tuple[float, ...]
    after: tuple[float, ...]

    @property
    def change(self) -> float:
        """The largest change of a distance, mm."""
        return max(abs(b - a) for a, b in zip(self.before, self.after))


def weld_gaps(deck: Deck, sheet: Sheet, positions: Floats) -> list[WeldGaps]:
    """Return all welds with a point near a sheet, for nodes at positions (n, 3)."""
    blocks = [block for block in deck.elements if block.kind == "weld"]
    if not blocks or not len(sheet.triangles):
        return []
    is_shell = np.zeros(len(deck.ids), dtype=bool)
    is_shell[sheet.nodes] = True
    sheets = _Sheets(deck.points[sheet.nodes], positions[sheet.nodes], sheet.triangles)
    found = [_gaps(deck, block, (is_shell, sheets, positions)) for block in blocks]
    return [gaps for some in found for gaps in some]


def _gaps(deck: Deck, block: Elements, given: tuple[Any, ...]) -> list[WeldGaps]:
    is_shell, sheets, positions = given
    found = []
    index = np.where(block.nodes == 0, -1, deck.find(block.nodes))
    for row, nodes in enumerate(index):
        nodes = nodes[nodes >= 0]
        points = nodes[~is_shell[nodes]]
        if len(points):
            before, after = sheets.gaps(deck.points[points[0]], positions[points[0]])
        elif len(nodes) == 2:
            before, after = (
                (float(np.linalg.norm(at[nodes[0]] - at[nodes[1]])),)
                for at in (deck.points, positions)
            )
        else:
            continue
        if before:
            number = int(block.ids[row])
            place = Place(block.name, number, block.file, int(block.lines[row]))
            found.append(WeldGaps(place, before, after))
    return found


class _Sheets:
    """The connected sheets of a deck, each with search trees before and after."""

    def __init__(self, rest: Floats, moved: Floats, triangles: Ints):
        self._reach = REACH * middle_edge(rest, triangles)
        links = np.concatenate([triangles[:, [0, 1]], triangles[:, [1, 2]]]).astype(np.int64)
        label = labels_of(len(rest), links)[triangles[:, 0]]
        order = np.argsort(label, kind="stable")
        _, first = np.unique(label[order], return_index=True)
        self._pieces = [triangles[rows] for rows in np.split(order, first[1:])]
        self._boxes = np.array(
            [(rest[piece].min(axis=(0, 1)), rest[piece].max(axis=(0, 1))) for piece in self._pieces]
        )
        self._states = (rest, moved)
        self._trees: dict[tuple[int, int], _core.PickingTree] = {}

    def gaps(self, before: Floats, after: Floats) -> tuple[tuple[float, ...], ...]:
        """Return the distances of a point from the nearest sheets, before and after."""
        low, high = self._boxes[:, 0], self._boxes[:, 1]
        away = np.linalg.norm(np.maximum(np.maximum(low - before, before - high), 0.0), axis=1)
        near = [
            (distance, k)
            for k in np.flatnonzero(away <= self._reach).tolist()
            if (distance := self._distance(0, k, before)) <= self._reach
        ]
        chosen = sorted(near)[:_MOST]
        now = tuple(self._distance(1, k, after) for _, k in chosen)
        return tuple(distance for distance, _ in chosen), now

    def _distance(self, state: int, piece: int, point: Floats) -> float:
        if (state, piece) not in self._trees:
            rows, corners = np.unique(self._pieces[piece], return_inverse=True)
            triangles = np.ascontiguousarray(corners.reshape(-1, 3), np.int32)
            places = np.ascontiguousarray(self._states[state][rows])
            self._trees[state, piece] = load_kernel().PickingTree(places, triangles)
        hit = self._trees[state, piece].nearest_point(point)
        return float("inf") if hit is None else float(hit.distance)

# SPDX-License-Identifier: LGPL-2.1-or-later
"""Folded strips: sections made of straight runs and bends, and the blanks they are folded from."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np

from shapes.curves import stepped
from shapes.planar import Hole
from shapes.surface import Map


@dataclass(frozen=True)
class Profile:
    """A folded section in a plane: runs of `(length, turn in degrees)`; turn 0 is straight.

    Starts at `start` in the direction `heading` (degrees) and is parametrised by arc length.
    """

    start: tuple[float, float]
    heading: float
    runs: tuple[tuple[float, float], ...]

    def length(self) -> float:
        return sum(length for length, _ in self.runs)

    def at(self, arc: np.ndarray) -> np.ndarray:
        """(n, 2) positions at (n,) arc lengths; beyond the ends it goes straight on."""
        place, angle, begin = np.array(self.start, float), np.radians(self.heading), 0.0
        result = np.empty((len(arc), 2))
        for number, (length, turn) in enumerate(self.runs):
            last = number == len(self.runs) - 1
            here = (arc >= begin if number else np.full(len(arc), True)) & (
                np.full(len(arc), True) if last else arc < begin + length
            )
            rate = np.radians(turn) / length
            result[here] = place + _run(arc[here] - begin, angle, rate)
            place = place + _run(np.array([length]), angle, rate)[0]
            angle, begin = angle + np.radians(turn), begin + length
        return result


def _run(arc: np.ndarray, angle: float, rate: float) -> np.ndarray:
    """(n, 2) offsets along a straight or circular run."""
    if rate == 0.0:
        return np.outer(arc, [np.cos(angle), np.sin(angle)])
    end = angle + rate * arc
    return np.column_stack([np.sin(end) - np.sin(angle), np.cos(angle) - np.cos(end)]) / rate


def folded(profile: Profile, plane: np.ndarray, across: np.ndarray) -> Map:
    """Blank (arc, width) to space: section in `plane` (2, 3), width along `across` (3,)."""

    def surface(at: np.ndarray) -> np.ndarray:
        return profile.at(at[:, 0]) @ plane + np.outer(at[:, 1], across)

    return surface


@dataclass(frozen=True)
class Strip:
    """A blank between edges `low(arc)` and `high(arc)`, folded along lines of constant arc.

    Edges and folds are sampled with `spacing`, finer beside `holes`. Folds closer together than
    half the spacing must stay in step to be edges of a Delaunay mesh: `refines_folds=False`.
    """

    length: float
    low: Callable[[np.ndarray], np.ndarray]
    high: Callable[[np.ndarray], np.ndarray]
    folds: tuple[float, ...]
    spacing: float
    holes: tuple[Hole, ...] = ()
    refines_folds: bool = True

    def outline(self) -> np.ndarray:
        """(k, 2) counter-clockwise outline with a vertex at both ends of every fold."""
        stations = [0.0, *self.folds, self.length]
        low = self._edge(self.low, stations)
        high = self._edge(self.high, stations)[::-1]
        end = self._across(self.length)[1:-1]
        start = self._across(0.0)[::-1][1:-1]
        return np.vstack([low, end, high, start])

    def fold_lines(self) -> tuple[np.ndarray, ...]:
        """One blank polyline per fold, from the low to the high edge."""
        return tuple(self._across(arc) for arc in self.folds)

    def _edge(self, height: Callable[[np.ndarray], np.ndarray], stations: list) -> np.ndarray:
        pieces = []
        for begin, end in zip(stations[:-1], stations[1:]):
            arc = begin + (end - begin) * (1 - np.cos(np.linspace(0, np.pi, 400))) / 2
            curve = np.column_stack([arc, height(arc)])
            pieces.append(stepped(curve, self.spacing, self.holes)[:-1])
        last = np.array([stations[-1]])
        return np.vstack([*pieces, np.column_stack([last, height(last)])])

    def _across(self, arc: float) -> np.ndarray:
        at = np.array([arc])
        ends = np.array([[arc, self.low(at)[0]], [arc, self.high(at)[0]]])
        return stepped(ends, self.spacing, self.holes if self.refines_folds else ())


def rounded_end(arc: np.ndarray, length: float, radius: float) -> np.ndarray:
    """How much a strip's edge is drawn in at arc lengths near both rounded ends."""
    left = np.clip(1 - arc / radius, 0, 1)
    right = np.clip(1 - (length - arc) / radius, 0, 1)
    return radius * (2 - np.sqrt(1 - left**2) - np.sqrt(1 - right**2))

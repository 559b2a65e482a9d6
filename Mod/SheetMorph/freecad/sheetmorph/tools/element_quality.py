# SPDX-License-Identifier: LGPL-2.1-or-later
"""The quality of the elements of decks during a motion, by a measure of the certificate."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass

import numpy as np

from freecad.sheetmorph.tools import colour_scale
from freecad.sheetmorph.tools.marked import QT_TRANSLATE_NOOP

BINS = 24
# For each measure: its unit, the label of its worst value, the first ends of its colours.
MEASURES = {
    "aspect": ("", QT_TRANSLATE_NOOP("SheetMorph_panels", "worst aspect"), (1.0, 2.0)),
    "warpage": ("°", QT_TRANSLATE_NOOP("SheetMorph_panels", "worst warpage"), (0.0, 1.0)),
    "skew": ("°", QT_TRANSLATE_NOOP("SheetMorph_panels", "worst skew"), (0.0, 90.0)),
    "taper": ("", QT_TRANSLATE_NOOP("SheetMorph_panels", "worst taper"), (0.0, 1.0)),
    "jacobian": ("", QT_TRANSLATE_NOOP("SheetMorph_panels", "worst Jacobian"), (0.0, 1.0)),
    "min_angle": ("°", QT_TRANSLATE_NOOP("SheetMorph_panels", "smallest corner"), (0.0, 90.0)),
    "max_angle": ("°", QT_TRANSLATE_NOOP("SheetMorph_panels", "largest corner"), (60.0, 180.0)),
    "min_length": ("mm", QT_TRANSLATE_NOOP("SheetMorph_panels", "shortest edge"), (0.0, 1.0)),
}
LOW_IS_BAD = ("jacobian", "min_angle", "min_length")
Positions = dict[str, np.ndarray]


@dataclass(frozen=True, eq=False)
class Histogram:
    """The number of elements by value, at rest and now, (BINS,) each, over a span.

    `limit` is the limit of the criteria, None without one. `failing` counts the elements beyond it.
    """

    span: tuple[float, float]
    rest: np.ndarray
    now: np.ndarray
    limit: float | None
    failing: int

    def bars(self, width: float, height: float) -> list[tuple]:
        """Return left end, right end, height now, height at rest and colour of each bar.

        Heights grow with the square root of the count, so that a few bad elements among thousands
        stay visible.
        """
        ends = np.linspace(0.0, width, len(self.now) + 1)
        middles = (ends[1:] + ends[:-1]) / (2.0 * width)
        scale = height / np.sqrt(max(self.now.max(), self.rest.max(), 1))
        tall = (scale * np.sqrt(counts) for counts in (self.now, self.rest))
        colours = colour_scale.colours_of(middles, (0.0, 1.0))
        return list(zip(ends[:-1], ends[1:], *tall, colours.tolist()))

    def place_of_limit(self) -> float | None:
        """Return the position of the limit on the span, 0 to 1; None if absent or outside."""
        low, high = self.span
        if self.limit is None or not low <= self.limit <= high:
            return None
        return (self.limit - low) / (high - low)

    @property
    def count(self) -> int:
        """The number of elements."""
        return int(self.now.sum())


class ElementQuality:
    """The worst value of the elements at every vertex, with the `histogram` of the last call."""

    def __init__(
        self, name: str, measured: Callable, limits: Mapping[str, float], parts: dict[str, tuple]
    ):
        """Prepare a measure for parts at rest.

        `measured(positions, faces)` returns values (e,). `limits` has their "min" or "max". `parts`
        maps names to points at rest (n, 3) and faces (e, 4).
        """
        self.unit, self.worst, self._ends = MEASURES[name]
        self.is_low_bad = name in LOW_IS_BAD
        self._measured, self._limits = measured, limits
        self._parts = {name: (len(rest), faces) for name, (rest, faces) in parts.items()}
        self._rest = self._all({name: rest for name, (rest, _) in parts.items()})
        self.histogram: Histogram | None = None

    def __call__(self, positions: Positions) -> Positions:
        """Return the values (n,) by part."""
        found = self._all(positions)
        self.histogram = self._histogram(found)
        return {name: self._at_vertices(name, values) for name, values in found.items()}

    def span(self, _extreme: float) -> tuple[float, float]:
        """Return the ends of the colours, which are those of the histogram."""
        return self.histogram.span

    def _all(self, positions: Positions) -> Positions:
        return {
            name: self._measured(positions[name], faces) for name, (_, faces) in self._parts.items()
        }

    def _at_vertices(self, name: str, values: np.ndarray) -> np.ndarray:
        count, faces = self._parts[name]
        start = np.inf if self.is_low_bad else -np.inf
        # The extra last row takes the -1 that stands for the missing corner of a triangle.
        found = np.full(count + 1, start)
        pick = np.minimum if self.is_low_bad else np.maximum
        for corner in range(4):
            pick.at(found, faces[:, corner], values)
        return np.where(np.isfinite(found), found, np.nan)[:-1]

    def _histogram(self, now: Positions) -> Histogram:
        rest, values = (np.concatenate(list(of.values())) for of in (self._rest, now))
        both = np.concatenate([rest, values])
        low, high = (float(f(both)) for f in (np.min, np.max)) if len(both) else (0.0, 1.0)
        if low < self._ends[0] or high > self._ends[1]:
            low, high = min(self._ends[0], low), max(self._ends[1], colour_scale.round_up(high))
        else:
            low, high = self._ends
        beyond = values < self._limits.get("min", -np.inf)
        beyond |= values > self._limits.get("max", np.inf)
        limit = next(iter(self._limits.values()), None)
        counts = (np.histogram(some, BINS, (low, high))[0] for some in (rest, values))
        return Histogram((low, high), *counts, limit, int(beyond.sum()))

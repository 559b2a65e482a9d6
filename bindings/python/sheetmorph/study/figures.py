# SPDX-License-Identifier: LGPL-2.1-or-later
"""Figures of a report, by the names in measures and criteria."""

from __future__ import annotations

import itertools
from collections.abc import Callable, Iterator, Mapping
from functools import cached_property
from typing import Any

import numpy as np

from ..base.arrays import Floats
from ..measuring.distance import touching
from ..reporting.report import part_report, rigidity
from ..reporting.thin_solids import crossed_anew
from ..solving.answer import Answer

# For these the worst value is the smallest; for all others it is the largest.
_SMALLEST = {"angle"}
_SUMS = {"flipped", "crossings"}

_OF_PART: dict[str, Callable[[dict[str, Any]], Any]] = {
    "angle": lambda part: part["quality"]["after"]["worst_angle_degrees"],
    "aspect": lambda part: part["quality"]["after"]["worst_aspect"],
    "flipped": lambda part: part["quality"]["flipped"],
    "stretch": lambda part: part["quality"]["worst_strain"],
    "fold": lambda part: part["quality"]["worst_fold_degrees"],
    "displacement": lambda part: part["largest_displacement"],
    "thickness change": lambda part: (part["thin"] or {}).get("largest_change"),
}
FIGURES = (*_OF_PART, "gap change", "edge error", "crossings", "touching", "warnings")


def live_report(result: Answer) -> dict[str, Any]:
    """Return the part entries of a report for an answer that is not exact."""
    return {
        "parts": [part_report(result, name, None, True) for name in result.session.parts],
        "features": [],
        "contacts": [],
        "warnings": [],
        "certificate": {"failures": []},
    }


class Figures:
    """The figures of one result and its report."""

    def __init__(self, result: Answer, report: dict[str, Any]):
        self._result, self._report = result, report

    def figure(self, name: str, part: str = "") -> float | None:
        """Return a figure of a part, or of all parts by default; None if it is not available."""
        numbers = [number for number in self._numbers(name, part) if number is not None]
        if name in _SUMS:
            return float(sum(numbers))
        if name in ("touching", "warnings"):
            return float(numbers[0])
        if not numbers:
            return None
        return float(min(numbers) if name in _SMALLEST else max(numbers))

    def _numbers(self, name: str, part: str) -> list[Any]:
        report = self._report
        if name in _OF_PART:
            return [_OF_PART[name](entry) for entry in _of(report["parts"], "name", part)]
        if name == "edge error":
            features = _of(report["features"], "part", part)
            return [rigidity(entry) for entry in features]
        if name == "gap change":
            pairs = [(c["gap_change"], c["source"], c["target"]) for c in report["contacts"]]
            return [change for change, *parts in pairs if not part or part in parts]
        if name == "crossings":
            return [len(crossed_anew(self._result, entry)) for entry in self._result.positions]
        return [len(report["warnings"])] if name == "warnings" else [self._touching]

    @cached_property
    def _touching(self) -> int:
        """Number of triangle pairs of different parts that intersect, beyond those at rest."""
        positions, meshes = self._result.positions, self._result.session.meshes
        found = 0
        for one, other in _near(positions):
            rows = meshes[one].triangles, meshes[other].triangles
            met = touching(positions[one], rows[0], positions[other], rows[1])
            if met:
                rest = meshes[one].points, meshes[other].points
                found += max(0, met - touching(rest[0], rows[0], rest[1], rows[1]))
        return found


def _near(positions: Mapping[str, Floats]) -> Iterator[tuple[str, str]]:
    """Yield the pairs of parts whose boxes overlap."""
    boxes = {name: (at.min(axis=0), at.max(axis=0)) for name, at in positions.items()}
    for one, other in itertools.combinations(boxes, 2):
        low, high = (np.stack([boxes[name][k] for name in (one, other)]) for k in (0, 1))
        if (low.max(axis=0) <= high.min(axis=0)).all():
            yield one, other


def _of(entries: list[dict[str, Any]], key: str, part: str) -> list[dict[str, Any]]:
    return [entry for entry in entries if not part or entry[key] == part]

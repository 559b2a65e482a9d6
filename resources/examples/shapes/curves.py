# SPDX-License-Identifier: LGPL-2.1-or-later
"""Curves of a blank sampled so that the edges along them fit to what lies beside them."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from shapes.planar import Hole

SAMPLES = 2000
GROWTH = 0.6  # mm of edge length per mm away from a hole


def stepped(curve: np.ndarray, spacing: float, holes: Sequence[Hole] = ()) -> np.ndarray:
    """An open polyline with steps of `spacing` mm, finer beside holes; both ends are kept."""
    return _by_measure(curve, spacing, holes, lambda steps: max(1, int(round(steps))))


def closed_steps(
    loop: np.ndarray, spacing: float, holes: Sequence[Hole] = (), count: int = 0
) -> np.ndarray:
    """A closed polyline (last = first) along the (k, 2) loop; `count` fixes the number of steps."""
    closed = np.vstack([loop, loop[:1]])
    points = _by_measure(closed, spacing, holes, lambda steps: count or max(6, int(round(steps))))
    points[-1] = points[0]
    return points


def circle(centre: Sequence[float], radius: float, spacing: float) -> np.ndarray:
    """A closed polyline around a point."""
    count = max(12, int(round(2 * np.pi * radius / spacing)))
    angle = 2 * np.pi * np.arange(count + 1) / count
    loop = np.asarray(centre) + radius * np.column_stack([np.cos(angle), np.sin(angle)])
    loop[-1] = loop[0]
    return loop


def _by_measure(curve: np.ndarray, spacing: float, holes: Sequence[Hole], steps) -> np.ndarray:
    arc = _arc(curve)
    dense = _at(curve, arc, np.linspace(0, arc[-1], SAMPLES + 1))
    size = np.full(SAMPLES, spacing)
    for hole in holes:
        away = np.linalg.norm((dense[1:] + dense[:-1]) / 2 - np.asarray(hole.centre), axis=1)
        chord = 2 * np.pi * hole.outer_radius() / hole.count
        size = np.minimum(size, chord + GROWTH * np.maximum(away - hole.outer_radius(), 0.0))
    measure = np.concatenate([[0], np.cumsum(arc[-1] / SAMPLES / size)])
    return _at(dense, measure, np.linspace(0, measure[-1], steps(measure[-1]) + 1))


def _arc(curve: np.ndarray) -> np.ndarray:
    return np.concatenate([[0], np.cumsum(np.linalg.norm(np.diff(curve, axis=0), axis=1))])


def _at(curve: np.ndarray, measure: np.ndarray, where: np.ndarray) -> np.ndarray:
    return np.column_stack([np.interp(where, measure, curve[:, k]) for k in range(2)])

# SPDX-License-Identifier: LGPL-2.1-or-later
"""Positions for marks on the screen that do not hide each other; needs no FreeCAD."""

from __future__ import annotations

import math

import numpy as np

WAYS = 16  # directions in which to look for a free place
STEP = 0.5  # of the least distance, by which each round looks farther


def spread(places: np.ndarray, least: float, taken: tuple = ()) -> np.ndarray:
    """Return places (n, 2) px near `places`, at least `least` px apart.

    `taken` has pairs of a place (2,) and a distance (px) that all marks keep from it. The first
    places keep their position where possible.
    """
    kept: list[tuple[np.ndarray, float]] = [(np.asarray(at, float), far) for at, far in taken]
    found = []
    for place in np.asarray(places, float).reshape(-1, 2):
        free = next(spot for spot in _spots(place, least) if _is_free(spot, kept))
        kept.append((free, least))
        found.append(free)
    return np.array(found).reshape(-1, 2)


def _spots(place: np.ndarray, least: float):
    """Yield a place, then places around it at growing distance, the upper one first."""
    yield place
    radius = 0.0
    while True:
        radius += STEP * least
        for k in range(WAYS):
            turn = math.pi / 2 - 2.0 * math.pi * k / WAYS
            yield place + radius * np.array([math.cos(turn), math.sin(turn)])


def _is_free(spot: np.ndarray, kept: list) -> bool:
    return all(np.linalg.norm(spot - at) >= far - 1e-9 for at, far in kept)

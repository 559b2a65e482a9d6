# SPDX-License-Identifier: LGPL-2.1-or-later
"""Colours for numbers: what a map of values shows and its legend says."""

from __future__ import annotations

import numpy as np

# Dark blue to yellow through green, even in lightness, distinct for the colour-blind (viridis).
STOPS = np.array(
    [
        (0.267, 0.005, 0.329),
        (0.230, 0.322, 0.546),
        (0.128, 0.567, 0.551),
        (0.369, 0.789, 0.383),
        (0.993, 0.906, 0.144),
    ]
)
MISSING = (0.62, 0.64, 0.66)
"""Where there is no value."""

NARROWEST = 0.1
"""A legend spans at least this share of its middle: rounding is no pattern."""


def span_of(values: np.ndarray) -> tuple[float, float]:
    """The range (low, high) of a legend for values (n,), NaN left out; (0, 1) without any."""
    low, high = range_of(values)
    middle = 0.5 * (low + high)
    half = max(0.5 * (high - low), 0.5 * NARROWEST * abs(middle))
    return middle - half, middle + half


def range_of(values: np.ndarray) -> tuple[float, float]:
    """The least and the greatest of values (n,), NaN left out; (0, 1) without any."""
    known = values[np.isfinite(values)]
    return (float(known.min()), float(known.max())) if len(known) else (0.0, 1.0)


def ramp(count: int) -> np.ndarray:
    """All colours of a legend from low to high, (count, 3)."""
    return colours_of(np.linspace(0.0, 1.0, count), (0.0, 1.0))


def colours_of(values: np.ndarray, span: tuple[float, float]) -> np.ndarray:
    """Colours (n, 3), 0 to 1, of values (n,) in a span; NaN is grey, what is outside its end's."""
    low, high = span
    share = np.clip((np.nan_to_num(values, nan=low) - low) / max(high - low, 1e-300), 0.0, 1.0)
    places = np.linspace(0.0, 1.0, len(STOPS))
    colours = np.stack([np.interp(share, places, STOPS[:, k]) for k in range(3)], axis=1)
    colours[~np.isfinite(values)] = MISSING
    return colours


def round_up(value: float) -> float:
    """The next of 1, 2, 5, 10, ... that is not less: a legend that does not flicker."""
    if not value > 0.0:
        return 1.0
    power = 10.0 ** np.floor(np.log10(value))
    steps = (power * factor for factor in (1.0, 2.0, 5.0))
    return float(next((step for step in steps if step >= value * (1.0 - 1e-9)), 10.0 * power))

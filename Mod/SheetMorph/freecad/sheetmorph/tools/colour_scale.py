# SPDX-License-Identifier: LGPL-2.1-or-later
"""The colours that a map of values and its legend show for numbers."""

from __future__ import annotations

import numpy as np

# Viridis: from dark blue through green to yellow, even in lightness, clear to the colour-blind.
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
"""The colour of a vertex without a value."""

NARROWEST = 0.1
"""The least span of a legend as a share of its middle, so that rounding shows no pattern."""


def span_of(values: np.ndarray) -> tuple[float, float]:
    """Return the range (low, high) of a legend for values (n,); (0, 1) without a finite value."""
    low, high = range_of(values)
    middle = 0.5 * (low + high)
    half = max(0.5 * (high - low), 0.5 * NARROWEST * abs(middle))
    return middle - half, middle + half


def range_of(values: np.ndarray) -> tuple[float, float]:
    """Return the least and the greatest finite value of (n,); (0, 1) without any."""
    known = values[np.isfinite(values)]
    return (float(known.min()), float(known.max())) if len(known) else (0.0, 1.0)


def ramp(count: int) -> np.ndarray:
    """Return the colours of a legend from low to high, (count, 3)."""
    return colours_of(np.linspace(0.0, 1.0, count), (0.0, 1.0))


def colours_of(values: np.ndarray, span: tuple[float, float]) -> np.ndarray:
    """Return colours (n, 3), 0 to 1, of values (n,) in a span.

    NaN is grey. A value outside the span has the colour of the nearer end.
    """
    low, high = span
    share = np.clip((np.nan_to_num(values, nan=low) - low) / max(high - low, 1e-300), 0.0, 1.0)
    places = np.linspace(0.0, 1.0, len(STOPS))
    colours = np.stack([np.interp(share, places, STOPS[:, k]) for k in range(3)], axis=1)
    colours[~np.isfinite(values)] = MISSING
    return colours


def round_up(value: float) -> float:
    """Return the least of 1, 2, 5, 10, … not below a value, for a legend without flicker."""
    if not value > 0.0:
        return 1.0
    power = 10.0 ** np.floor(np.log10(value))
    steps = (power * factor for factor in (1.0, 2.0, 5.0))
    return float(next((step for step in steps if step >= value * (1.0 - 1e-9)), 10.0 * power))

# SPDX-License-Identifier: LGPL-2.1-or-later
"""Numbers as text for readers, without exponents and rounding noise."""

from __future__ import annotations

import numpy as np

LEAST_LENGTH = 0.0005  # mm: smaller lengths are rounding errors or irrelevant
LEAST_SHARE = 0.0005


def plain(value: float, digits: int = 3) -> str:
    """Return a number with significant digits and without an exponent."""
    text = f"{float(f'{value:.{digits}g}'):f}"
    return text.rstrip("0").rstrip(".") if "." in text else text


def length(value: float, digits: int = 3) -> str:
    """Return a length in mm as text."""
    return f"{plain(value, digits) if abs(value) >= LEAST_LENGTH else '0'} mm"


def exact_length(value: float) -> str:
    """Return a length (mm) with all its digits, for use as a value."""
    return f"{np.format_float_positional(value, trim='-')} mm"


def percent(share: float) -> str:
    """Return a fraction as text in percent."""
    return f"{plain(100.0 * share, 2) if abs(share) >= LEAST_SHARE else '0'} %"

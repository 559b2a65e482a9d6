# SPDX-License-Identifier: LGPL-2.1-or-later
"""Numbers as a person reads them: no exponents, no noise of rounding."""

from __future__ import annotations

import numpy as np

LEAST_LENGTH = 0.0005  # mm: what is smaller is rounding, or nobody's concern
LEAST_SHARE = 0.0005


def plain(value: float, digits: int = 3) -> str:
    """A number with so many digits that count, never with an exponent."""
    text = f"{float(f'{value:.{digits}g}'):f}"
    return text.rstrip("0").rstrip(".") if "." in text else text


def length(value: float, digits: int = 3) -> str:
    """A length, mm."""
    return f"{plain(value, digits) if abs(value) >= LEAST_LENGTH else '0'} mm"


def exact_length(value: float) -> str:
    """A length that is to be used as it stands, however small, mm."""
    return f"{np.format_float_positional(value, trim='-')} mm"


def percent(share: float) -> str:
    """A share of one as percent."""
    return f"{plain(100.0 * share, 2) if abs(share) >= LEAST_SHARE else '0'} %"

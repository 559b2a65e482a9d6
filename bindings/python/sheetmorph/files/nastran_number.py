# SPDX-License-Identifier: LGPL-2.1-or-later
"""Real numbers of Nastran fields: `1.5-3` is read, the nearest that fits a field is written."""

from __future__ import annotations

import math
import re

_REAL = re.compile(r"([+-]?(?:\d+\.?\d*|\.\d+))(?:[ED]([+-]?\d+)|([+-]\d+))?", re.IGNORECASE)


def parse_real(text: str) -> float | None:
    """The value of a field; 0 for a blank one, None if it is not a finite number."""
    stripped = text.strip()
    if not stripped:
        return 0.0
    found = _REAL.fullmatch(stripped)
    if not found:
        return None
    mantissa, plain, bare = found.groups()
    value = float(f"{mantissa}e{plain or bare or 0}")
    return value if math.isfinite(value) else None


def format_real(value: float, width: int) -> str:
    """The text of at most `width` characters (8 or 16) that is nearest to a finite value.

    Always with a decimal point, as Nastran tells reals from integers. Raises ValueError if the
    number does not fit (beyond about 1e99).
    """
    if value == 0.0:
        return "0."
    fixed = _fixed(value, width)
    # In this range a fixed point number has at least as many digits as one with an exponent.
    if fixed is not None and 1e-2 <= abs(value) < 10.0 ** (width - 2):
        return fixed
    candidates = [fixed] if fixed is not None else []
    candidates += _with_exponent(value, width)
    if not candidates:
        raise ValueError(f"{value!r} does not fit a Nastran field of {width} characters")
    return min(candidates, key=lambda text: (abs((parse_real(text) or 0.0) - value), len(text)))


def _fixed(value: float, width: int) -> str | None:
    whole = len(str(int(abs(value)))) if abs(value) >= 1.0 else 0
    room = width - whole - 1 - (value < 0)
    # One decimal less where rounding adds a digit, 9.99999996 -> 10.000000.
    for decimals in (room, room - 1):
        if decimals < 0:
            continue
        digits = f"{abs(value):.{decimals}f}"
        digits = digits if "." in digits else digits + "."
        digits = digits[1:] if digits.startswith("0.") and len(digits) > 2 else digits
        digits = digits.rstrip("0") if len(digits) > 2 else digits
        text = ("-" if value < 0 else "") + digits
        if len(text) <= width and any(c in "123456789" for c in text):
            return text
    return None


def _with_exponent(value: float, width: int) -> list[str]:
    """Every `1.234-5`: the point may stand before or behind any digit to shorten the exponent."""
    sign = "-" if value < 0 else ""
    texts = []
    for count in range(1, width - 2):
        mantissa, exponent = f"{abs(value):.{count - 1}e}".split("e")
        digits = mantissa.replace(".", "").rstrip("0") or "0"
        for point in range(len(digits) + 1):
            power = int(exponent) - (point - 1)
            text = f"{sign}{digits[:point]}.{digits[point:]}{power:+d}"
            if len(text) <= width:
                texts.append(text)
    return texts

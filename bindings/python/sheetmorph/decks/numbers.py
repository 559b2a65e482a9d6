# SPDX-License-Identifier: LGPL-2.1-or-later
"""Numbers in deck fields, parsed as in Fortran and written with the nearest text that fits."""

from __future__ import annotations

import math
import re


import numpy as np

from ..base.arrays import Bools, Codes, Floats, Ints
from ..base.errors import InputError

_REAL = re.compile(r"([+-]?(?:\d+\.?\d*|\.\d+))(?:[ED]([+-]?\d+)|([+-]\d+))?", re.IGNORECASE)
# The squares of larger coordinates can overflow.
LARGEST = 1e100
# Of a double.
_DIGITS = 15

_IN_REAL = np.zeros(256, dtype=bool)
_IN_REAL[np.frombuffer(b" +-.0123456789eEdD", np.uint8)] = True
_IS_DIGIT = np.zeros(256, dtype=bool)
_IS_DIGIT[np.frombuffer(b"0123456789", np.uint8)] = True
_BLANK, _PLUS, _MINUS, _POINT, _E = b" +-.e"


def parse_real(text: str) -> float | None:
    """Return the value of a field such as `1.5-3`; 0 if blank, None if it is not finite."""
    stripped = text.strip()
    if not stripped:
        return 0.0
    found = _REAL.fullmatch(stripped)
    if not found:
        return None
    mantissa, plain, bare = found.groups()
    value = float(f"{mantissa}e{plain or bare or 0}")
    return value if abs(value) <= LARGEST else None


def parse_integer(text: str) -> int | None:
    """Return the value of an integer field, or None."""
    stripped = text.strip()
    return int(stripped) if re.fullmatch(r"[+-]?\d{1,18}", stripped) else None


def parse_reals(codes: Codes) -> Floats:
    """Return values (n,) of character codes (n, w); 0 if blank, NaN if invalid."""
    if not codes.size:
        return np.zeros(len(codes))
    if codes.shape[1] < 4:
        codes = np.pad(codes, ((0, 0), (0, 4 - codes.shape[1])), constant_values=_BLANK)
    texts = _with_plain_exponents(codes)
    sound = _IN_REAL[texts].all(axis=1)
    blank = (texts == _BLANK).all(axis=1)
    texts[blank | ~sound, :2] = np.frombuffer(b"0 ", np.uint8)
    texts[blank | ~sound, 2:] = _BLANK
    values = _converted(texts)
    values[~sound | ~(np.abs(values) <= LARGEST)] = np.nan
    return values


def _with_plain_exponents(codes: Codes) -> Codes:
    """Return a wider copy with `1.5D3` and `1.5-3` written as `1.5e3` and `1.5e-3`."""
    texts = np.full((len(codes), codes.shape[1] + 1), _BLANK, dtype=np.uint8)
    texts[:, :-1] = codes
    texts[(texts == ord("D")) | (texts == ord("d"))] = _E
    is_sign = (texts[:, 1:] == _PLUS) | (texts[:, 1:] == _MINUS)
    behind = _IS_DIGIT[texts[:, :-1]] | (texts[:, :-1] == _POINT)
    bare = is_sign & behind
    rows = np.flatnonzero(bare.any(axis=1))
    if len(rows):
        at = bare[rows].argmax(axis=1)[:, None] + 1
        columns = np.arange(texts.shape[1])
        shifted = np.roll(texts[rows], 1, axis=1)
        texts[rows] = np.where(
            columns < at, texts[rows], np.where(columns == at, np.uint8(_E), shifted)
        )
    return texts


def _converted(texts: Codes) -> Floats:
    whole = np.ascontiguousarray(texts).view(f"S{texts.shape[1]}").ravel()
    try:
        return whole.astype(np.float64)
    except ValueError:
        values = (parse_real(text.decode("latin-1")) for text in whole.tolist())
        return np.array([math.nan if value is None else value for value in values])


def parse_integers(codes: Codes) -> tuple[Ints, Bools]:
    """Return values (n,) int64 of character codes (n, w), 0 if blank, and which are valid."""
    values = np.zeros(len(codes), dtype=np.int64)
    negative = np.zeros(len(codes), dtype=bool)
    # States: 0 nothing, 1 a sign, 2 digits, 3 trailing blanks.
    state = np.zeros(len(codes), dtype=np.int8)
    sound = np.full(len(codes), codes.shape[1] <= 20)
    digits = np.zeros(len(codes), dtype=np.int8)
    for k in range(codes.shape[1]):
        column = codes[:, k]
        digit = _IS_DIGIT[column]
        sign = (column == _PLUS) | (column == _MINUS)
        blank = column == _BLANK
        sound &= digit | sign | blank
        sound &= ~(digit & (state == 3)) & ~(sign & (state > 0)) & ~(blank & (state == 1))
        negative |= column == _MINUS
        values = np.where(digit, values * 10 + (column.astype(np.int64) - 48), values)
        digits += digit
        state = np.where(digit, 2, np.where(sign, 1, np.where(blank & (state == 2), 3, state)))
    sound &= (state != 1) & (digits <= 18)
    return np.where(negative, -values, values), sound


def format_reals(values: Floats, room: int, mark: str = "") -> list[str]:
    """Return for each value (n,) the nearest text with at most `room` characters.

    The text has a decimal point, because Nastran distinguishes reals from integers by it. mark
    precedes an exponent: nothing in Nastran, "E" elsewhere. Raises ValueError as format_real()
    does.
    """
    return [format_real(value, room, mark) for value in values.tolist()]


def format_real(value: float, width: int, mark: str = "") -> str:
    """Return the text with at most `width` characters that is nearest to a finite value.

    See format_reals() for mark. Raises ValueError if the number does not fit (beyond about 1e99).
    """
    if value == 0.0:
        return "0."
    text = repr(value)
    size = abs(value)
    if 1e-4 <= size < 1e16:
        text = text[:-1] if text.endswith(".0") else text
        if len(text) <= width:
            return text
    fixed = _fixed(value, width)
    # In this range fixed-point notation has at least as many digits as an exponent.
    if fixed is not None and 1e-2 <= size < 10.0 ** (width - 2):
        return fixed
    candidates = [fixed] if fixed is not None else []
    candidates += _with_exponent(value, width, mark)
    if not candidates:
        what = f"{value!r} does not fit a field of {width} characters"
        raise InputError(what, "check the motion, or use wider fields")
    return min(candidates, key=lambda text: (abs((parse_real(text) or 0.0) - value), len(text)))


def last_digit(size: float, width: int) -> float:
    """Return the last decimal place of numbers up to a size in a field.

    It is at least that of a double with 15 digits. Width 0 stands for a double.
    """
    whole = len(str(int(size))) if size >= 1.0 else 0
    # A sign and a point take one character each.
    digits = min(width - 2, _DIGITS) if width else _DIGITS
    return float(10.0 ** (whole - digits))


def _fixed(value: float, width: int) -> str | None:
    size = abs(value)
    whole = len(str(int(size))) if size >= 1.0 else 0
    room = width - whole - 1 - (value < 0)
    # One decimal less if rounding adds a digit, 9.99999996 -> 10.000000.
    for decimals in (room, room - 1):
        if decimals < 0:
            continue
        digits = f"{size:.{decimals}f}"
        digits = digits if "." in digits else digits + "."
        digits = digits[1:] if digits.startswith("0.") and len(digits) > 2 else digits
        digits = digits.rstrip("0") if len(digits) > 2 else digits
        text = ("-" if value < 0 else "") + digits
        if len(text) <= width and any(c in "123456789" for c in text):
            return text
    return None


def _with_exponent(value: float, width: int, mark: str) -> list[str]:
    """Return all forms of `1.234-5`; the position of the point can shorten the exponent."""
    sign = "-" if value < 0 else ""
    texts = []
    for count in range(1, min(width - 2, 17) + 1):
        mantissa, exponent = f"{abs(value):.{count - 1}e}".split("e")
        digits = mantissa.replace(".", "").rstrip("0") or "0"
        for point in range(len(digits) + 1):
            power = int(exponent) - (point - 1)
            shown = f"{power:+d}" if not mark else f"{mark}{power:d}"
            text = f"{sign}{digits[:point]}.{digits[point:]}{shown}"
            if len(text) <= width:
                texts.append(text)
    return texts

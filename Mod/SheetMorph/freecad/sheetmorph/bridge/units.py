# SPDX-License-Identifier: LGPL-2.1-or-later
"""Lengths and angles as the user types and reads them, in FreeCAD's current units."""

from __future__ import annotations

import math

import FreeCAD

from freecad.sheetmorph.tools import words

STANDARD = 0
"""FreeCAD's default unit scheme: mm, but metres from 10 m, and nanometres below 0.1 mm."""
_TINY = ("nm", "µm")


def number_in(text: str, unit: str, default: float = 1.0) -> float | None:
    """Return the value of `text` in a unit, mm or deg, or None.

    `default` is the factor of a number without a unit.
    """
    try:
        found = FreeCAD.Units.Quantity(text.replace(",", "."))
        is_bare = found == FreeCAD.Units.Quantity(found.Value)  # .Unit leaks, see number_of
        value = default * float(found.Value) if is_bare else float(found.getValueAs(unit))
    except (ValueError, SyntaxError, OSError, ArithmeticError):
        return None
    return value if text.strip() and math.isfinite(value) else None


def said(value: float, unit: str) -> tuple[str, float]:
    """Return a length (mm) or an angle (deg) as text, and the factor of its unit to `unit`.

    The text is as in FreeCAD, but without nanometres and, in the standard scheme, without metres.
    """
    if unit == "deg":
        return f"{_decimal(value)} °", 1.0
    text, factor, name = FreeCAD.Units.Quantity(value, unit).getUserPreferred()
    if FreeCAD.Units.getSchema() == STANDARD or name in _TINY:
        return f"{_decimal(value)} {unit}", 1.0
    return text, factor


def _decimal(value: float) -> str:
    """Return a number with the decimals of FreeCAD's settings, or with three digits.

    Three digits are used if the settings would hide the value.
    """
    settings = FreeCAD.ParamGet("User parameter:BaseApp/Preferences/Units")
    decimals = settings.GetInt("Decimals", 2)
    is_lost = 0.0 < abs(value) < 10.0 ** (1 - decimals) and words.plain(value) != "0"
    return words.plain(value) if is_lost else f"{value:.{decimals}f}"

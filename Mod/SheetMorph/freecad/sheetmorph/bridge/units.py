# SPDX-License-Identifier: LGPL-2.1-or-later
"""Lengths and angles as a person types and reads them, in whatever unit FreeCAD is set to."""

from __future__ import annotations

import math

import FreeCAD

from freecad.sheetmorph.tools import words

STANDARD = 0
"""FreeCAD's scheme of units unless somebody chose another one: mm, but metres from 10 m on, and
nanometres below a tenth of a millimetre."""
_TINY = ("nm", "µm")


def number_in(text: str, unit: str, default: float = 1.0) -> float | None:
    """Return what `text` says in a unit, mm or deg; None if nothing.

    `default`: how many of the unit a number means that says none.
    """
    try:
        found = FreeCAD.Units.Quantity(text.replace(",", "."))
        is_bare = found == FreeCAD.Units.Quantity(found.Value)  # .Unit leaks, see number_of
        value = default * float(found.Value) if is_bare else float(found.getValueAs(unit))
    except (ValueError, SyntaxError, OSError, ArithmeticError):
        return None
    return value if text.strip() and math.isfinite(value) else None


def said(value: float, unit: str) -> tuple[str, float]:
    """Return a length (mm) or an angle (deg) as text, and how many of `unit` the unit in it is.

    As FreeCAD shows it, but nobody who works with sheet thinks in nanometres, nor wants metres
    where millimetres are typed.
    """
    if unit == "deg":
        return f"{_decimal(value)} °", 1.0
    text, factor, name = FreeCAD.Units.Quantity(value, unit).getUserPreferred()
    if FreeCAD.Units.getSchema() == STANDARD or name in _TINY:
        return f"{_decimal(value)} {unit}", 1.0
    return text, factor


def _decimal(value: float) -> str:
    """A number with the decimals of FreeCAD's settings, or three digits if those are too few."""
    settings = FreeCAD.ParamGet("User parameter:BaseApp/Preferences/Units")
    decimals = settings.GetInt("Decimals", 2)
    is_lost = 0.0 < abs(value) < 10.0 ** (1 - decimals) and words.plain(value) != "0"
    return words.plain(value) if is_lost else f"{value:.{decimals}f}"

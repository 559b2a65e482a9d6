# SPDX-License-Identifier: LGPL-2.1-or-later
"""What a person types for a length or an angle, in whatever unit."""

from __future__ import annotations

import FreeCAD


def number_in(text: str, unit: str) -> float | None:
    """Return what `text` says in a unit, mm or deg, which it may leave out; None if nothing."""
    try:
        found = FreeCAD.Units.Quantity(text.replace(",", "."))
        if found.Unit == FreeCAD.Units.Unit():
            return float(found.Value) if text.strip() else None
        return float(found.getValueAs(unit))
    except (ValueError, SyntaxError, OSError, ArithmeticError):
        return None

# SPDX-License-Identifier: LGPL-2.1-or-later
"""The unit of a mesh file, guessed from the usual sizes of sheet-metal parts."""

from __future__ import annotations

from typing import Any

from .words import either

AS_GIVEN = "as given"
"""Reason for a unit that the user named."""

UNITS = {"mm": 1.0, "cm": 10.0, "inch": 25.4, "foot": 304.8, "m": 1000.0}

# Usual sizes of sheet-metal parts, mm. Most files are in mm, so the ranges for mm are wider.
_SIZES, _SIZES_IN_MM = (15.0, 4000.0), (10.0, 1e5)
_THICKNESSES, _THICKNESSES_IN_MM = (0.45, 6.5), (0.3, 20.0)
# Thicker sheets can be frames or plates if mm is not plausible.
_THICKEST = 40.0
# Without a thickness, smaller parts could also be in inches.
_LARGE = 80.0


def unit_of(size: float, thickness: float | None, given: str | None = None) -> dict[str, Any]:
    """Return the unit of a part for the diagnosis: guess, scale, reason, plausible, is_certain.

    The size is the diagonal and the thickness that of the sheet, both in the unit of the file. If
    the user gave a unit, it is used. The guess is "unknown" with scale 1 if several units are
    plausible and none of them is mm. The unit is certain if it is the only plausible one, if only
    this one gives a standard gauge, or if a part without thickness has a usual size in mm.
    """
    if given is not None:
        return _unit(given, AS_GIVEN, [given], True)
    if not size > 0.0:
        return _unit("mm", "it has no extent", ["mm"], True)
    plausible = [name for name in UNITS if _is_plausible(name, size, thickness)]
    usual = [name for name in plausible if thickness and _is_gauge(UNITS[name] * thickness)]
    if "mm" not in plausible:
        plausible = [name for name in UNITS if _is_plausible(name, size, thickness, _THICKEST)]
    if not plausible:
        return _unit("mm", "no unit makes it a usual sheet-metal part", ["mm"], True)
    sizes = either([f"{name} ({_described(name, size, thickness)})" for name in plausible])
    if len(plausible) == 1 or len(usual) == 1:
        (name,) = plausible if len(plausible) == 1 else usual
        reason = f"{_described(name, size, thickness)} is usual for a sheet-metal part"
        if name != "mm":
            reason += f", {_described('mm', size, thickness)} is not"
        others = [other for other in plausible if other != name]
        if others and name != "mm":
            reason += f"; if the unit is {either(others)}, give another scale"
        return _unit(name, reason, plausible, True)
    is_certain = "mm" in plausible and thickness is None and size >= _LARGE
    reason = f"{size:.4g} mm is a usual size" if is_certain else f"it may be {sizes}"
    return _unit("mm" if "mm" in plausible else "unknown", reason, plausible, is_certain)


def _unit(guess: str, reason: str, plausible: list[str], is_certain: bool) -> dict[str, Any]:
    scale = UNITS.get(guess, 1.0)
    found = {"guess": guess, "scale": scale, "reason": reason}
    return {**found, "plausible": plausible, "is_certain": is_certain}


def _is_plausible(
    name: str, size: float, thickness: float | None, thickest: float = _THICKNESSES[1]
) -> bool:
    is_mm, scale = name == "mm", UNITS[name]
    low, high = _SIZES_IN_MM if is_mm else _SIZES
    if not low <= scale * size <= high:
        return False
    thin, thick = _THICKNESSES_IN_MM if is_mm else (_THICKNESSES[0], thickest)
    return not thickness or thin <= scale * thickness <= thick


def _is_gauge(thickness: float) -> bool:
    """Return whether a thickness in mm is a multiple of 0.05 mm, 0.005 inch or 1/64 inch."""
    steps = (thickness / step for step in (0.05, 0.005 * 25.4, 25.4 / 64.0))
    return any(abs(number - round(number)) < 1e-4 * number for number in steps)


def _described(name: str, size: float, thickness: float | None) -> str:
    scale = UNITS[name]
    thick = f"{scale * thickness:.3g} mm thick and " if thickness else ""
    return f"{thick}{scale * size:.4g} mm large"

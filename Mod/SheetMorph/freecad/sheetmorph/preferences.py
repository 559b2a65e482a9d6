# SPDX-License-Identifier: LGPL-2.1-or-later
"""The user's preferences in FreeCAD, which the preferences page changes too."""

from __future__ import annotations

import FreeCAD

PATH = "User parameter:BaseApp/Preferences/Mod/SheetMorph"

DEFAULTS: dict[str, bool | int | float] = {
    "UpdateResults": 0,
    "Snap": False,
    "SnapPoints": False,
    "SnapLength": 1.0,
    "SnapAngle": 5.0,
    "LocalAxes": False,
    "ShowArrows": True,
    "CreaseAngle": 30.0,
    "HoleRings": 0,
    "BrushRadius": 25,
    "ShowOriginal": False,
    "ShowFeatures": False,
    "ShowControlMeshes": False,
    "ShowColours": 0,
    "OpenPivot": False,
    "OpenMouse": False,
    "OpenShow": False,
    "OpenTolerances": False,
    "OpenSelector": False,
}
"""Entries with their default values, in mm and degrees."""


def get(entry: str):
    """Return the value of an entry of DEFAULTS, of the type of its default."""
    default, group = DEFAULTS[entry], FreeCAD.ParamGet(PATH)
    if isinstance(default, bool):
        return group.GetBool(entry, default)
    return group.GetInt(entry, default) if isinstance(default, int) else _number(group, entry)


def get_colour(entry: str, default: tuple[float, float, float]) -> tuple[float, float, float]:
    """Return a colour with components 0 to 1, which FreeCAD stores as 0xRRGGBBAA."""
    packed = FreeCAD.ParamGet(PATH).GetUnsigned(entry, packed_colour(default))
    if packed == packed_colour(default):
        return default
    return tuple((packed >> shift & 255) / 255.0 for shift in (24, 16, 8))


def packed_colour(colour: tuple[float, float, float]) -> int:
    """Return an opaque colour in FreeCAD's storage format."""
    red, green, blue = (round(255 * c) for c in colour)
    return red << 24 | green << 16 | blue << 8 | 255


def put(entry: str, value) -> None:
    """Store the value of an entry of DEFAULTS."""
    default, group = DEFAULTS[entry], FreeCAD.ParamGet(PATH)
    if isinstance(default, bool):
        group.SetBool(entry, bool(value))
    elif isinstance(default, int):
        group.SetInt(entry, int(value))
    else:
        group.SetFloat(entry, float(value))


def _number(group, entry: str) -> float:
    return group.GetFloat(entry, DEFAULTS[entry])


def reset() -> None:
    """Restore all default values."""
    for entry, default in DEFAULTS.items():
        put(entry, default)

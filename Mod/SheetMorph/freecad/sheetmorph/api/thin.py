# SPDX-License-Identifier: LGPL-2.1-or-later
"""Thin solids: closed meshes of sheets, with two skins and walls between them."""

from __future__ import annotations

from typing import Any

import FreeCAD

from freecad.sheetmorph.bridge import kernel
from freecad.sheetmorph.api.checks import number, require_kind, require_part_of
from freecad.sheetmorph.api.regions import add_feature
from freecad.sheetmorph.objects import model
from freecad.sheetmorph.objects.part import THIN_AUTOMATIC, THIN_GIVEN, THIN_NO
from freecad.sheetmorph.bridge.rest import read_rest
from freecad.sheetmorph.objects.properties import number_of


def set_thin(part, thin: str | bool | float) -> None:
    """Set whether a part is solved as a thin solid: False, "auto", or its thickness in mm.

    With "auto", the part counts as one if it is recognised. With a thickness, the recompute reports
    why the part is not one. A thin solid bends as one sheet and keeps its thickness.
    Raises ValueError for an invalid value.
    """
    require_kind(part, model.PART, "part")
    if thin is False:
        part.Thin = THIN_NO
    elif thin == "auto":
        part.Thin = THIN_AUTOMATIC
    elif isinstance(thin, (bool, str)):
        raise ValueError(f'Thin cannot be "{thin}"; pass "auto", False or a thickness.')
    else:
        thickness = number(thin, "thickness")
        if thickness <= 0.0:
            raise ValueError(f"The thickness is {thickness} mm; pass one above 0.")
        part.Thin = THIN_GIVEN
        part.Thickness = thickness


def set_sheet(part, thickness: float = 0.0, poisson: float = 0.3) -> None:
    """Set the properties of a part for the energy steel: thickness in mm, and Poisson's ratio.

    Thickness 0 uses that of the deck's shells or the thin solid, or a hundredth of the size. Raises
    ValueError.
    """
    require_kind(part, model.PART, "part")
    thickness, poisson = number(thickness, "thickness"), number(poisson, "Poisson's ratio")
    if thickness < 0.0:
        raise ValueError(f"The thickness is {thickness} mm; pass 0 or more.")
    if not 0.0 <= poisson <= 0.49:
        raise ValueError(f"Poisson's ratio is {poisson}; pass one from 0 to 0.49.")
    part.SheetThickness, part.Poisson = thickness, poisson


def thin_solid(part) -> tuple[Any, str]:
    """Examine a part at rest: return its `sheetmorph._core.ThinSolid` and an empty text.

    If it is not a thin solid, return None and a sentence with the reason. The document does not
    change.
    """
    require_kind(part, model.PART, "part")
    rest = read_rest(part)
    core = kernel.core()
    thickness = number_of(part, "Thickness") if part.Thin == THIN_GIVEN else 0.0
    return core.find_thin_solid(core.TriangleMesh(rest.points, rest.triangles), thickness)


def propose_thin(part) -> bool:
    """Make a part a thin solid if it is recognised, print this, and return whether it is."""
    solid, _ = thin_solid(part)
    if solid is None:
        return False
    set_thin(part, "auto")
    FreeCAD.Console.PrintMessage(
        f"SheetMorph: '{part.Label}' is a sheet {solid.thickness:.3g} mm thick, "
        "so its two skins bend together. Set its property Thin to switch this "
        "off.\n"
    )
    return True


def add_through_holes(assembly, part, label: str = "Hole") -> list:
    """Mark every hole through both skins of a part as a form feature; return the regions.

    Holes whose vertices all belong to one existing region are left out. Raises ValueError if the
    part is not a thin solid.
    """
    require_part_of(assembly, part)
    solid, reason = thin_solid(part)
    if solid is None:
        raise ValueError(f"'{part.Label}' is not a thin solid: {reason}.")
    marked = [set(model.vertices(region).tolist()) for region in model.regions(assembly, part)]
    return [
        add_feature(assembly, part, hole.vertices.tolist(), label)
        for hole in solid.holes
        if not any(own.issuperset(hole.vertices.tolist()) for own in marked)
    ]

# SPDX-License-Identifier: LGPL-2.1-or-later
"""What a command acts on: the morph, part or region that is selected, or the only one there is."""

import FreeCAD as App
import FreeCADGui as Gui

from freecad.sheetmorph.kinds import ASSEMBLY, PART, POSE, REGION

__all__ = ["ASSEMBLY", "PART", "POSE", "REGION"]


def kind(obj) -> str:
    """The type of one of our objects, else an empty string."""
    return str(getattr(getattr(obj, "Proxy", None), "Type", ""))


def selected(wanted: str = "") -> list:
    """Selected objects of the active document, those of one type of ours if ``wanted``."""
    if App.ActiveDocument is None:
        return []
    objects = Gui.Selection.getSelection(App.ActiveDocument.Name)
    return [obj for obj in objects if not wanted or kind(obj) == wanted]


def meshes() -> list:
    """Selected meshes that are no results of a morph."""
    return [o for o in selected() if o.isDerivedFrom("Mesh::Feature") and kind(o) != PART]


def shapes() -> list:
    """Selected objects with a shape that has faces."""
    return [o for o in selected() if o.isDerivedFrom("Part::Feature") and o.Shape.Faces]


def all_of(wanted: str) -> list:
    """Every object of one type of ours in the active document."""
    if App.ActiveDocument is None:
        return []
    return [obj for obj in App.ActiveDocument.Objects if kind(obj) == wanted]


def assembly_of(obj):
    """The morph an object of ours belongs to, or None."""
    if kind(obj) == ASSEMBLY:
        return obj
    for parent in obj.InListRecursive:
        if kind(parent) == ASSEMBLY:
            return parent
    return None


def assembly():
    """The morph of the selection, else the only one of the document, else None."""
    for obj in selected():
        owner = assembly_of(obj)
        if owner is not None:
            return owner
    found = all_of(ASSEMBLY)
    return found[0] if len(found) == 1 else None


def parts(owner) -> list:
    """The parts of a morph."""
    return [obj for obj in owner.Group if kind(obj) == PART]


def regions(owner, role: str = "") -> list:
    """The regions of a morph, those of one role if given, in the order of the document."""
    mine = [o for o in owner.Document.Objects if kind(o) == REGION and assembly_of(o) == owner]
    return [obj for obj in mine if not role or obj.Role == role]


def poses(owner) -> list:
    """The poses of a morph."""
    return [obj for obj in owner.Group if kind(obj) == POSE]


def part():
    """The selected part, else the part of the selected region, else the primary of the morph."""
    for obj in selected():
        if kind(obj) == PART:
            return obj
        if kind(obj) == REGION:
            return obj.Part
    owner = assembly()
    if owner is None:
        return None
    found = parts(owner)
    return owner.Primary or (found[0] if found else None)


def handle():
    """The selected handle, else the first handle of the morph, else None."""
    for obj in selected(REGION):
        if obj.Role == "handle":
            return obj
    owner = assembly()
    found = regions(owner, "handle") if owner else []
    return found[0] if found else None

# SPDX-License-Identifier: LGPL-2.1-or-later
"""The target of a command: the selected morph, part or region, or the only one."""

from itertools import islice

import FreeCAD as App
import FreeCADGui as Gui

from freecad.sheetmorph.kinds import ASSEMBLY, PART, POSE, REGION, STUDY, kind
from freecad.sheetmorph.objects import model, watcher

_listed: dict[str, list] = {"objects": [], "groups": []}  # of the last document

__all__ = ["ASSEMBLY", "PART", "POSE", "REGION", "STUDY", "kind"]


def selected(wanted: str = "") -> list:
    """Return the selected objects of the active document, of one type if `wanted` is given."""
    if App.ActiveDocument is None or (wanted and not assemblies()):
        return []
    objects = Gui.Selection.getSelection(App.ActiveDocument.Name)
    return [obj for obj in objects if not wanted or kind(obj) == wanted]


def meshes() -> list:
    """Return the selected meshes that are not results of a morph."""
    return [o for o in selected() if o.isDerivedFrom("Mesh::Feature") and kind(o) != PART]


def shapes() -> list:
    """Return the selected objects with a shape that has faces."""
    return [o for o in selected() if o.isDerivedFrom("Part::Feature") and o.Shape.Faces]


def links() -> list:
    """Return the selected links (App::Link), which are refused with an explanation."""
    return [o for o in selected() if o.TypeId.startswith("App::Link")]


def may_become_parts() -> bool:
    """Return whether a mesh, a link or an object that may have a shape is selected.

    Shapes are not accessed, since FreeCAD 1.0 needs half a second to return one with 12,000 faces.
    """
    shaped = (o for o in selected() if o.isDerivedFrom("Part::Feature"))
    return bool(meshes() or links() or next(shaped, None))


def assemblies() -> list:
    """Return the morphs of the active document; FreeCAD calls this often.

    No document is searched before the first morph exists. A search takes eight times as long as
    listing the objects, so it is repeated only when the list has changed.
    """
    if not watcher.is_watching() or App.ActiveDocument is None:
        return []
    every = App.ActiveDocument.Objects
    if every != _listed["objects"]:
        groups = App.ActiveDocument.findObjects("App::DocumentObjectGroupPython")
        _listed.update(objects=every, groups=groups)
    return [group for group in _listed["groups"] if kind(group) == ASSEMBLY]


def assembly_of(obj):
    """Return the morph of a SheetMorph object or of a part's mesh, or None."""
    if kind(obj):
        return model.assembly_of(obj)
    users = (user for user in obj.InList if kind(user) == PART)
    return next(filter(None, map(model.assembly_of, users)), None)


def assembly():
    """Return the morph of the selection, else the only one of the document, else None."""
    found = assemblies()
    if len(found) < 2:
        return found[0] if found else None
    return next(filter(None, map(assembly_of, selected())), None)


def parts(owner) -> list:
    """Return the parts of a morph."""
    return model.parts(owner)


def regions(owner, role: str = "") -> list:
    """Return the regions of a morph, of one role if given, in the order of its group."""
    return [region for region in model.regions(owner) if not role or region.Role == role]


def poses(owner) -> list:
    """Return the poses of a morph."""
    return model.poses(owner)


def part():
    """Return the selected part, else that of the selected region, else the primary of the morph."""
    for obj in selected() if assemblies() else ():
        if kind(obj) == PART:
            return obj
        if kind(obj) == REGION:
            return obj.Part
    owner = assembly()
    if owner is None:
        return None
    return owner.Primary or next(members(owner, PART), None)


def chosen_parts() -> list | None:
    """Return the selected parts of the morph, None (for all) without any."""
    mine = [chosen for chosen in selected(PART) if model.assembly_of(chosen) == assembly()]
    return mine or None


def handle():
    """Return the selected handle, else the first handle of the morph, else None."""
    for obj in selected(REGION):
        if obj.Role == "handle":
            return obj
    owner = assembly()
    every = members(owner, REGION) if owner else ()
    return next((region for region in every if region.Role == "handle"), None)


def has(wanted: str, least: int = 1) -> bool:
    """Return whether the morph has at least `least` objects of one type."""
    owner = assembly()
    return owner is not None and len(list(islice(members(owner, wanted), least))) == least


def members(owner, wanted: str):
    """Yield the objects of one type in a morph, so that a caller can stop at the first."""
    return (obj for obj in owner.Group if kind(obj) == wanted)

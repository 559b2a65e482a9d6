# SPDX-License-Identifier: LGPL-2.1-or-later
"""What a command acts on: the morph, part or region that is selected, or the only one there is."""

from itertools import islice

import FreeCAD as App
import FreeCADGui as Gui

from freecad.sheetmorph.kinds import ASSEMBLY, PART, POSE, REGION, STUDY, kind
from freecad.sheetmorph.objects import model, watcher

_listed: dict[str, list] = {"objects": [], "groups": []}  # of the document asked about last

__all__ = ["ASSEMBLY", "PART", "POSE", "REGION", "STUDY", "kind"]


def selected(wanted: str = "") -> list:
    """Selected objects of the active document, those of one type of ours if ``wanted``."""
    if App.ActiveDocument is None or (wanted and not assemblies()):
        return []
    objects = Gui.Selection.getSelection(App.ActiveDocument.Name)
    return [obj for obj in objects if not wanted or kind(obj) == wanted]


def meshes() -> list:
    """Selected meshes that are no results of a morph."""
    return [o for o in selected() if o.isDerivedFrom("Mesh::Feature") and kind(o) != PART]


def shapes() -> list:
    """Selected objects with a shape that has faces."""
    return [o for o in selected() if o.isDerivedFrom("Part::Feature") and o.Shape.Faces]


def links() -> list:
    """Selected links (App::Link), which are refused in words."""
    return [o for o in selected() if o.TypeId.startswith("App::Link")]


def may_become_parts() -> bool:
    """Whether a mesh, a link or what may have a shape is selected. Shapes themselves are not looked
    at: FreeCAD 1.0 takes half a second to hand out one of 12,000 faces."""
    shaped = (o for o in selected() if o.isDerivedFrom("Part::Feature"))
    return bool(meshes() or links() or next(shaped, None))


def assemblies() -> list:
    """The morphs of the active document; FreeCAD asks for them all the time.

    Before there was a morph no document is looked at. Looking through one takes FreeCAD eight times
    as long as listing it, so it is looked through again only when the list is another.
    """
    if not watcher.is_watching() or App.ActiveDocument is None:
        return []
    every = App.ActiveDocument.Objects
    if every != _listed["objects"]:
        groups = App.ActiveDocument.findObjects("App::DocumentObjectGroupPython")
        _listed.update(objects=every, groups=groups)
    return [group for group in _listed["groups"] if kind(group) == ASSEMBLY]


def assembly_of(obj):
    """The morph an object of ours, or the mesh of one of its parts, belongs to, or None."""
    if kind(obj):
        return model.assembly_of(obj)
    users = (user for user in obj.InList if kind(user) == PART)
    return next(filter(None, map(model.assembly_of, users)), None)


def assembly():
    """The morph of the selection, else the only one of the document, else None."""
    found = assemblies()
    if len(found) < 2:
        return found[0] if found else None
    return next(filter(None, map(assembly_of, selected())), None)


def parts(owner) -> list:
    """The parts of a morph."""
    return model.parts(owner)


def regions(owner, role: str = "") -> list:
    """The regions of a morph, those of one role if given, in the order of its group."""
    return [region for region in model.regions(owner) if not role or region.Role == role]


def poses(owner) -> list:
    """The poses of a morph."""
    return model.poses(owner)


def part():
    """The selected part, else the part of the selected region, else the primary of the morph."""
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
    """The selected parts of the morph, None for all if there is none."""
    mine = [chosen for chosen in selected(PART) if model.assembly_of(chosen) == assembly()]
    return mine or None


def handle():
    """The selected handle, else the first handle of the morph, else None."""
    for obj in selected(REGION):
        if obj.Role == "handle":
            return obj
    owner = assembly()
    every = members(owner, REGION) if owner else ()
    return next((region for region in every if region.Role == "handle"), None)


def has(wanted: str, least: int = 1) -> bool:
    """Whether the morph that is meant has so many objects of one type."""
    owner = assembly()
    return owner is not None and len(list(islice(members(owner, wanted), least))) == least


def members(owner, wanted: str):
    """What a morph has of one type, one after the other: who needs the first asks for no more."""
    return (obj for obj in owner.Group if kind(obj) == wanted)

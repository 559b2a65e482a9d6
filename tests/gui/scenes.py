# SPDX-License-Identifier: LGPL-2.1-or-later
"""Documents that tests start from, and what is in them."""

import os
from contextlib import contextmanager

import FreeCAD as App
import FreeCADGui as Gui
import numpy as np
from desk import WORK, activate, settled, view
from freecad.sheetmorph import api
from freecad.sheetmorph.bridge import conversion
from freecad.sheetmorph.interaction import finishing
from freecad.sheetmorph.objects import model
from freecad.sheetmorph.scene import nodes
from shapes import sheet, strip, write_ply


def new_document():
    """A document with the sheet in it as a mesh, imported as FreeCAD itself records it."""
    path = os.path.join(WORK, "sheet.ply")
    write_ply(path)
    yield from activate()
    Gui.doCommand("import FreeCAD as App, Mesh")
    Gui.doCommand("App.newDocument('Sheet')")
    Gui.doCommand(f"Mesh.insert({path!r}, 'Sheet')")
    yield from settled()
    look()


@contextmanager
def patience():
    """In this context OK waits long enough for a small shape on a loaded machine, so that a fault
    always appears in the panel."""
    before, finishing.PATIENCE = finishing.PATIENCE, 20.0
    try:
        yield
    finally:
        finishing.PATIENCE = before


def fit() -> None:
    """Fits the document into the view. Since FreeCAD 1.0 panels lie over the view, so leaves
    room for them."""
    Gui.SendMsgToActiveView("ViewFit")
    if int(App.Version()[0]) >= 1:
        camera = view().getCameraNode()
        camera.height = 1.5 * camera.height.getValue()


def look() -> None:
    """The whole sheet from above in front, at once."""
    view().viewIsometric()
    Gui.SendMsgToActiveView("ViewFit")


def new_morph(moved=None):
    """The sheet as a morph: fixed at x = 0, handle at x = 120, both holes form features."""
    yield from new_document()
    document = App.ActiveDocument
    if moved is not None:
        moved(document)
    assembly = api.create_assembly(document)
    part = api.add_part(assembly, document.getObject("sheet"))
    points, _ = sheet()
    api.add_fixed(assembly, part, np.flatnonzero((points[:, 0] == 0) & (points[:, 2] > 0)).tolist())
    api.add_handle(assembly, part, handle_vertices())
    for rim in api.hole_rims(part):
        api.add_feature(assembly, part, rim)
    document.recompute()
    document.clearUndos()
    look()
    yield from settled()


def new_assembly(is_joined: bool = False):
    """The morph, a bracket on it that sticks out beyond y = 60, and a part farther out.

    ``is_joined``: with a contact between sheet and bracket.
    """
    yield from new_morph()
    document, morph = App.ActiveDocument, assembly()
    yield from add_bracket()
    insert("loose", strip(113.0, 40.0))
    for name in ("bracket", "loose"):
        api.add_part(morph, document.getObject(name))
    if is_joined:
        sheet_part, bracket = part(), labelled("bracket")
        sides = zip((sheet_part, bracket), api.touching_vertices(sheet_part, bracket, 1.5))
        api.add_contact(morph, *sides)
    document.recompute()
    document.clearUndos()
    look()
    yield from settled()


def add_bracket():
    """The bracket as a mesh in the active document."""
    insert("bracket", strip(45.0, 65.0))
    yield from settled()


def insert(name: str, shape) -> None:
    """Imports a shape as FreeCAD itself records it."""
    path = os.path.join(WORK, f"{name}.ply")
    write_ply(path, shape)
    Gui.doCommand(f"Mesh.insert({path!r}, {App.ActiveDocument.Name!r})")


def labelled(label: str):
    """The part of the active document with a label like this."""
    return next(p for p in model.parts(assembly()) if p.Label.startswith(label))


def contacts() -> list:
    """The contacts of the morph."""
    return model.contacts(assembly())


def handle_vertices() -> list[int]:
    """The flange at x = 120 without its fold."""
    points, _ = sheet()
    return np.flatnonzero((points[:, 0] == 120) & (points[:, 2] > 0)).tolist()


def assembly():
    """The morph of the active document."""
    return next(o for o in App.ActiveDocument.Objects if model.kind(o) == model.ASSEMBLY)


def part():
    """Its only part."""
    return model.parts(assembly())[0]


def regions(role: str) -> list:
    """Its regions of a role."""
    return [region for region in model.regions(assembly()) if region.Role == role]


def stored(which=None) -> np.ndarray:
    """The local positions (n, 3) that the result mesh of a part, else of the first, holds."""
    return np.array(conversion.read_mesh((which or part()).Mesh)[0])


def stored_of_all() -> np.ndarray:
    """The same of all parts, one after the other."""
    return np.concatenate([stored(each) for each in model.parts(assembly())])


def drawn(which=None) -> np.ndarray:
    """The local positions (n, 3) that are in the Coin nodes of a part, else of the first."""
    return nodes.positions((which or part()).ViewObject)


def largest(difference: np.ndarray) -> float:
    """The largest distance of a row from zero."""
    return float(np.linalg.norm(difference, axis=1).max())

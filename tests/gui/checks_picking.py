# SPDX-License-Identifier: LGPL-2.1-or-later
"""Regions are picked with the mouse, where they are seen."""

import FreeCAD as App
import FreeCADGui as Gui
import numpy as np
from desk import child, click_point, picture, press, press_tool, settled, until, xdotool
from freecad.sheetmorph import api
from freecad.sheetmorph.bridge import conversion
from freecad.sheetmorph.objects import model
from scenes import assembly, new_document, part, regions
from shapes import HOLES, sheet

__all__ = [
    "test_faces_and_hole_rims_are_picked_by_mouse",
    "test_modifiers_add_and_remove_and_undo_pick_takes_back",
    "test_escape_cancels_picking_and_changes_nothing",
    "test_a_part_in_a_moved_container_is_picked_where_it_is_seen",
]


def flange(x: float) -> list[int]:
    """The vertices of a flange, its fold included."""
    points, triangles = sheet()
    on_it = points[:, 0] == x
    return np.unique(triangles[on_it[triangles].all(axis=1)]).tolist()


def start_morph(names=("sheet",)):
    """A morph made from selected meshes by the toolbar."""
    before = len(App.ActiveDocument.Objects)
    for name in names:
        Gui.Selection.addSelection(App.ActiveDocument.getObject(name))
    yield from settled()
    yield from press_tool("Create Morph")
    yield from until(lambda: len(App.ActiveDocument.Objects) > before, "the morph")
    yield from settled()


def test_faces_and_hole_rims_are_picked_by_mouse():
    yield from new_document()
    yield from start_morph()
    yield from press_tool("Mark Fixed Region…")
    view_from(0.0)
    yield from settled()
    yield from click_point((0, 30, 10))
    picture("picking-fixed")
    assert "nothing" not in child("count").text()
    yield from press("OK")
    view_from(120.0)
    yield from press_tool("Mark Handle…")
    yield from click_point((120, 30, 10))
    yield from press("OK")
    assert model.vertices(regions("fixed")[0]).tolist() == flange(0.0)
    assert model.vertices(regions("handle")[0]).tolist() == flange(120.0)
    Gui.activeDocument().activeView().viewTop()
    Gui.SendMsgToActiveView("ViewFit")
    yield from press_tool("Mark Form Features…")
    for (x, y, radius), key in zip(HOLES, ("", "shift")):
        yield from click_point((x, y + radius + 1.5, 0), key)
    picture("picking-rims")
    yield from press("OK")
    wanted = sorted(api.hole_rims(part()))
    assert sorted(model.vertices(r).tolist() for r in regions("form feature")) == wanted
    assert "Invalid" not in part().State


def test_modifiers_add_and_remove_and_undo_pick_takes_back():
    yield from new_document()
    yield from start_morph()
    yield from press_tool("Mark Fixed Region…")
    child("facet").click()
    first, second = (20.5, 12.0, 0), (60.5, 12.0, 0)
    yield from click_point(first)
    assert "3 vertices, 1 piece" in child("count").text(), child("count").text()
    yield from click_point(second, "shift")
    assert "6 vertices, 2 piece" in child("count").text()
    yield from click_point(first, "ctrl")
    assert "3 vertices, 1 piece" in child("count").text()
    child("back").click()
    assert "6 vertices, 2 piece" in child("count").text()
    yield from press("Cancel")
    assert regions("fixed") == []


def test_escape_cancels_picking_and_changes_nothing():
    yield from new_document()
    yield from start_morph()
    before = App.ActiveDocument.UndoNames
    yield from press_tool("Mark Handle…")
    yield from click_point((20.5, 12.0, 0))
    yield from xdotool("key", "Escape")
    yield from until(lambda: not Gui.Control.activeDialog(), "the panel to close")
    assert model.regions(assembly()) == []
    assert App.ActiveDocument.UndoNames == before
    assert not Gui.Selection.getSelection() or regions("handle") == []


def test_a_part_in_a_moved_container_is_picked_where_it_is_seen():
    yield from new_document()
    document = App.ActiveDocument
    source = document.getObject("sheet")
    box = document.addObject("App::Part", "Box")
    box.addObject(source)
    box.Placement = App.Placement(App.Vector(300, -50, 80), App.Rotation(App.Vector(1, 2, 3), 50))
    source.Placement = App.Placement(App.Vector(5, 6, 7), App.Rotation(App.Vector(0, 0, 1), 90))
    document.recompute()
    yield from start_morph()
    Gui.SendMsgToActiveView("ViewFit")
    seen = source.getGlobalPlacement()
    normal = seen.Rotation.multVec(App.Vector(0, 0, 1))
    Gui.activeDocument().activeView().setViewDirection(tuple(-normal))
    Gui.SendMsgToActiveView("ViewFit")
    yield from settled()
    yield from press_tool("Mark Form Features…")
    x, y, radius = HOLES[1]
    yield from click_point(seen.multVec(App.Vector(x, y + radius + 1.5, 0)))
    picture("picking-moved-container")
    yield from press("OK")
    rim = model.vertices(regions("form feature")[0])
    local = conversion.read_mesh(source.Mesh)[0][rim]
    assert np.allclose(np.linalg.norm(local[:, :2] - (x, y), axis=1), radius, atol=1e-4)


def view_from(x: float) -> None:
    """Looks along +x or -x, a little from above, so that the flange at ``x`` is in front."""
    direction = (1.0, 0.3, -0.5) if x == 0.0 else (-1.0, 0.3, -0.5)
    Gui.activeDocument().activeView().setViewDirection(direction)
    Gui.SendMsgToActiveView("ViewFit")

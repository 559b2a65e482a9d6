# SPDX-License-Identifier: LGPL-2.1-or-later
"""A closed plate is taken as the thin solid it is, and its thickness shows as colours."""

import FreeCAD as App
import FreeCADGui as Gui
import MeshPart
import Part
from desk import activate, child, picture, press, press_tool, report_view, settled, tick
from freecad.sheetmorph import api
from freecad.sheetmorph.scene import value_map
from pivy import coin
from scenes import part, regions

__all__ = ["test_a_closed_plate_shows_its_thickness_and_its_holes_become_features"]


def thin_plate():
    """A morph of a plate of 160 x 80 x 2 mm with two holes and a boss, made with the toolbar."""
    yield from activate()
    document = App.newDocument("Thin")
    shape = Part.makeBox(160, 80, 2)
    for x in (35, 125):
        shape = shape.cut(Part.makeCylinder(10, 2, App.Vector(x, 40, 0)))
    shape = shape.fuse(Part.makeCylinder(12, 14, App.Vector(80, 40, 2))).removeSplitter()
    source = document.addObject("Mesh::Feature", "Plate")
    source.Mesh = MeshPart.meshFromShape(Shape=shape, MaxLength=4.0)
    document.recompute()
    Gui.Selection.clearSelection()
    Gui.Selection.addSelection(source)
    yield from settled()
    yield from press_tool("Create Morph")
    Gui.SendMsgToActiveView("ViewFit")
    yield from settled()


def is_drawn() -> bool:
    """Whether a map of values is in the view."""
    return coin.SoNode.getByName(value_map.NAME) is not None


def test_a_closed_plate_shows_its_thickness_and_its_holes_become_features():
    yield from thin_plate()
    assert part().Thin == "automatic"
    assert "is a sheet 2 mm thick" in report_view()
    yield from press_tool("Thickness…")
    assert is_drawn()
    shown = child("message").text()
    assert "<b>2 mm</b>" in shown and "skins: 2" in shown and "rigid): 1" in shown
    picture("thickness")
    yield from press("Mark Holes as Form Features")
    holes = regions("form feature")
    solid, _ = api.thin_solid(part())
    assert [api.vertices(h) for h in holes] == [h.vertices.tolist() for h in solid.holes]
    yield from tick(child("bend"))
    assert part().Thin == "no"
    yield from press("Close")
    assert not is_drawn()
    App.ActiveDocument.undo()
    assert part().Thin == "automatic"

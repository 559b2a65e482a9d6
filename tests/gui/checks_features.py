# SPDX-License-Identifier: LGPL-2.1-or-later
"""What form features may do is said in their panel, and by commands on the selection."""

import FreeCAD as App
import FreeCADGui as Gui
import numpy as np
from PySide import QtCore
from desk import child, choose_below, enter, picture, press, press_tool, settled, tick, until
from freecad.sheetmorph import api
from freecad.sheetmorph.objects import model
from scenes import assembly, drawn, largest, new_morph, part, patience, regions

__all__ = [
    "test_motion_and_size_are_set_in_the_panel_as_one_undo_step",
    "test_a_size_that_is_too_large_is_told_and_the_panel_stays",
    "test_selected_form_features_are_related_by_a_command",
    "test_the_panel_relates_a_form_feature_to_others",
]


def select(*objects):
    """Selects objects as in the tree, and waits until the buttons know."""
    Gui.Selection.clearSelection()
    for obj in objects:
        Gui.Selection.addSelection(obj)
    yield from settled()


def diameter(feature) -> float:
    """The diameter of a round hole in the deformed part."""
    rim = api.deform(assembly())[part().Name][api.vertices(feature)]
    return 2.0 * float(np.linalg.norm(rim - rim.mean(axis=0), axis=1).mean())


def test_motion_and_size_are_set_in_the_panel_as_one_undo_step():
    yield from new_morph()
    hole = regions("form feature")[0]
    before = diameter(hole)
    yield from select(hole)
    yield from press_tool("Form Feature Settings…")
    assert hole.Label in child("part").text()
    assert child("size_text").text().startswith("Hole, diameter")
    assert not child("direction_x").isVisible() and not child("feature_size").isEnabled()
    yield from choose_below(child("motion"), 4)
    assert child("direction_z").isVisible() and not child("point_x").isVisible()
    yield from tick(child("has_size"))
    seen = drawn().copy()
    yield from enter(child("feature_size"), "24 mm")
    yield from until(lambda: largest(drawn() - seen) > 1.0, "the view to show the size")
    assert hole.Size.Value == 0.0
    picture("feature")
    yield from press("OK")
    assert (hole.Motion, tuple(hole.MotionDirection)) == ("line", (0.0, 0.0, 1.0))
    assert abs(diameter(hole) - 24.0) < 1e-9 < abs(before - 24.0)
    assert App.ActiveDocument.UndoNames == ["Form Feature"]
    App.ActiveDocument.undo()
    assert (hole.Motion, hole.Size.Value) == ("free", 0.0)


def test_a_size_that_is_too_large_is_told_and_the_panel_stays():
    yield from new_morph()
    hole = regions("form feature")[0]
    yield from select(hole)
    yield from press_tool("Form Feature Settings…")
    yield from tick(child("has_size"))
    yield from enter(child("feature_size"), "900 mm")
    with patience():
        yield from press("OK")
        yield from until(lambda: "largest" in child("message").text(), "the message")
    yield from press("Cancel")
    assert hole.Size.Value == 0.0


def test_selected_form_features_are_related_by_a_command():
    yield from new_morph()
    holes = regions("form feature")
    yield from select(holes[0])
    assert not Gui.Command.get("SheetMorph_KeepDistance").isActive()
    yield from select(*holes[:2])
    yield from press_tool("Keep Distance")
    (relation,) = model.relations(assembly())
    assert relation.Type == "distance" and relation.Features == holes[:2]
    assert App.ActiveDocument.UndoNames == ["Keep Distance"]
    App.ActiveDocument.undo()
    assert model.relations(assembly()) == []


def test_the_panel_relates_a_form_feature_to_others():
    yield from new_morph()
    holes = regions("form feature")
    yield from select(holes[0])
    yield from press_tool("Form Feature Settings…")
    assert not child("others").isVisible()
    yield from choose_below(child("relation"), 1)
    yield from press("OK")
    assert "Tick" in child("message").text()
    child("others").item(0).setCheckState(QtCore.Qt.Checked)
    picture("feature-relation")
    yield from press("OK")
    (relation,) = model.relations(assembly())
    assert relation.Type == "group" and relation.Features == holes[:2]

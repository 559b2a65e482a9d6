# SPDX-License-Identifier: LGPL-2.1-or-later
"""Handles are moved in the panel; view and document follow, undo and Cancel are exact."""

import os

import FreeCAD as App
import FreeCADGui as Gui
import numpy as np
from desk import WORK, child, enter, on_screen, picture, press, press_tool, settled, until, xdotool
from hostile_acts import with_step
from scenes import drawn, handle_vertices, largest, new_morph, part, regions, stored
from shapes import sheet

__all__ = [
    "test_a_typed_length_with_unit_moves_mesh_and_view",
    "test_cancel_takes_everything_back_to_the_bit",
    "test_undo_and_redo_are_exact",
    "test_a_saved_document_is_opened_and_moved_again",
    "test_what_is_wrong_is_said_beside_its_cause",
    "test_the_arrows_in_the_view_drag_the_handle",
    "test_another_command_in_between_does_not_end_the_transaction",
    "test_a_field_that_an_expression_drives_is_locked_and_followed",
    "test_a_part_that_is_put_elsewhere_under_the_panel_is_followed",
]


def lifted(before: np.ndarray, after: np.ndarray) -> np.ndarray:
    """How the handle moved, (k, 3) mm."""
    return (after - before)[handle_vertices()]


def open_panel():
    yield from press_tool("Move Handle…")
    yield from until(Gui.Control.activeDialog, "the panel")
    yield from settled()


def test_a_typed_length_with_unit_moves_mesh_and_view():
    yield from new_morph()
    rest = stored()
    yield from open_panel()
    yield from enter(child("translation_z"), "2 cm")
    is_lifted = lambda: np.allclose(lifted(rest, drawn()), (0, 0, 20), atol=1e-4)  # noqa: E731
    yield from until(is_lifted, "the view to follow")
    yield from until(lambda: largest(stored() - rest) > 19, "the result mesh")
    picture("moving")
    yield from enter(child("angle"), "10")
    yield from until(lambda: largest(drawn() - rest) > 20.5, "the turn")
    yield from press("OK")
    assert regions("handle")[0].TranslationZ.Value == 20.0
    assert regions("handle")[0].Angle.Value == 10.0
    assert largest(drawn() - stored()) == 0.0
    assert App.ActiveDocument.UndoNames == ["Move Handle"]


def test_cancel_takes_everything_back_to_the_bit():
    yield from new_morph()
    rest = stored()
    yield from open_panel()
    yield from enter(child("translation_z"), "15 mm")
    yield from until(lambda: largest(stored() - rest) > 14, "the result mesh")
    yield from press("Cancel")
    assert np.array_equal(stored(), rest)
    assert np.array_equal(drawn(), rest)
    assert regions("handle")[0].TranslationZ.Value == 0.0
    assert App.ActiveDocument.UndoNames == []


def test_undo_and_redo_are_exact():
    yield from new_morph()
    rest = stored()
    yield from open_panel()
    yield from enter(child("translation_x"), "-12.5")
    yield from settled()
    yield from press("OK")
    moved = stored()
    assert largest(moved - rest) > 12
    App.ActiveDocument.undo()
    yield from settled()
    assert np.array_equal(stored(), rest) and np.array_equal(drawn(), rest)
    assert regions("handle")[0].TranslationX.Value == 0.0
    App.ActiveDocument.redo()
    yield from settled()
    assert np.array_equal(stored(), moved) and np.array_equal(drawn(), moved)
    App.ActiveDocument.recompute()
    assert np.array_equal(stored(), moved)


def test_a_saved_document_is_opened_and_moved_again():
    yield from new_morph()
    rest = stored()
    regions("handle")[0].TranslationZ = 10
    App.ActiveDocument.recompute()
    moved = stored()
    path = os.path.join(WORK, "saved.FCStd")
    App.ActiveDocument.saveAs(path)
    App.closeDocument(App.ActiveDocument.Name)
    yield from settled()
    App.openDocument(path)
    yield from settled()
    assert np.array_equal(stored(), moved)
    picture("reopened")
    yield from open_panel()
    assert child("translation_z").value() == 10.0
    yield from enter(child("translation_z"), "30")
    yield from settled()
    yield from press("OK")
    assert np.allclose(lifted(rest, stored()), (0, 0, 30), atol=1e-4)
    assert "Up-to-date" in part().State


def test_what_is_wrong_is_said_beside_its_cause():
    yield from new_morph()
    yield from open_panel()
    yield from enter(child("axis_z"), "0")
    assert child("axis_message").isVisible()
    assert "give it a direction" in child("axis_message").text()
    yield from press("OK")
    assert Gui.Control.activeDialog()
    child("along_x").click()
    assert not child("axis_message").isVisible()
    assert [child(f"along_{c}").isChecked() for c in "xyz"] == [True, False, False]
    yield from press("Cancel")


def test_the_arrows_in_the_view_drag_the_handle():
    yield from new_morph()
    rest = stored()
    yield from open_panel()
    x, y = on_screen(np.mean(sheet()[0][handle_vertices()], axis=0))
    yield from xdotool("mousemove", x, y - 30)
    yield from xdotool("mousedown", 1)
    for step in range(1, 6):
        yield from xdotool("mousemove", x, y - 30 - 8 * step)
    picture("dragging")
    shown = lifted(rest, drawn())
    yield from xdotool("mouseup", 1)
    assert shown[0, 2] > 3 and np.allclose(shown, shown[0], atol=1e-4), shown[0]
    assert np.allclose(shown[0, :2], 0.0)
    yield from until(lambda: largest(stored() - rest) > 3, "the result mesh")
    yield from press("OK")
    handle = regions("handle")[0]
    assert handle.TranslationZ.Value >= shown[0, 2] - 0.1
    assert round(handle.TranslationZ.Value, 4) == handle.TranslationZ.Value
    assert np.allclose(lifted(rest, stored()), (0, 0, handle.TranslationZ.Value), atol=1e-4)


def test_another_command_in_between_does_not_end_the_transaction():
    yield from new_morph()
    rest = stored()
    yield from open_panel()
    yield from enter(child("translation_z"), "9")
    Gui.runCommand("Std_ViewFitAll")
    yield from settled()
    yield from enter(child("translation_x"), "4")
    yield from settled()
    yield from press("Cancel")
    assert np.array_equal(stored(), rest)
    assert App.ActiveDocument.UndoNames == []


def test_a_field_that_an_expression_drives_is_locked_and_followed():
    yield from new_morph()
    rest = stored()
    cells = App.ActiveDocument.addObject("Spreadsheet::Sheet", "Cells")
    cells.set("A1", "6 mm")
    App.ActiveDocument.recompute()
    regions("handle")[0].setExpression("TranslationY", "Cells.A1")
    App.ActiveDocument.recompute()
    assert np.allclose(lifted(rest, stored()), (0, 6, 0), atol=1e-4)
    yield from open_panel()
    assert not child("translation_y").isEnabled()
    assert child("translation_z").isEnabled()
    yield from enter(child("translation_z"), "5")
    yield from settled()
    assert np.allclose(lifted(rest, drawn()), (0, 6, 5), atol=1e-4)
    yield from press("OK")
    assert np.allclose(lifted(rest, stored()), (0, 6, 5), atol=1e-4)


def test_a_part_that_is_put_elsewhere_under_the_panel_is_followed():
    """By its source, in the property editor, and by a container that it lies in."""
    yield from new_morph()
    rest, source = stored(), part().Source
    container = App.ActiveDocument.addObject("App::Part", "Container")
    container.addObject(source)
    App.ActiveDocument.recompute()
    yield from open_panel()
    place = lambda: child("pivot_z").value()  # noqa: E731
    before = place()
    for obj, height in ((source, 50.0), (container, 150.0)):
        with_step("Edit", lambda o=obj, h=height: o.Placement.move(App.Vector(0, 0, h)))
        wanted = before + (50.0 if obj == source else 200.0)
        yield from until(lambda w=wanted: abs(place() - w) < 1e-3, "the pivot to follow")
    yield from enter(child("translation_z"), "2 cm")
    is_lifted = lambda: np.allclose(lifted(rest, drawn()), (0, 0, 20), atol=1e-4)  # noqa: E731
    yield from until(is_lifted, "the view to follow")
    picture("put-elsewhere")
    yield from press("OK")
    assert np.allclose(lifted(rest, stored()), (0, 0, 20), atol=1e-4)
    assert App.ActiveDocument.UndoNames[0] == "Move Handle"

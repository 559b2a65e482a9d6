# SPDX-License-Identifier: LGPL-2.1-or-later
"""A study is set up, run, stopped and used by mouse; what it starts ends with it."""

import os

import FreeCAD as App
import FreeCADGui as Gui
import numpy as np
from checks_moving import lifted
from checks_preferences import dark_sheet
from checks_tutorial import menu
from desk import WORK, activate, child, click_widget, enter, picture, press, press_tool, settled
from desk import until, within_reach, xdotool
from freecad.sheetmorph import api
from freecad.sheetmorph.commands import exchange
from freecad.sheetmorph.objects import model
from hostile_panels import is_shown
from hostile_traces import child_processes
from PySide import QtGui
from scenes import assembly, drawn, new_morph, regions, stored

__all__ = [
    "test_a_study_is_made_run_and_a_row_becomes_the_pose",
    "test_the_tutorial_of_studies_as_a_new_user_does_it",
    "test_a_study_that_is_stopped_keeps_what_is_done",
    "test_a_study_ends_with_its_document",
    "test_what_is_wrong_with_a_study_is_told_in_its_panel",
    "test_a_study_in_a_dark_theme",
]


def click_cell(table: str, row: int, column: int, times: int = 1):
    """Clicks into a cell of a table in the panel."""
    found = child(table)
    yield from until(lambda: found.isEnabled() and found.rowCount() > row, f"row {row} of {table}")
    yield from within_reach(found)
    place = found.visualItemRect(found.item(row, column)).center()
    seen = found.viewport().mapToGlobal(place)
    yield from xdotool("mousemove", seen.x(), seen.y())
    yield from xdotool("click", "--repeat", times, "--delay", 60, 1)


def enter_cell(table: str, place: tuple, text: str):
    """A double click into a cell, a text, Return."""
    yield from click_cell(table, *place, times=2)
    yield from xdotool("key", "ctrl+a")
    yield from xdotool("type", "--delay", 15, "--", text)
    yield from xdotool("key", "Return")


def choose_variable(label: str):
    """The entry of the list of what may change."""
    combo = child("variable")
    yield from click_widget(combo)
    steps = combo.findText(label) - combo.currentIndex()
    yield from xdotool("key", *(["Down" if steps > 0 else "Up"] * abs(steps)), "Return")
    yield from settled()
    assert combo.currentText() == label
    yield from press("Add")


def new_study(count: str):
    """The morph, and the panel with one parameter: the handle is lifted by 0 to 30 mm."""
    yield from new_morph()
    regions("handle")[0].Label = "Tip"
    Gui.Selection.clearSelection()
    yield from press_tool("Study…")
    yield from until(lambda: child("add").isVisible(), "the panel")
    yield from choose_variable("Tip Z")
    yield from enter_cell("parameters", (0, 2), "0 mm")
    yield from enter_cell("parameters", (0, 3), "3 cm")
    yield from enter(child("count"), count)


def is_over() -> bool:
    return child("run").isEnabled()


def test_a_study_is_made_run_and_a_row_becomes_the_pose():
    yield from new_study("12")
    rest = stored()
    yield from choose_variable("Tip angle")
    yield from enter(child("criteria"), "displacement <= 26")
    picture("study")
    yield from press("Run")
    yield from until(is_over, "the end of the study")
    assert child_processes() == []
    (study,) = model.studies(assembly())
    rows = api.results(study)
    assert len(rows) == 12 and {row["status"] for row in rows} == {"passed", "failed"}
    assert "passed" in child("counts").text()
    picture("study-results")
    table = child("results")
    yield from click_cell("results", 4, 0, times=2)
    run = int(table.item(4, 0).text())
    (handle,) = regions("handle")
    yield from until(lambda: handle.TranslationZ.Value != 0.0, "the pose")
    found = {"Tip Z": handle.TranslationZ.Value, "Tip angle": handle.Angle.Value}
    assert found == rows[run]["parameters"]
    assert App.ActiveDocument.UndoNames == ["Apply Variant", "Study Results", "Study"]
    picture("study-applied")
    yield from press("OK")
    assert App.ActiveDocument.UndoNames == ["Apply Variant", "Study Results", "Study"]
    assert np.array_equal(stored(), drawn())
    App.ActiveDocument.undo()
    App.ActiveDocument.recompute()
    assert np.allclose(lifted(rest, stored()), 0.0, atol=1e-4)
    yield from is_saved_with_the_document(rows)


def is_saved_with_the_document(rows):
    """The table comes back, and a double click in the tree opens it."""
    path = os.path.join(WORK, "study.FCStd")
    App.ActiveDocument.saveAs(path)
    App.closeDocument(App.ActiveDocument.Name)
    App.openDocument(path)
    yield from settled()
    (study,) = model.studies(assembly())
    assert api.results(study) == rows
    assert study.ViewObject.Proxy.doubleClicked(study.ViewObject)
    yield from until(is_shown, "the panel")
    yield from until(lambda: child("results").rowCount() == 12, "the table")
    assert child("parameters").item(0, 3).text() == "30.0 mm"
    yield from press("Cancel")


def mirror_study():
    """The guide's five minutes: the door mirror, its handle's angle from -20 to 20 degrees."""
    yield from activate()
    assert exchange.open_recipe(exchange.example_recipes()["Door Mirror"], "DoorMirror")
    yield from settled()
    yield from menu("SheetMorph", "Study…")
    yield from until(is_shown, "the panel")
    variable = next(one.label for one in api.variables(assembly()) if one.number == "Angle")
    yield from choose_variable(variable)
    yield from enter_cell("parameters", (0, 2), "-20")
    yield from enter_cell("parameters", (0, 3), "20")
    yield from enter(child("criteria"), "stretch <= 0.3")
    yield from press("Run")
    yield from until(is_over, "the variants")
    yield from click_cell("results", 3, 0, times=2)
    run = int(child("results").item(3, 0).text())
    (study,) = model.studies(assembly())
    wanted = api.results(study)[run]["parameters"][variable]
    handles = regions("handle")
    yield from until(lambda: wanted in [h.Angle.Value for h in handles], "the pose")


def test_the_tutorial_of_studies_as_a_new_user_does_it():
    yield from mirror_study()
    (study,) = model.studies(assembly())
    statuses = {row["status"] for row in api.results(study)}
    assert len(api.results(study)) == 20 and statuses == {"passed", "failed"}, statuses
    picture("study-tutorial")
    yield from press("OK")
    assert App.ActiveDocument.UndoNames[:2] == ["Apply Variant", "Study Results"]


def test_a_study_that_is_stopped_keeps_what_is_done():
    yield from new_study("400")
    yield from press("Run")
    yield from until(lambda: child("progress").value() > 3, "some variants")
    picture("study-running")
    yield from press("Stop")
    yield from until(is_over, "its end")
    rows = api.results(model.studies(assembly())[0])
    assert 3 < len(rows) < 400 and child("results").rowCount() == len(rows)
    assert child_processes() == []
    yield from press("Cancel")


def test_a_study_ends_with_its_document():
    yield from new_study("400")
    yield from press("Run")
    yield from until(child_processes, "the process")
    App.closeDocument(App.ActiveDocument.Name)
    yield from until(lambda: not child_processes(), "the end of the process")
    assert not Gui.Control.activeDialog()


def test_what_is_wrong_with_a_study_is_told_in_its_panel():
    yield from new_study("4")
    yield from enter_cell("parameters", (0, 2), "40 mm")
    yield from press("Run")
    assert "swap the two numbers" in child("message").text()
    yield from enter_cell("parameters", (0, 2), "0 mm")
    yield from enter(child("criteria"), "stretch = 3")
    yield from press("OK")
    assert "not a criterion" in child("message").text() and Gui.Control.activeDialog()
    assert model.studies(assembly()) == []
    picture("study-fault")
    yield from click_cell("parameters", 0, 0)
    yield from press("Remove")
    yield from click_widget(child("criteria"))
    yield from xdotool("key", "ctrl+a", "Delete")
    yield from press("Run")
    assert "has no parameter yet" in child("message").text()
    yield from press("Cancel")


def test_a_study_in_a_dark_theme():
    application = QtGui.QApplication.instance()
    before = application.styleSheet()
    application.setStyleSheet(dark_sheet())
    try:
        yield from new_study("5")
        yield from enter(child("criteria"), "displacement <= 26")
        yield from press("Run")
        yield from until(is_over, "the end of the study")
        picture("study-dark")
        assert child("results").rowCount() == 5
        yield from press("Cancel")
    finally:
        application.setStyleSheet(before)

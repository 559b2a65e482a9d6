# SPDX-License-Identifier: LGPL-2.1-or-later
"""Contacts are marked with the mouse on both parts; what is marked can be changed and undone."""

import json
import os

import FreeCAD as App
import FreeCADGui as Gui
import numpy as np
from desk import WORK, child, choose_below, click_point, click_widget, enter, picture, press
from desk import press_tool, settled, tick, until, xdotool
from freecad.sheetmorph import api
from freecad.sheetmorph.objects import model
from scenes import assembly, contacts, labelled, largest, new_assembly, part, regions, stored

__all__ = [
    "test_a_contact_is_marked_by_a_click_on_each_part",
    "test_parts_that_were_selected_are_the_sides",
    "test_both_sides_can_be_picked_by_hand",
    "test_a_double_click_edits_type_sides_and_use_of_a_contact",
    "test_parts_too_far_apart_are_told",
    "test_a_follower_is_marked_as_a_region_is",
    "test_an_assembly_with_a_contact_is_saved_and_moved_again",
]

ON_SHEET, ON_BRACKET = (20.5, 12.0, 0), (59.0, 95.0, 1)


def test_a_contact_is_marked_by_a_click_on_each_part():
    yield from new_assembly()
    bracket, rest = labelled("bracket"), stored(labelled("bracket"))
    assert bracket.Label in assembly().Unreached
    yield from press_tool("Mark Contact…")
    assert "click on one" in child("message").text()
    yield from click_point(ON_SHEET)
    yield from click_point(ON_BRACKET)
    assert child("part_a").currentText() == part().Label
    assert child("part_b").currentText() == bracket.Label
    wanted = api.touching_vertices(part(), bracket, child("distance").value())
    assert child("count_b").text() == f"{len(wanted[1])} vertices"
    yield from choose_below(child("type"), 2)
    assert "rigid body" in child("type_text").text()
    picture("contact")
    yield from press("OK")
    (contact,) = contacts()
    assert contact.Type == "rigid"
    assert (api.contact_vertices(contact, "a"), api.contact_vertices(contact, "b")) == wanted
    assert App.ActiveDocument.UndoNames == ["Mark Contact"]
    assert bracket.Label not in assembly().Unreached
    regions("handle")[0].TranslationZ = 15
    App.ActiveDocument.recompute()
    assert largest(stored(bracket) - rest) > 3
    App.ActiveDocument.undo()
    assert contacts() == []
    App.ActiveDocument.redo()
    assert contacts() == [contact] and api.contact_vertices(contact, "a") == wanted[0]


def test_parts_that_were_selected_are_the_sides():
    yield from new_assembly()
    Gui.Selection.clearSelection()
    for chosen in (labelled("bracket"), labelled("loose")):
        Gui.Selection.addSelection(chosen)
    yield from press_tool("Mark Contact…")
    assert child("part_a").currentText() == labelled("bracket").Label
    assert child("part_b").currentText() == labelled("loose").Label
    assert child("distance").value() >= 3.0, "they are 3 mm apart"
    few = child("count_a").text()
    yield from enter(child("distance"), "9 mm")
    assert child("count_a").text() not in (few, "")
    yield from press("Cancel")
    assert contacts() == [] and App.ActiveDocument.UndoNames == []


def test_both_sides_can_be_picked_by_hand():
    yield from new_assembly()
    yield from press_tool("Mark Contact…")
    yield from click_point(ON_SHEET)
    yield from click_point(ON_BRACKET)
    yield from choose_below(child("way"), 1)
    child("facet").click()
    yield from click_point(ON_SHEET)
    assert child("count_a").text() == "3 vertices"
    child("fold_advanced").setChecked(True)
    assert len(json.loads(child("where").text())["vertices"]) == 3
    yield from choose_below(child("way"), 1)
    assert child("where").text() == "", "side b has no pick yet"
    yield from click_point(ON_BRACKET)
    assert child("count_b").text() == "3 vertices"
    picture("contact-by-hand")
    before = child("where").text()
    for text, count in ((json.dumps({"vertices": [0, 1]}), "2 vertices"), (before, "3 vertices")):
        child("where").setText(text)
        child("where").setFocus()
        yield from xdotool("key", "Return")
        yield from until(lambda c=count: child("count_b").text() == c, count)
    child("fold_advanced").setChecked(False)
    child("clear").click()
    yield from press("OK")
    assert "empty" in child("message").text() and contacts() == []
    child("back").click()
    yield from press("OK")
    assert [len(model.contact_vertices(contacts()[0], side)) for side in "ab"] == [3, 3]


def test_a_double_click_edits_type_sides_and_use_of_a_contact():
    yield from new_assembly(is_joined=True)
    (contact,) = contacts()
    before = model.contact_vertices(contact, "a").tolist()
    assert contact.ViewObject.Proxy.doubleClicked(contact.ViewObject)
    yield from settled()
    assert child("count_a").text() == f"{len(before)} vertices"
    yield from choose_below(child("type"), 1)
    yield from click_widget(child("grow"))
    yield from tick(child("active"))
    yield from press("OK")
    assert contact.Type == "tied" and not contact.Active
    assert set(before) < set(model.contact_vertices(contact, "a").tolist())
    assert contact.ViewObject.Proxy.getIcon().endswith("ContactOff.svg")
    assert labelled("bracket").Label in assembly().Unreached
    assert App.ActiveDocument.UndoNames == ["Mark Contact"]
    App.ActiveDocument.undo()
    App.ActiveDocument.recompute()
    assert contact.Type == "control mesh" and contact.Active
    assert model.contact_vertices(contact, "a").tolist() == before
    assert labelled("bracket").Label not in assembly().Unreached


def test_parts_too_far_apart_are_told():
    yield from new_assembly()
    yield from press_tool("Mark Contact…")
    yield from click_point(ON_SHEET)
    yield from click_point((59.0, 140.0, 1))
    assert "farther apart" in child("message").text()
    yield from press("OK")
    assert Gui.Control.activeDialog() and contacts() == []
    yield from press("Cancel")


def test_a_follower_is_marked_as_a_region_is():
    yield from new_assembly(is_joined=True)
    Gui.Selection.clearSelection()
    Gui.Selection.addSelection(labelled("bracket"))
    yield from press_tool("Mark Follower…")
    child("facet").click()
    yield from click_point(ON_BRACKET)
    yield from press("OK")
    (follower,) = regions("follower")
    assert follower.Part == labelled("bracket") and len(model.vertices(follower)) == 3
    assert "Invalid" not in labelled("bracket").State


def test_an_assembly_with_a_contact_is_saved_and_moved_again():
    yield from new_assembly(is_joined=True)
    rest = stored(labelled("bracket"))
    regions("handle")[0].TranslationZ = 10
    App.ActiveDocument.recompute()
    moved = stored(labelled("bracket"))
    assert largest(moved - rest) > 2
    path = os.path.join(WORK, "joined.FCStd")
    App.ActiveDocument.saveAs(path)
    App.closeDocument(App.ActiveDocument.Name)
    yield from settled()
    App.openDocument(path)
    yield from settled()
    assert np.array_equal(stored(labelled("bracket")), moved)
    assert not contacts()[0].ViewObject.Visibility
    yield from press_tool("Move Handle…")
    yield from enter(child("translation_z"), "20")
    yield from settled()
    yield from press("OK")
    assert largest(stored(labelled("bracket")) - rest) > 1.5 * largest(moved - rest)

# SPDX-License-Identifier: LGPL-2.1-or-later
"""The guide leads through a morph: it says what is missing, opens panels and comes back."""

import FreeCAD as App
import FreeCADGui as Gui
from checks_picking import view_from
from desk import child, clear_report_view, click_point, click_widget, enter, panel, picture, press
from desk import press_tool, settled, until
from freecad.sheetmorph.objects import model
from freecad.sheetmorph.panels.guide import Guide
from scenes import assembly, look, new_document, new_morph, part, regions

__all__ = [
    "test_the_guide_leads_from_a_mesh_to_a_moved_handle",
    "test_the_guide_follows_undo_and_leaves_nothing",
    "test_the_guide_shows_the_region_that_is_wrong",
]


def mark(key: str) -> str:
    """The sign in front of a step."""
    return next(sign for sign in "✓➜○!" if f">{sign}<" in child(f"{key}_mark").text())


def marks() -> str:
    """The signs of all steps."""
    return "".join(mark(k) for k in ("parts", "fixed", "features", "contacts", "handle", "drag"))


def back():
    """Waits until the guide is there again."""
    yield from until(Guide.is_shown, "the guide to come back")
    yield from settled()


def choose(command: str):
    """Presses the button of a command that the guide offers."""
    yield from click_widget(child(command))
    yield from settled()


def test_the_guide_leads_from_a_mesh_to_a_moved_handle():
    yield from new_document()
    yield from press_tool("Guide")
    assert marks() == "➜○○○○○", marks()
    assert not child("MarkFixed_small").isEnabled()
    Gui.Selection.addSelection(App.ActiveDocument.getObject("sheet"))
    yield from settled()
    yield from choose("CreateMorph")
    yield from back()
    assert marks() == "✓➜○✓○○", marks()
    picture("guide-fixed")
    view_from(0.0)
    yield from choose("MarkFixed")
    assert panel().objectName() == "region"
    yield from click_point((0, 30, 10))
    yield from press("OK")
    yield from back()
    assert marks() == "✓✓➜✓○○", marks()
    look()
    yield from choose("FindFeatures")
    yield from press("Cancel")
    yield from back()
    view_from(120.0)
    yield from choose("MarkHandle")
    yield from click_point((120, 30, 10))
    yield from press("OK")
    yield from back()
    assert marks() == "✓✓○✓✓➜", marks()
    look()
    yield from choose("MoveHandle")
    yield from enter(child("translation_z"), "12")
    yield from press("OK")
    yield from back()
    assert marks() == "✓✓○✓✓✓", marks()
    assert regions("handle")[0].TranslationZ.Value == 12.0
    picture("guide-moved")
    yield from press("Close")


def test_the_guide_follows_undo_and_leaves_nothing():
    yield from new_morph()
    yield from press_tool("Guide")
    assert marks() == "✓✓✓✓✓➜", marks()
    yield from press_tool("Mark Fixed Region…")
    assert panel().objectName() == "region" and not Guide.is_shown()
    yield from click_point((60.5, 12.0, 0))
    yield from press("OK")
    yield from back()
    assert "regions: 2" in child("fixed_text").text()
    Gui.runCommand("Std_Undo")
    yield from settled()
    assert "regions: 1" in child("fixed_text").text()
    Gui.runCommand("Std_Redo")
    yield from settled()
    assert "regions: 2" in child("fixed_text").text()
    yield from press("Close")
    yield from settled()
    assert not Gui.Control.activeDialog() and Guide._open is None
    assert App.ActiveDocument.UndoNames == ["Mark Fixed Region"]


def test_the_guide_shows_the_region_that_is_wrong():
    yield from new_morph()
    fixed, before = regions("fixed")[0], part().ViewObject.RootNode.getNumChildren()
    (handle,) = regions("handle")
    App.ActiveDocument.openTransaction("Overlap")
    model.set_vertices(fixed, model.vertices(handle))
    handle.TranslationZ = 10
    App.ActiveDocument.recompute()
    App.ActiveDocument.commitTransaction()
    yield from press_tool("Guide")
    yield from settled()
    assert "!" in marks(), marks()
    said = " ".join(child(f"{k}_text").text() for k in ("fixed", "handle"))
    assert fixed.Label in said or handle.Label in said, said
    assert fixed in Gui.Selection.getSelection() or handle in Gui.Selection.getSelection()
    assert part().ViewObject.RootNode.getNumChildren() > before
    picture("guide-wrong")
    Gui.runCommand("Std_Undo")
    App.ActiveDocument.recompute()
    yield from settled()
    assert marks() == "✓✓✓✓✓➜", marks()
    yield from press("Close")
    assert part().ViewObject.RootNode.getNumChildren() == before
    assert assembly().Status == "Up to date."
    clear_report_view()  # FreeCAD's own words about the recompute that failed

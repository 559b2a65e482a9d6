# SPDX-License-Identifier: LGPL-2.1-or-later
"""Undo goes back inside an open panel and then ends it; what is not kept is nobody's step."""

import FreeCAD as App
import FreeCADGui as Gui
import numpy as np
from checks_moving import lifted, open_panel
from desk import child, enter, offered, on_screen, panel, picture, press, press_tool, settled
from desk import until, view, xdotool
from freecad.sheetmorph import api
from hostile_panels import is_shown, with_step
from hostile_traces import open_steps
from scenes import assembly, drawn, handle_vertices, largest, new_morph, part, regions, stored

__all__ = [
    "test_undo_goes_back_step_by_step_inside_the_move_panel",
    "test_redo_in_the_move_panel_brings_back_what_was_moved",
    "test_undo_and_redo_go_to_and_fro_inside_the_move_panel",
    "test_the_keys_of_undo_and_redo_act_in_the_fields_of_the_move_panel",
    "test_what_an_undo_has_left_in_the_move_panel_is_kept_as_one_step",
    "test_undo_of_the_creation_of_a_handle_ends_its_panel",
    "test_undo_goes_back_inside_the_blend_panel",
    "test_a_panel_in_which_nothing_changed_leaves_no_step_open",
    "test_what_another_command_interrupts_is_still_taken_back_by_cancel",
    "test_changes_in_another_document_are_no_part_of_what_is_moved",
    "test_a_panel_opened_from_a_spreadsheet_shows_the_3d_view",
    "test_a_panel_opened_without_a_view_makes_one",
]


def fields() -> tuple:
    return tuple(child(f"translation_{c}").value() for c in "xyz")


def undo_with_the_tool():
    yield from press_tool("Undo")
    yield from settled()


def undo_with_the_key():
    """With the mouse over the view, whose keys these are."""
    x, y = on_screen((20.0, 30.0, 0.0))
    yield from xdotool("mousemove", x, y)
    view().graphicsView().setFocus()
    yield from offered("Std_Undo")
    yield from xdotool("key", "ctrl+z")
    yield from settled()


def test_undo_goes_back_step_by_step_inside_the_move_panel():
    yield from new_morph()
    rest = stored()
    yield from open_panel()
    yield from enter(child("translation_z"), "20")
    yield from settled()
    yield from enter(child("translation_x"), "5")
    yield from until(lambda: np.allclose(lifted(rest, drawn()), (5, 0, 20), atol=1e-3), "both")
    yield from settled()
    yield from undo_with_the_tool()
    yield from until(lambda: fields() == (0.0, 0.0, 20.0), "the first field's value alone")
    yield from until(lambda: np.allclose(lifted(rest, drawn()), (0, 0, 20), atol=1e-3), "mesh")
    picture("undone-once")
    yield from undo_with_the_key()
    yield from until(lambda: fields() == (0.0, 0.0, 0.0), "rest in the fields")
    yield from until(lambda: largest(drawn() - rest) < 1e-3, "the mesh at rest")
    yield from enter(child("translation_x"), "12")
    yield from settled()
    yield from press("Cancel")
    assert regions("handle")[0].TranslationX.Value == 0.0
    assert np.array_equal(stored(), rest) and App.ActiveDocument.UndoNames == []


def test_redo_in_the_move_panel_brings_back_what_was_moved():
    yield from new_morph()
    yield from open_panel()
    yield from enter(child("translation_z"), "20")
    yield from settled()
    yield from undo_with_the_tool()
    yield from until(lambda: fields() == (0.0, 0.0, 0.0), "rest in the fields")
    yield from press_tool("Redo")
    yield from until(lambda: fields() == (0.0, 0.0, 20.0), "what was moved")
    yield from press("OK")
    assert regions("handle")[0].TranslationZ.Value == 20.0
    assert App.ActiveDocument.UndoNames == ["Move Handle"]


def test_undo_and_redo_go_to_and_fro_inside_the_move_panel():
    yield from new_morph()
    rest = stored()
    yield from open_panel()
    typed = (("translation_z", "20"), ("translation_x", "5"), ("translation_y", "3"))
    poses = [(0.0, 0.0, 0.0), (0.0, 0.0, 20.0), (5.0, 0.0, 20.0), (5.0, 3.0, 20.0)]
    for field, text in typed:
        yield from enter(child(field), text)
        yield from settled()

    def goes_to(tool, place):
        yield from press_tool(tool)
        yield from until(lambda: fields() == poses[place], f"the pose {place} of {tool}")
        moved = lambda: np.allclose(lifted(rest, drawn()), poses[place], atol=1e-3)  # noqa: E731
        yield from until(moved, "the mesh")
        yield from settled()

    for tool, place in (("Undo", 2), ("Undo", 1), ("Redo", 2), ("Redo", 3), ("Undo", 2)):
        yield from goes_to(tool, place)
    picture("redo-inside-a-panel")
    assert is_shown() and Gui.Command.get("Std_Redo").isActive()
    for tool, place in (("Undo", 1), ("Undo", 0), ("Redo", 1), ("Redo", 2)):
        yield from goes_to(tool, place)
    yield from press("Cancel")
    assert np.array_equal(stored(), rest) and not open_steps()
    assert App.ActiveDocument.UndoNames == App.ActiveDocument.RedoNames == []


def test_the_keys_of_undo_and_redo_act_in_the_fields_of_the_move_panel():
    """A field that has the keys would take them for its text; while one types it still does."""
    yield from new_morph()
    yield from open_panel()
    for field, text in (("translation_z", "20"), ("translation_x", "5")):
        yield from enter(child(field), text)
        yield from settled()
    child("translation_y").setFocus()
    for key, values in (("ctrl+z", (0, 0, 20)), ("ctrl+shift+z", (5, 0, 20))):
        assert child("translation_y").hasFocus(), key
        yield from offered("Std_Undo" if key == "ctrl+z" else "Std_Redo")
        yield from xdotool("key", key)
        yield from until(lambda v=values: fields() == v, f"{values} by {key}")
        yield from settled()
        child("translation_y").setFocus()
    yield from xdotool("key", "ctrl+a", "7", "8", "ctrl+z")
    yield from settled()
    assert fields()[::2] == (5.0, 20.0), "the typed text is taken back, not what was moved"
    yield from press("Cancel")
    assert not open_steps() and App.ActiveDocument.UndoNames == []


def test_what_an_undo_has_left_in_the_move_panel_is_kept_as_one_step():
    yield from new_morph()
    rest = stored()
    yield from open_panel()
    for field, text in (("translation_z", "20"), ("translation_x", "5")):
        yield from enter(child(field), text)
        yield from settled()
    yield from undo_with_the_tool()
    yield from until(lambda: fields() == (0.0, 0.0, 20.0), "the first field's value alone")
    yield from press("OK")
    handle = regions("handle")[0]
    assert (handle.TranslationX.Value, handle.TranslationZ.Value) == (0.0, 20.0)
    assert App.ActiveDocument.UndoNames == ["Move Handle"]
    assert App.ActiveDocument.RedoNames == []
    assert np.allclose(lifted(rest, stored()), (0, 0, 20), atol=1e-3)
    App.ActiveDocument.undo()
    App.ActiveDocument.recompute()
    assert np.array_equal(stored(), rest)


def test_undo_of_the_creation_of_a_handle_ends_its_panel():
    yield from new_morph()
    with_step("Late Handle", add_handle_at_the_other_end)
    Gui.Selection.addSelection(regions("handle")[1])
    yield from open_panel()
    yield from enter(child("translation_z"), "4")
    yield from settled()
    yield from undo_with_the_tool()
    yield from until(lambda: fields() == (0.0, 0.0, 0.0), "rest in the fields")
    yield from undo_with_the_tool()
    yield from xdotool("type", "7")
    yield from until(lambda: not Gui.Control.activeDialog(), "the end of the panel")
    assert len(regions("handle")) == 1 and not open_steps()


def add_handle_at_the_other_end() -> None:
    points = api.rest_mesh(part())[0]
    corner = np.flatnonzero((points[:, 0] == 0) & (points[:, 2] == 0)).tolist()
    api.add_handle(assembly(), part(), corner, "Late")


def test_undo_goes_back_inside_the_blend_panel():
    yield from new_morph()
    rest, handle = stored(), regions("handle")[0]
    api.set_motion(handle, (0, 0, 30))
    pose = api.save_pose(assembly(), "High")
    api.set_motion(handle, (0, 0, 0))
    App.ActiveDocument.recompute()
    App.ActiveDocument.clearUndos()
    Gui.Selection.addSelection(pose)
    yield from press_tool("Blend Poses…")
    yield from until(is_shown, "the panel")
    yield from enter(child("percent"), "50")
    yield from settled()
    yield from enter(child("percent"), "80")
    yield from settled()
    yield from undo_with_the_tool()
    yield from until(lambda: child("percent").value() == 50.0, "the share before")
    yield from until(lambda: np.allclose(lifted(rest, drawn()), (0, 0, 15), atol=1e-3), "half")
    yield from press("Cancel")
    assert handle.TranslationZ.Value == 0.0 and App.ActiveDocument.UndoNames == []


def test_a_panel_in_which_nothing_changed_leaves_no_step_open():
    yield from new_morph()
    for button in ("Cancel", "OK"):
        yield from open_panel()
        yield from press(button)
        assert not open_steps()
        App.ActiveDocument.addObject("App::FeaturePython", "Other")
        assert App.ActiveDocument.UndoNames == []


def test_what_another_command_interrupts_is_still_taken_back_by_cancel():
    yield from new_morph()
    rest = stored()
    yield from open_panel()
    yield from enter(child("translation_z"), "9")
    yield from settled()
    Gui.runCommand("Std_Part")
    yield from until(lambda: fields() == (0.0, 0.0, 9.0), "what was moved")
    yield from enter(child("translation_x"), "4")
    yield from settled()
    yield from press("Cancel")
    assert regions("handle")[0].TranslationX.Value == regions("handle")[0].TranslationZ.Value == 0.0
    App.ActiveDocument.recompute()
    assert np.array_equal(stored()[handle_vertices()], rest[handle_vertices()])
    assert not open_steps()
    assert "Add a part" in App.ActiveDocument.UndoNames


class Other:
    """Another document that has a step to redo; it is changed as scripts and its view do it."""

    def __init__(self, mine):
        self.document = App.newDocument("Other")
        for name in ("Changed", "Hidden", "Removed"):
            self.document.addObject("App::FeaturePython", name)
        self.document.clearUndos()
        with_step("Undone", lambda: self.document.addObject("App::FeaturePython", "Undone"))
        self.document.undo()
        App.setActiveDocument(mine.Name)

    def change(self) -> None:
        self.document.Changed.Label += " again"
        self.document.Hidden.ViewObject.Visibility = not self.document.Hidden.Visibility
        self.document.addObject("App::FeaturePython", "Added")
        self.document.removeObject(self.document.Objects[2].Name)
        self.document.recompute()

    def state(self) -> tuple:
        objects = [(one.Name, one.Label, one.Visibility) for one in self.document.Objects]
        return objects, self.document.UndoNames, self.document.RedoNames


def test_changes_in_another_document_are_no_part_of_what_is_moved():
    """Whichever of the two is the active one when something is moved."""
    yield from new_morph()
    mine, handle = App.ActiveDocument, regions("handle")[0]
    other = Other(mine)
    yield from settled()
    for end, steps in (("Cancel", ([], [])), ("Undo", ([], ["Move Handle"])), ("OK", None)):
        Gui.Selection.clearSelection()
        Gui.Selection.addSelection(handle)
        yield from open_panel()
        App.setActiveDocument(other.document.Name)
        yield from enter(child("translation_z"), "9")
        yield from settled()
        other.change()
        changed = other.state()
        assert changed[1:] == ([], ["Undone"]), changed
        yield from enter(child("translation_x"), "4")
        other.document.Changed.Label = f"before {end}"
        App.setActiveDocument(mine.Name)
        changed = other.state()
        if end == "Undo":
            yield from undo_with_the_tool()
            yield from until(lambda: fields() == (0.0, 0.0, 9.0), "the first number alone")
            yield from undo_with_the_tool()
            yield from until(lambda: fields() == (0.0, 0.0, 0.0), "rest")
        else:
            yield from press(end)
        assert other.state() == changed, end
        assert (mine.UndoNames, mine.RedoNames) == (steps or (["Move Handle"], [])), end
        if Gui.Control.activeDialog():
            yield from press("Cancel")
    assert (handle.TranslationX.Value, handle.TranslationZ.Value) == (4.0, 9.0)
    yield from undo_with_the_tool()
    assert (handle.TranslationX.Value, handle.TranslationZ.Value) == (0.0, 0.0)
    assert other.state() == changed and not open_steps(), open_steps()


def test_a_panel_opened_from_a_spreadsheet_shows_the_3d_view():
    yield from new_morph()
    cells = App.ActiveDocument.addObject("Spreadsheet::Sheet", "Cells")
    for command, name in (("MoveHandle", "move"), ("MarkFixed", "region")):
        cells.ViewObject.doubleClicked()
        yield from settled()
        assert not hasattr(view(), "getSceneGraph")
        Gui.runCommand(f"SheetMorph_{command}")
        yield from until(lambda: is_shown() and panel().objectName() == name, "the panel")
        yield from until(lambda: hasattr(view(), "getSceneGraph"), "the 3D view")
        picture(f"from-spreadsheet-{name}")
        yield from press("Cancel")
        yield from until(lambda: not is_shown(), "the panel's end")


def test_a_panel_opened_without_a_view_makes_one():
    yield from new_morph()
    cells = App.ActiveDocument.addObject("Spreadsheet::Sheet", "Cells")
    three = view()
    cells.ViewObject.doubleClicked()
    yield from settled()
    from freecad.sheetmorph.editing.view_of import is_in, mdi_area

    for window in mdi_area().subWindowList():
        if is_in(three, window):
            window.close()
    yield from settled()
    assert Gui.activeDocument().mdiViewsOfType("Gui::View3DInventor") == []
    Gui.runCommand("SheetMorph_MarkFixed")
    yield from until(is_shown, "the panel")
    assert view().getSceneGraph()
    yield from press("Cancel")

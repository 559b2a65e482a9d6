# SPDX-License-Identifier: LGPL-2.1-or-later
"""Whatever is done under an open panel, it goes on or ends, and nothing of it is left behind.

Undo, redo, deletion of what it is about, closing of the document, `closeDialog()`, other commands,
other workbenches, a spreadsheet on top, other views, saving, going back to the file, hiding,
renaming, the tree: under every panel there is.
"""

import gc
import pathlib
import re
import time

import FreeCAD as App
import FreeCADGui as Gui
import settling
from desk import POLL, answered, clear_report_view, panel, press, say_yes, settled, until, view
from freecad.sheetmorph import panels
from freecad.sheetmorph.interaction.live_update import LiveUpdate
from freecad.sheetmorph.panels.base import Panel
from hostile_acts import DELETIONS, DESTRUCTIVE, FROM_ELSEWHERE, GENTLE, OF_A_PERSON, STEPS
from hostile_acts import undo_and_redo
from hostile_panels import PANELS, is_shown, prepared, with_step
from hostile_traces import Traces, left, motions, open_steps
from PySide import QtGui
from scenes import labelled

__all__ = [
    "test_every_panel_is_among_those_that_suffer",
    "test_a_panel_begins_nothing_while_another_command_asks",
    "test_a_panel_that_was_closed_leaves_nothing_behind",
]
OWN_WIDGETS = r"super\(\)\.__init__\(\w+(?:\(\))?, \"(\w+)\","


def survive(name: str, acts):
    """Opens a panel, does something hostile, ends it, and looks what is left; for every act."""
    opened, used, subject_of = PANELS[name]
    faults = []
    for act in acts:
        if App.ActiveDocument is None or act in DESTRUCTIVE or needs_new():
            for document in list(App.listDocuments()):
                App.closeDocument(document)
            yield from prepared()
        traces, before = Traces(), motions()
        opened()
        yield from until(is_shown, f"the panel {name}")
        used()
        yield POLL  # in the midst of what that has begun
        yield from act(subject_of())
        if App.ActiveDocument is not None and is_shown():
            used_again(used)
            yield POLL
        if Gui.Control.activeDialog() and act in DELETIONS:
            yield from press_if_there("OK")
        if Gui.Control.activeDialog():
            yield from press_if_there("Cancel", "Close")
        yield from settled()
        # A redo after the end brings back what was moved in the panel, as it should.
        motions_before = {} if act is undo_and_redo else before
        faults += [f"{act.__name__}: {fault}" for fault in left(traces, motions_before)]
        clear_report_view()
    assert not faults, "\n".join(faults)


def test_every_panel_is_among_those_that_suffer():
    """Opened one after the other, each from a spreadsheet; it brings the 3D view on top.

    The texts of the panels say how many kinds there are.
    """
    yield from prepared()
    texts = [text.read_text("utf-8") for text in pathlib.Path(panels.__file__).parent.glob("*.py")]
    kinds = {kind for text in texts for kind in re.findall(OWN_WIDGETS, text)}
    opened = set()
    cells = App.ActiveDocument.addObject("Spreadsheet::Sheet", "Cells")
    for name, (opener, _, _) in PANELS.items():
        cells.ViewObject.doubleClicked()
        yield from until(lambda: not hasattr(view(), "getSceneGraph"), "the spreadsheet")
        opener()
        yield from until(is_shown, f"the panel {name}")
        assert hasattr(view(), "getSceneGraph") or name == "guide", name
        opened.add(panel().objectName())
        Gui.Control.closeDialog()
        yield from settled()
    assert opened == kinds and len(kinds) > 8, opened ^ kinds


def test_a_panel_that_was_closed_leaves_nothing_behind():
    """Neither the panel nor, with it, its solution: each of them was kept by a callback."""
    yield from prepared()
    for name, (opener, used, _) in PANELS.items():
        opener()
        yield from until(is_shown, f"the panel {name}")
        used()
        yield from settled()
        yield from press_if_there("Cancel", "Close")
        yield from until(lambda: not Gui.Control.activeDialog(), f"{name} to close")
        yield from settled()
        yield from until(lambda: not left_behind(), f"{name} to go: {left_behind()}")


def left_behind() -> list[str]:
    """The panels and live updates that are still in memory."""
    gc.collect()
    return [type(one).__name__ for one in gc.get_objects() if isinstance(one, (Panel, LiveUpdate))]


def test_a_panel_begins_nothing_while_another_command_asks():
    """What a panel has put off comes due while FreeCAD asks whether to delete something else, and
    when the question is gone but the deletion is yet to come."""
    yield from prepared()
    document = App.ActiveDocument
    with_step("Apart", lambda: add_a_mesh_and_what_needs_it(document))
    opened, used, _ = PANELS["feature"]
    opened()
    yield from until(is_shown, "the panel")
    used()
    delete_late(document.Apart)
    yield from settled()
    assert not open_steps() and is_shown(), open_steps()
    assert document.UndoNames[:2] == ["Delete", "Apart"], document.UndoNames
    used()
    delete_late(labelled("loose").Source)
    yield from until(lambda: not is_shown(), "the end of a panel on a part without its mesh")
    assert not open_steps(), open_steps()
    assert document.UndoNames[:3] == ["Delete", "Delete", "Apart"], document.UndoNames
    clear_report_view()  # FreeCAD says there that a part has lost its mesh


def add_a_mesh_and_what_needs_it(document) -> None:
    mesh = document.addObject("Mesh::Feature", "Apart")
    mesh.Mesh = labelled("loose").Source.Mesh
    needs = document.addObject("App::FeaturePython", "Needs")
    needs.addProperty("App::PropertyLink", "Mesh")
    needs.Mesh = mesh


def delete_late(obj) -> None:
    """The question is answered when what was put off before is due, and all of that comes before
    FreeCAD goes on, as happens by chance when both come at once."""
    due, asked = settling.due() + 0.1, []

    def answer(box) -> None:
        if time.monotonic() < due or asked:
            return
        asked.append(box.text())
        say_yes(box)
        while time.monotonic() < due + 0.2:
            QtGui.QApplication.processEvents()

    Gui.Selection.clearSelection()
    Gui.Selection.addSelection(obj)
    with answered(answer):
        Gui.runCommand("Std_Delete")
    assert asked


def needs_new() -> bool:
    return App.ActiveDocument.UndoNames != ["Pose", "Second Handle"]


def used_again(used) -> None:
    """The panel is used on; its widgets may just be gone."""
    try:
        used()
    except (AssertionError, AttributeError):
        return


def press_if_there(*texts: str):
    """Presses the button with one of these texts in the task view, if there is one."""
    buttons = [
        button
        for button in Gui.getMainWindow().findChildren(QtGui.QPushButton)
        if button.isVisible() and button.text().replace("&", "") in texts
    ]
    for button in buttons[:1]:
        yield from press(button.text().replace("&", ""))


def a_test(name: str, acts, title: str) -> None:
    def test():
        yield from survive(name, acts)

    full = f"test_{title}_under_{name}"
    test.__name__ = full
    globals()[full] = test
    __all__.append(full)


for NAME in PANELS:
    a_test(NAME, GENTLE, "other_things")
    a_test(NAME, OF_A_PERSON, "saving_and_the_tree")
    a_test(NAME, FROM_ELSEWHERE, "changes_from_elsewhere")
    a_test(NAME, STEPS, "undo_and_closing")
    a_test(NAME, DELETIONS, "deletions")

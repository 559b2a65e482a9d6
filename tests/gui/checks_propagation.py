# SPDX-License-Identifier: LGPL-2.1-or-later
"""How the motion goes from part to part is shown, and everything follows while dragging."""

import subprocess
import threading

import FreeCAD as App
import FreeCADGui as Gui
import numpy as np
from desk import activate, child, choose_below, enter, picture, press, press_tool, settled, tick
from desk import until, xdotool
from freecad.sheetmorph import api
from freecad.sheetmorph.commands import exchange
from freecad.sheetmorph.objects import model
from freecad.sheetmorph import progress_dialog
from freecad.sheetmorph.panels import move_panel
from freecad.sheetmorph.scene import wireframe
from pivy import coin
from PySide import QtCore, QtGui
from scenes import assembly, contacts, drawn, labelled, largest, new_assembly, part, regions, stored

__all__ = [
    "test_a_click_on_a_row_highlights_parts_and_contact",
    "test_type_mode_and_propagation_are_changed_in_the_panel",
    "test_a_contact_that_opens_too_far_is_told_in_the_tree_and_while_moving",
    "test_control_meshes_move_with_the_handle",
    "test_every_part_of_the_welded_frame_follows_live",
    "test_another_part_becomes_the_primary",
    "test_a_cancelled_set_up_opens_no_panel",
    "test_return_and_space_cancel_no_progress_and_escape_does",
]


def rows() -> dict:
    """The rows of the tree by their text."""
    flags = QtGui.QTreeWidgetItemIterator.All
    found, walk = {}, QtGui.QTreeWidgetItemIterator(child("tree"), flags)
    while walk.value() is not None:
        found[walk.value().text(0)] = walk.value()
        walk += 1
    return found


def above(text: str) -> str:
    """The text of the row that a row lies beneath."""
    return rows()[text].parent().text(0)


def click_row(text: str):
    """Clicks a row of the tree with the mouse."""
    tree = child("tree")
    place = tree.visualItemRect(rows()[text]).center()
    middle = tree.viewport().mapToGlobal(place)
    yield from xdotool("mousemove", middle.x(), middle.y(), "click", 1)
    yield from settled()


def painted(which) -> int:
    """How many coloured sets of vertices lie over a part."""
    root = which.ViewObject.RootNode
    kinds = [root.getChild(k).getTypeId() for k in range(root.getNumChildren())]
    return sum(kind == coin.SoSwitch.getClassTypeId() for kind in kinds)


def wires() -> np.ndarray:
    """The vertices (m, 3) of all control meshes that are in the view, mm."""
    found = coin.SoNode.getByName(wireframe.NAME)
    if found is None:
        return np.zeros((0, 3))
    search = coin.SoSearchAction()
    search.setType(coin.SoCoordinate3.getClassTypeId())
    search.apply(found)
    values = search.getPath().getTail().point.getValues()
    return np.array([v.getValue() for v in values], dtype=float).reshape(-1, 3)


def test_a_click_on_a_row_highlights_parts_and_contact():
    yield from new_assembly(is_joined=True)
    bracket, (contact,) = labelled("bracket"), contacts()
    before = painted(part()), painted(bracket)
    yield from press_tool("Propagation…")
    assert above(bracket.Label) == part().Label and above(contact.Label) == bracket.Label
    assert above(labelled("loose").Label) == "Not reached"
    assert "mark a contact" in child("hint").text()
    yield from click_row(contact.Label)
    assert (painted(part()), painted(bracket)) == (before[0] + 2, before[1] + 2)
    assert Gui.Selection.getSelection() == [contact]
    yield from tick(child("meshes"))
    yield from until(lambda: len(wires()) > 50, "the control mesh")
    picture("propagation")
    yield from click_row(bracket.Label)
    assert Gui.Selection.getSelection() == [bracket]
    picture("propagation-part")
    yield from press("Close")
    assert (painted(part()), painted(bracket)) == before
    assert len(wires()) == 0 and App.ActiveDocument.UndoNames == []


def test_type_mode_and_propagation_are_changed_in_the_panel():
    yield from new_assembly(is_joined=True)
    bracket, (contact,) = labelled("bracket"), contacts()
    yield from press_tool("Propagation…")
    yield from click_row(contact.Label)
    yield from choose_below(child("type"), 1)
    assert contact.Type == "tied"
    assert rows()[contact.Label].text(1) == "tied" and rows()[contact.Label].isSelected()
    yield from tick(child("active"))
    assert not contact.Active
    assert above(contact.Label) == "Contacts not in use"
    yield from tick(child("active"))
    yield from click_row(bracket.Label)
    yield from choose_below(child("mode"), 1)
    assert bracket.Mode.startswith("1")
    yield from choose_below(child("kind"), 1)
    assert assembly().Propagation == "single"
    yield from until(lambda: assembly().Unreached == [], "every part to be reached")
    yield from choose_below(child("kind"), 1)
    assert assembly().Propagation == "whole"
    assert not any(child(key).isEnabled() for key in ("levels", "smoothness", "meshes", "mode"))
    picture("propagation-whole")
    yield from choose_below(child("unheld"), 1)
    assert assembly().Unheld == "along"
    yield from press("Close")
    names = [
        "Loose Pieces",
        "Propagation",
        "Propagation",
        "Mode",
        "Use Contact",
        "Use Contact",
        "Contact Type",
    ]
    assert App.ActiveDocument.UndoNames == names
    for _ in names:
        App.ActiveDocument.undo()
    assert (contact.Type, contact.Active) == ("control mesh", True)
    assert assembly().Unheld == "rest"
    assert (bracket.Mode, assembly().Propagation) == ("automatic", "local")


def test_a_contact_that_opens_too_far_is_told_in_the_tree_and_while_moving():
    yield from new_assembly(is_joined=True)
    (contact,) = contacts()
    assembly().Smoothness = 1000.0  # follows too stiffly for so sharp a bend
    api.set_motion(regions("handle")[0], (0, 0, 60), (1, 0, 0), 150)
    App.ActiveDocument.recompute()
    assert "make it tied or rigid" in contact.Warning, contact.GapChange
    yield from press_tool("Propagation…")
    row = rows()[contact.Label]
    assert row.toolTip(0) == contact.Warning and not row.icon(2).isNull()
    assert contact.Warning in child("hint").text()
    picture("propagation-opened")
    yield from press("Close")
    Gui.Selection.addSelection(regions("handle")[0])
    yield from press_tool("Move Handle…")
    yield from until(lambda: contact.Warning in child("staying").text(), "the warning")
    picture("move-opened")
    yield from press("Cancel")


def test_control_meshes_move_with_the_handle():
    yield from new_assembly(is_joined=True)
    yield from press_tool("Move Handle…")
    yield from tick(child("control_meshes"))
    rest = wires()
    assert len(rest) > 50
    yield from enter(child("translation_z"), "15")
    yield from settled()
    moved = wires()
    (contact,) = contacts()
    assert largest(moved - rest) > 2
    picture("control-meshes")
    yield from press("OK")
    assert len(wires()) == 0
    wanted = api.control_mesh(assembly(), contact)[0]
    assert np.allclose(moved, wanted, atol=1e-3)


def test_every_part_of_the_welded_frame_follows_live():
    yield from activate()
    assert exchange.open_recipe(exchange.example_recipes()["Welded Frame"], "Frame")
    parts = model.parts(assembly())
    assert len(parts) == 14 and assembly().Unreached == []
    api.reset_motion(regions("handle")[0])
    App.ActiveDocument.recompute()
    rest = [drawn(each) for each in parts]
    yield from press_tool("Move Handle…")
    yield from enter(child("translation_z"), "60")
    yield from settled()
    live = [largest(drawn(each) - before) for each, before in zip(parts, rest)]
    assert min(live) > 0.5, live
    yield from press("OK")
    assert all(np.array_equal(drawn(each), stored(each)) for each in parts)
    after = [largest(stored(each) - before) for each, before in zip(parts, rest)]
    assert np.allclose(live, after, rtol=1e-3)


def test_another_part_becomes_the_primary():
    yield from new_assembly(is_joined=True)
    first, second = part(), labelled("bracket")
    assert first.ViewObject.Proxy.getIcon().endswith("PartPrimary.svg")
    Gui.Selection.clearSelection()
    Gui.Selection.addSelection(second)
    yield from settled()
    yield from press_tool("Set as Primary")
    assert assembly().Primary == second
    assert first.ViewObject.Proxy.getIcon().endswith("Part.svg")
    assert second.ViewObject.Proxy.getIcon().endswith("PartPrimary.svg")
    App.ActiveDocument.undo()
    assert assembly().Primary == first


def test_a_cancelled_set_up_opens_no_panel():
    yield from new_assembly(is_joined=True)
    api.set_energy(assembly(), "paper")  # so that there is something to set up
    with Canceller():
        opened = move_panel.open_panel(regions("handle")[0])
    assert opened is None and not Gui.Control.activeDialog()
    yield from until(lambda: dialog() is None, "the dialog to close")
    assert App.ActiveDocument.UndoNames == []
    yield from press_tool("Move Handle…")
    yield from press("Cancel")


def dialog():
    """The progress dialog, None if there is none."""
    return Gui.getMainWindow().findChild(QtGui.QProgressDialog, "SheetMorphProgress")


class Canceller:
    """In its context the first progress dialog that appears has its Cancel pressed at once."""

    def __enter__(self):
        self._patience, progress_dialog.PATIENCE = progress_dialog.PATIENCE, -1.0
        self._timer = QtCore.QTimer()
        self._timer.timeout.connect(self._press)
        self._timer.start(5)

    def __exit__(self, *_):
        self._timer.stop()
        progress_dialog.PATIENCE = self._patience

    def _press(self) -> None:
        shown = dialog()
        if shown is not None:
            self._timer.stop()
            shown.findChild(QtGui.QPushButton).click()


class Typist(QtCore.QObject):
    """Types a key while a progress dialog is open, and works on until FreeCAD has let go of it."""

    def __init__(self, key: str):
        super().__init__()
        self._key, self.is_shut = key, False
        self._is_open, self._is_typed, self._is_seen = (threading.Event() for _ in range(3))
        self._timer = QtCore.QTimer()
        self._timer.timeout.connect(self._look)
        QtGui.QApplication.instance().installEventFilter(self)

    def __call__(self, progress) -> None:
        """The work, in a thread: it lasts until the key has come and was seen to."""
        self._is_open.wait(60.0)
        subprocess.run(["xdotool", "key", self._key], check=True)
        self._is_typed.wait(60.0)
        self._is_seen.wait(60.0)

    def type_under_progress(self) -> bool:
        """Whether the progress was cancelled by the key."""
        progress = progress_dialog.Progress("Typing")
        self._timer.start(5)
        progress.wait_for(self)
        progress.close()
        QtGui.QApplication.instance().removeEventFilter(self)
        assert self._is_open.is_set() and self._is_seen.is_set()
        return progress.is_cancelled

    def eventFilter(self, target, event) -> bool:  # noqa: N802 - Qt's name
        """Hears the last key's release, or what Escape makes of it before."""
        if event.type() == QtCore.QEvent.KeyRelease and not event.isAutoRepeat():
            self._is_typed.set()
        return False

    def _look(self) -> None:
        if not self._is_open.is_set() and dialog() is not None and dialog().isActiveWindow():
            self._is_open.set()
        elif self._is_typed.is_set():  # and what the key does is done
            self._timer.stop()
            self.is_shut = QtGui.QApplication.activeModalWidget() is dialog() is not None
            self._is_seen.set()


def test_return_and_space_cancel_no_progress_and_escape_does():
    """And the window stays shut until the work, which may go on for a moment, has ended."""
    yield from new_assembly()
    for key, cancels in (("Return", False), ("space", False), ("Escape", True)):
        typist = Typist(key)
        assert typist.type_under_progress() == cancels, key
        assert typist.is_shut, f"after {key} the window was open while the work went on"
        assert dialog() is None or not dialog().isVisible()
        yield from settled()

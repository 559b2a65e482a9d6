# SPDX-License-Identifier: LGPL-2.1-or-later
"""The first five minutes of the user guide, done literally: menus, mouse and keyboard."""

import os

import FreeCAD as App
import FreeCADGui as Gui
import numpy as np
from desk import WORK, activate, child, click_point, click_widget, enter, offered, picture, press
from desk import settled, until, view, xdotool
from freecad.sheetmorph import api, commands, paths
from freecad.sheetmorph.objects import model
from PySide import QtCore, QtGui
from scenes import assembly, fit, largest, part, regions, stored

__all__ = ["test_the_tutorial_as_a_new_user_does_it"]


def menu(*texts: str, waits=settled):
    """Chooses an entry of the menu bar with the mouse, and waits for what it does: by what it
    says, or by its command. The submenu that has it is opened on the way."""
    bar = Gui.getMainWindow().menuBar()
    kept = []  # PySide takes a menu for deleted whose action it forgets
    texts = [*texts[:-1], *way_to(texts[-1]), texts[-1]]
    for text in texts:
        (action,) = called(text, bar)
        middle = bar.mapToGlobal(bar.actionGeometry(action).center())
        yield from xdotool("mousemove", middle.x(), middle.y(), "click", 1)
        yield from settled() if text != texts[-1] else waits()
        bar = action.menu()
        kept += [action, bar]


def called(text: str, bar) -> list:
    """The entries of a menu with a text or a command."""
    return [a for a in bar.actions() if text in (a.text().replace("&", ""), a.objectName())]


def way_to(text: str) -> list[str]:
    """The title of the submenu with one of our commands; none for all others."""
    titles = {
        commands.registered()[name].label: title.replace("&", "")
        for title, names in commands.menu().items()
        for name in names
        if name != "Separator"
    }
    return list(filter(None, [titles.get(text)]))


def type_and_confirm(text: str):
    """Into the field that has the keyboard, in place of what it says."""
    yield from xdotool("key", "ctrl+a")
    yield from xdotool("type", "--delay", 10, "--", text)
    yield from xdotool("key", "Return")


def is_listed(dialog, name: str) -> bool:
    """Whether a file dialog shows a file."""
    view = dialog.findChild(QtGui.QAbstractItemView, "treeView")
    rows = range(view.model().rowCount(view.rootIndex()))
    return name in [view.model().index(row, 0, view.rootIndex()).data() for row in rows]


def choose(text: str):
    """Types into the dialog that waits, a file or a word, and confirms."""
    yield from until(QtGui.QApplication.activeModalWidget, "a dialog")
    yield from settled()
    dialog = QtGui.QApplication.activeModalWidget()
    if isinstance(dialog, QtGui.QFileDialog) and os.path.isfile(text):
        # First the folder: what is in it is read while one types, and Return goes by what is read.
        folder, text = os.path.split(text)
        yield from type_and_confirm(folder)
        same = QtCore.QDir(folder)
        yield from until(lambda: dialog.directory() == same, "the folder")
        yield from until(lambda: is_listed(dialog, text), "the file in its list")
    yield from type_and_confirm(text)


def answer(text: str):
    """Types into the dialog that waits, and confirms; no other comes after it."""
    yield from choose(text)
    yield from until(lambda: QtGui.QApplication.activeModalWidget() is None, "its end")
    yield from settled()


def mark(command: str, vertex: int):
    """Mark …: Facet, a click near a vertex, Grow four times, OK."""
    yield from menu("SheetMorph", command)
    yield from until(Gui.Control.activeDialog, "the panel")
    yield from click_widget(child("facet"))
    points, triangles = api.rest_mesh(part())
    facet = triangles[np.flatnonzero((triangles == vertex).any(axis=1))[0]]
    yield from click_point(points[facet].mean(axis=0))
    for _ in range(4):
        yield from click_widget(child("grow"))
    yield from settled()
    assert not child("message").isVisible(), child("message").text()


def near_edge(sign: float) -> int:
    """A vertex of the cover near its left (-1) or right (1) edge, half way up, seen in front."""
    points, _ = api.rest_mesh(part())
    low, high = points.min(axis=0), points.max(axis=0)
    wanted = 0.5 * (low + high)
    wanted[0] = (low if sign < 0 else high)[0] - sign * 0.03 * (high - low)[0]
    apart = np.linalg.norm((points - wanted)[:, [0, 2]], axis=1)
    near = np.flatnonzero(apart < apart.min() + 2.0)
    return int(near[np.argmin(points[near, 1])])


def test_the_tutorial_as_a_new_user_does_it():
    yield from activate()
    yield from menu("File", "Std_New")
    yield from menu("SheetMorph", "Import Part…")
    yield from answer(os.path.join(paths.examples(), "door_mirror", "cover.obj"))
    assert part().Label == "cover"
    view().graphicsView().setFocus()
    yield from xdotool("key", "1")
    fit()
    yield from settled()
    yield from mark("Mark Fixed Region…", near_edge(-1.0))
    yield from press("OK")
    yield from mark("Mark Handle…", near_edge(1.0))
    picture("tutorial-handle")
    yield from press("OK")
    yield from menu("SheetMorph", "Mark Form Features…")
    yield from enter(child("rings"), "1")
    yield from click_widget(child("holes"))
    picture("tutorial-features")
    yield from press("OK")
    assert [len(regions(role)) for role in ("fixed", "handle", "form feature")] == [1, 1, 4]
    before = stored()
    yield from menu("SheetMorph", "Move Handle…")
    yield from settled()
    yield from enter(child("translation_z"), "30 mm")
    yield from enter(child("angle"), "-15")
    yield from click_widget(child("along_y"))
    yield from settled()
    picture("tutorial-moved")
    (handle,) = regions("handle")
    assert (handle.TranslationZ.Value, handle.Angle.Value) == (30.0, -15.0), handle.Angle
    yield from press("OK")
    yield from settled()
    moved = stored()
    assert largest(moved - before) > 20.0
    yield from undo_and_redo(before, moved)
    yield from export()


def export():
    """Export Parts… writes the part and a report."""
    folder = os.path.join(WORK, "taken")
    os.makedirs(folder, exist_ok=True)
    yield from menu("SheetMorph", "Export Parts…")
    yield from answer(folder)
    assert sorted(os.listdir(folder)) == ["cover.obj", "report.json"]


def undo_and_redo(before, moved):
    """Ctrl+Z and Ctrl+Shift+Z bring back both to the bit."""
    view().graphicsView().setFocus()
    yield from offered("Std_Undo")
    yield from xdotool("key", "ctrl+z")
    yield from settled()
    assert np.array_equal(stored(), before)
    yield from offered("Std_Redo")
    yield from xdotool("key", "ctrl+shift+z")
    yield from settled()
    assert np.array_equal(stored(), moved)
    assert model.kind(assembly()) == model.ASSEMBLY and App.ActiveDocument is not None

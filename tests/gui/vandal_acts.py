# SPDX-License-Identifier: LGPL-2.1-or-later
"""What a vandal does, one act after the other by chance, with real mouse and keyboard.

An act that has nothing to act on does nothing. Dialogs that ask something are answered by chance.
"""

import os

import FreeCAD as App
import FreeCADGui as Gui
import hostile_acts
from desk import POLL, WORK, answered, say_yes, view, within_reach, xdotool
from freecad.sheetmorph import api
from freecad.sheetmorph.objects import model
from hostile_panels import PANELS
from PySide import QtCore, QtGui
from scenes import assembly, regions

TYPED = ("0", "-1", "12 mm", "0.5 in", "45", "1e9", "-1e30", "1/0", "abc", "", "3*4", "nan", ".e")
KEYS = ("Escape", "Return", "Tab", "shift+Tab", "space", "Up", "Down", "Delete", "ctrl+a", "0", "2")
WORKBENCHES = ("MeshWorkbench", "PartWorkbench", "SheetMorphWorkbench")
GONE = (IndexError, StopIteration, RuntimeError, AttributeError, ReferenceError)
SETTINGS = (QtGui.QAbstractButton, QtGui.QComboBox, QtGui.QLineEdit, QtGui.QAbstractSpinBox)
SETTINGS += (QtGui.QAbstractItemView, QtGui.QSlider)


class Answers(QtCore.QObject):
    """Answers what is asked, by chance, as long as it lives; no file is ever named."""

    def __init__(self, chance):
        super().__init__()
        self._chance = chance
        self._timer = QtCore.QTimer(self)
        self._timer.timeout.connect(self._answer)
        self._timer.start(70)

    def _answer(self) -> None:
        asked = QtGui.QApplication.activeModalWidget()
        if isinstance(asked, QtGui.QFileDialog) or type(asked) is QtGui.QDialog:
            asked.reject()
        elif isinstance(asked, QtGui.QProgressDialog):
            if self._chance.random() < 0.1:
                asked.findChild(QtGui.QAbstractButton).click()
        elif asked is not None:
            buttons = asked.findChildren(QtGui.QAbstractButton)
            buttons = [b for b in buttons if b.isVisible() and b.isEnabled()]
            self._chance.choice(buttons).click() if buttons else asked.close()


def open_panel(chance):
    """One of all, as its command or a double click in the tree does."""
    opener, used, _ = PANELS[chance.choice(sorted(PANELS))]
    try:
        opener()
        if chance.random() < 0.5:
            yield POLL
            used()
    except (*GONE, AssertionError):
        pass  # what it is about is gone, or another panel is open
    yield POLL


def press_tool(chance):
    """One of our toolbars', which opens a panel, a dialog or works at once."""
    tools = [b for b in Gui.getMainWindow().findChildren(QtGui.QToolButton) if can_be_pressed(b)]
    tools = [b for b in tools if ours(b.defaultAction())]
    if tools:
        yield from click(chance.choice(tools))


def ours(action) -> bool:
    name = action.objectName() if action is not None else ""
    elsewhere = ("SheetMorph_OpenExample", "SheetMorph_Manual")  # a dialog, the browser
    return name.startswith("SheetMorph_") and name not in elsewhere


def select(chance):
    """Some of the document's objects, as in the tree."""
    found = objects()
    Gui.Selection.clearSelection()
    for obj in chance.sample(found, min(len(found), chance.randint(0, 3))):
        Gui.Selection.addSelection(obj)
    yield POLL


def double_click_in_tree(chance):
    if objects():
        Gui.ActiveDocument.setEdit(chance.choice(objects()).Name)
    yield POLL


def click_in_panel(chance):
    found = settings()
    if found:
        yield from click(chance.choice(found))


def type_in_panel(chance):
    """Something sensible or not, left with Tab, Return or not at all."""
    fields = [w for w in settings() if isinstance(w, (QtGui.QLineEdit, QtGui.QAbstractSpinBox))]
    if fields:
        yield from click(chance.choice(fields))
        yield from xdotool("key", "ctrl+a")
        yield from xdotool("type", "--delay", 5, "--", chance.choice(TYPED) or " ")
        yield from xdotool("key", chance.choice(("Tab", "Return", "Shift_L")))


def press_key(chance):
    yield from xdotool("key", chance.choice(KEYS))


def click_in_view(chance):
    place = place_in_view(chance)
    if place:
        words = ["mousemove", *place]
        key = chance.choice(("", "", "shift", "ctrl"))
        words += ["keydown", key] if key else []
        words += ["click", chance.choice((1, 1, 1, 1, 4, 5))]
        words += ["keyup", key] if key else []
        yield from xdotool(*words)


def drag_in_view(chance):
    """Along a line; now and then something else is done with the button down."""
    places = [place_in_view(chance) for _ in range(3)]
    if not all(places):
        return
    yield from xdotool("mousemove", *places[0], "mousedown", 1)
    for k, place in enumerate(places[1:]):
        yield from xdotool("mousemove", *between(places[k], place), "mousemove", *place)
    if chance.random() < 0.3:
        yield from chance.choice((press_key, undo, redo, set_motion, close_panel))(chance)
    yield from xdotool("mouseup", 1)


def undo(chance):
    yield from step_in_time(chance, "Std_Undo", "ctrl+z")


def redo(chance):
    yield from step_in_time(chance, "Std_Redo", "ctrl+y")


def step_in_time(chance, command: str, keys: str):
    """Several at once too, by the toolbar or the keyboard."""
    for _ in range(chance.choice((1, 1, 2, 5))):
        if chance.random() < 0.5:
            Gui.runCommand(command)
        else:
            yield from xdotool("key", keys)
    yield POLL


def delete(chance):
    """Any object of the document; in the tree it is asked whether that may break something.

    Always in a step: FreeCAD dies of an undo after a deletion from a group without one.
    """
    found = objects()
    if not found:
        return
    chosen = chance.choice(found)
    if chance.random() < 0.5:
        Gui.Selection.clearSelection()
        Gui.Selection.addSelection(chosen)
        Gui.runCommand("Std_Delete")
    else:
        App.ActiveDocument.openTransaction("Delete")
        App.ActiveDocument.removeObject(chosen.Name)
        App.ActiveDocument.commitTransaction()
    yield POLL


def set_motion(chance):
    """In the property editor, or by an expression: a step of its own that is recomputed."""
    handles = found_handles()
    if handles:
        App.ActiveDocument.openTransaction("Edit")
        api.set_motion(chance.choice(handles), (0.0, chance.uniform(-3, 3), chance.uniform(-9, 9)))
        App.ActiveDocument.commitTransaction()
        App.ActiveDocument.recompute()
    yield POLL


def hide_or_show(chance):
    for obj in chance.sample(objects(), min(1, len(objects()))):
        obj.ViewObject.Visibility = not obj.ViewObject.Visibility
    yield POLL


def close_panel(chance):
    """From Python, or with its buttons."""
    if chance.random() < 0.2:
        Gui.Control.closeDialog()
    else:
        yield from press_button(chance, ("OK", "Cancel", "Close"))


def press_button(chance, texts):
    found = Gui.getMainWindow().findChildren(QtGui.QPushButton)
    found = [b for b in found if can_be_pressed(b) and b.text().replace("&", "") in texts]
    if found:
        yield from click(chance.choice(found))


def change_workbench(chance):
    Gui.activateWorkbench(chance.choice(WORKBENCHES))
    yield POLL


def change_document(chance):
    """A new one, another one on top, or one is closed."""
    names = sorted(App.listDocuments())
    if len(names) < 3 and chance.random() < 0.4:
        App.newDocument("Other")
    elif chance.random() < 0.3:
        App.closeDocument(chance.choice(names))
    else:
        App.setActiveDocument(chance.choice(names))
    yield POLL


def save(chance):
    """With or without an open panel."""
    if model_in(App.ActiveDocument):
        App.ActiveDocument.saveAs(os.path.join(WORK, "vandal-saved.FCStd"))
    yield POLL


def rename(chance):
    """Any object, in a step as the tree does it."""
    for obj in chance.sample(objects(), min(1, len(objects()))):
        App.ActiveDocument.openTransaction("Relabel")
        obj.Label = chance.choice(("Renamed", "“Quoted” <b>&amp;", "名前"))
        App.ActiveDocument.commitTransaction()
    yield POLL


def revert(chance):
    """The document as it was saved, if it was."""
    if model_in(App.ActiveDocument) and App.ActiveDocument.FileName:
        with answered(say_yes):
            Gui.runCommand("Std_Revert")
    yield POLL


def drag_in_tree(chance):
    """An object onto another one: out of its group, into a part, where it does not belong."""
    labels = [obj.Label for obj in chance.sample(objects(), min(2, len(objects())))]
    try:
        yield from hostile_acts.drag_in_tree(*labels)
    except (IndexError, TypeError, ValueError):
        return  # fewer than two, hidden, or the tree is


def change_views(chance):
    act = chance.choice(("another_document", "tall_view", "second_view", "split_view"))
    if model_in(App.ActiveDocument) and view() is not None:
        yield from getattr(hostile_acts, act)(None)


def spreadsheet(chance):
    """One on top, or the 3D view again."""
    mdi = Gui.getMainWindow().findChild(QtGui.QMdiArea)
    if chance.random() < 0.5:
        App.ActiveDocument.addObject("Spreadsheet::Sheet", "Cells").ViewObject.doubleClicked()
    elif mdi.subWindowList():
        mdi.setActiveSubWindow(chance.choice(mdi.subWindowList()))
    yield POLL


IN_PANEL = {click_in_panel: 9, type_in_panel: 7, drag_in_view: 5, click_in_view: 5, press_key: 3}
IN_PANEL |= {undo: 3, redo: 2, close_panel: 4, open_panel: 1, press_tool: 1}
ANYWHERE = {delete: 1, set_motion: 1, hide_or_show: 1, change_workbench: 1, change_document: 1}
ANYWHERE |= {rename: 0.5, revert: 0.5, drag_in_tree: 2}
ANYWHERE |= {save: 0.5, change_views: 0.5, spreadsheet: 0.5, select: 1, double_click_in_tree: 1}
OUTSIDE = {open_panel: 12, press_tool: 4, undo: 2, redo: 2, press_key: 1, click_in_view: 1}
# After these the way back by Cancel alone is known.
WITHIN = (click_in_panel, type_in_panel, drag_in_view, click_in_view)


def objects() -> list:
    return [] if App.ActiveDocument is None else list(App.ActiveDocument.Objects)


def model_in(document) -> bool:
    return document is not None and any(model.kind(o) == model.ASSEMBLY for o in document.Objects)


def found_handles() -> list:
    return regions("handle") if model_in(App.ActiveDocument) else []


def settings() -> list:
    """What can be pressed and typed into in the panel that is open."""
    forms = [
        area.widget()
        for area in Gui.getMainWindow().findChildren(QtGui.QScrollArea)
        if area.isVisible() and area.widget() is not None
    ]
    found = [widget for form in forms for widget in form.findChildren(QtGui.QWidget)]
    return [w for w in found if isinstance(w, SETTINGS) and can_be_pressed(w)]


def can_be_pressed(widget) -> bool:
    return widget.isVisible() and widget.isEnabled()


def click(widget):
    try:
        yield from within_reach(widget)
        middle = widget.mapToGlobal(widget.rect().center())
    except (*GONE, AssertionError):
        return  # gone meanwhile
    yield from xdotool("mousemove", middle.x(), middle.y(), "click", 1)


def place_in_view(chance):
    """Pixels of the screen: mostly on the first part, else anywhere in the view."""
    if Gui.ActiveDocument is None or not hasattr(view(), "graphicsView"):
        return None
    viewport = view().graphicsView().viewport()
    place = QtCore.QPoint(
        chance.randrange(max(1, viewport.width())), chance.randrange(max(1, viewport.height()))
    )
    seen = model.parts(assembly()) if model_in(App.ActiveDocument) else []
    if chance.random() < 0.7 and seen and seen[0].Source is not None:
        points = api.rest_mesh(seen[0])[0]
        x, y = view().getPointOnScreen(App.Vector(*chance.choice(points.tolist())))
        seen = QtCore.QPoint(x, viewport.height() - 1 - y)
        place = seen if viewport.rect().contains(seen) else place
    seen = viewport.mapToGlobal(place)
    return seen.x(), seen.y()


def between(one, other) -> tuple:
    return (one[0] + other[0]) // 2, (one[1] + other[1]) // 2

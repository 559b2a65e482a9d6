# SPDX-License-Identifier: LGPL-2.1-or-later
"""A user's hands and eyes: real mouse and keyboard events, what is seen, pictures of the screen.

Everything that takes time is a generator to ``yield from``, so that FreeCAD's event loop runs.
"""

import os
import subprocess
from contextlib import contextmanager

import FreeCAD as App
import FreeCADGui as Gui
import settling
from PySide import QtCore, QtGui

HERE = os.path.dirname(os.path.abspath(__file__))
WORK = os.environ["SHEETMORPH_GUI_WORK"]


POLL = 10  # ms between two looks at what is waited for
WAITED = {"for": ""}  # the last thing


def xdotool(*words):
    """Real events; waits until they have been sent and handled."""
    for some, is_done in parts_of([str(word) for word in words]):
        process = subprocess.Popen(["xdotool", *some])
        yield from until(lambda: process.poll() is not None, "xdotool to end")
        assert process.returncode == 0, some
        yield from until(is_done, f"{some} to arrive")
    for _ in range(settling.LOOKS * (3 if "click" in words else 1)):
        settling.receive()
        yield POLL


def parts_of(words: list[str]):
    """Words for xdotool up to every press and release of a button, and what tells of its arrival.

    A window manager may hold a press back for a moment; keys come straight from the screen. A click
    goes as one, and nobody knows when it has come: a list that opens under a press that lasts takes
    what is under the release. A hand is there before it presses: what lies over the 3D view since
    FreeCAD 1.0 is laid out anew when the mouse comes to it.
    """
    while words:
        place = next((k for k, word in enumerate(words) if word in (*BUTTONS, "click")), None)
        if place is None:
            yield words, lambda: True
            return
        if "mousemove" in words[:place] and words[place] != "mouseup":
            yield words[:place], settling.Looks(settling.is_anything_due)
            words = words[place:]
        elif words[place] == "click":
            yield words, lambda: True
            return
        else:
            some, words = words[: place + 2], words[place + 2 :]
            yield some, BUTTONS[some[-2]]


def is_pressed() -> bool:
    return bool(QtGui.QApplication.mouseButtons())


def is_released() -> bool:
    return not is_pressed()


BUTTONS = {"mousedown": is_pressed, "mouseup": is_released}


def settled():
    """Waits until the program has done what it was asked, however long that takes."""
    yield from until(settling.Looks(settling.is_under_way), "the program to be calm")


def import_files(files: list[str], edge: float, arrived):
    """Import Part…, its dialogs answered: files, and the edge of CAD files in mm; then waits."""
    from freecad.sheetmorph.qt import QtWidgets

    asked, length = QtWidgets.QFileDialog.getOpenFileNames, QtWidgets.QInputDialog.getText
    QtWidgets.QFileDialog.getOpenFileNames = lambda *_: (files, "")
    QtWidgets.QInputDialog.getText = lambda *_: (f"{edge} mm", True)
    try:
        yield from press_tool("Import Part…", laid_out)
        yield from until(arrived, "the parts")
    finally:
        QtWidgets.QFileDialog.getOpenFileNames = asked
        QtWidgets.QInputDialog.getText = length


def replace_file(file: str, edge: float):
    """Replace File…, its dialogs answered: the file, and the edge of a CAD file in mm."""
    from freecad.sheetmorph.qt import QtWidgets

    asked, length = QtWidgets.QFileDialog.getOpenFileName, QtWidgets.QInputDialog.getText
    named = []
    QtWidgets.QFileDialog.getOpenFileName = lambda *_: named.append(file) or (file, "")
    QtWidgets.QInputDialog.getText = lambda *_: (f"{edge} mm", True)
    try:
        yield from press_tool("Replace File…", laid_out)
        yield from until(lambda: named, "the question for a file")
        yield from settled()
    finally:
        QtWidgets.QFileDialog.getOpenFileName = asked
        QtWidgets.QInputDialog.getText = length


def show_docks() -> None:
    """The tree and the properties, which may be hidden while there is no panel."""
    for dock in Gui.getMainWindow().findChildren(QtGui.QDockWidget):
        if dock.objectName() in ("Combo View", "Tree view", "Property view", "Model"):
            dock.show()


@contextmanager
def answered(answer):
    """In this context a question is answered by a function of its box, however late it comes."""

    def look() -> None:
        box = QtGui.QApplication.activeModalWidget()
        if isinstance(box, QtGui.QMessageBox):
            answer(box)

    timer = QtCore.QTimer()
    timer.timeout.connect(look)
    timer.start(POLL)
    try:
        yield
    finally:
        timer.stop()


def say_yes(box) -> None:
    """The answer Yes."""
    box.button(QtGui.QMessageBox.Yes).click()


class Recorder:
    """FreeCAD's macro recording: since 1.0 the command that starts it also ends it."""

    is_on = False

    @classmethod
    def start(cls) -> None:
        """Opens the dialog that asks for a name."""
        cls.is_on = True
        QtCore.QTimer.singleShot(0, lambda: Gui.runCommand("Std_DlgMacroRecord"))

    @classmethod
    def stop(cls) -> None:
        """Ends a recording, if there is one."""
        if cls.is_on:
            own = "Std_MacroStopRecord" in Gui.listCommands()
            Gui.runCommand("Std_MacroStopRecord" if own else "Std_DlgMacroRecord")
        cls.is_on = False


NOTES = []


def note(text: str) -> None:
    """A line for the report of the run, beside the verdict of the test; and for who waits."""
    NOTES.append(text)
    print(text, flush=True)


def picture(name: str) -> str:
    """Takes a picture of the screen; returns its file."""
    path = os.path.join(WORK, f"{name}.png")
    subprocess.run(["import", "-window", "root", path], check=False)
    return path


def until(condition, what: str):
    """Waits until a condition holds, however slow the machine is: a test has a limit as a whole."""
    while not condition():
        WAITED["for"] = what
        yield POLL


def offered(command: str):
    """Waits until FreeCAD offers a command: it looks at times whether one can be chosen, and its
    keys do nothing before."""
    action = Gui.getMainWindow().findChild(QtGui.QAction, command)
    yield from until(action.isEnabled, f"{command} to be offered")


def view():
    """The active 3D view."""
    return Gui.activeDocument().activeView()


def on_screen(point) -> tuple[int, int]:
    """Where a point (3,), global mm, is seen: pixels of the screen."""
    x, y = view().getPointOnScreen(App.Vector(*[float(c) for c in point]))
    viewport = view().graphicsView().viewport()
    ratio = viewport.devicePixelRatioF()
    place = QtCore.QPoint(round(x / ratio), round(viewport.height() - 1 - y / ratio))
    seen = viewport.mapToGlobal(place)
    return seen.x(), seen.y()


def click_point(point, key: str = ""):
    """Clicks where a point (3,), global mm, is seen, with a modifier key held down."""
    x, y = on_screen(point)
    yield from xdotool("mousemove", x - 3, y - 3)
    words = ["mousemove", x, y]
    if key:
        words += ["keydown", key]
    yield from xdotool(*words)
    yield from xdotool("click", 1)
    if key:
        yield from xdotool("keyup", key)


def within_reach(widget):
    """Scrolls a panel to where the mouse can reach a widget of it."""
    for button in Gui.getMainWindow().findChildren(QtGui.QToolButton):
        if button.objectName().startswith("fold_") and button.isVisible():
            group = panel().findChild(QtGui.QGroupBox, button.objectName()[5:])
            if group.isAncestorOf(widget) and not (widget is button or button.isChecked()):
                yield from click_widget(button)
    # Not by widget.parent(): PySide takes the children of a parent asked for so for deleted.
    for area in Gui.getMainWindow().findChildren(QtGui.QScrollArea):
        if area.isVisible() and area.isAncestorOf(widget):
            bar = area.verticalScrollBar()
            before = bar.value()
            area.ensureWidgetVisible(widget)
            if bar.value() != before:
                yield from laid_out()


def laid_out():
    """Waits until nothing moves on the screen: a new panel makes room for itself."""
    yield from until(settling.Looks(settling.is_anything_due), "everything to be in its place")


def done():
    """Waits until the window waits for nothing, such as work whose progress is shown."""
    yield from until(settling.Looks(settling.is_at_work), "the window to be free")


def click_widget(widget):
    """Clicks the middle of a widget as soon as it can be pressed."""
    name = widget.objectName() or type(widget).__name__
    yield from within_reach(widget)
    yield from until(lambda: widget.isVisible() and widget.isEnabled(), f"{name} to be enabled")
    yield from laid_out()
    middle = widget.mapToGlobal(widget.rect().center())
    is_button = isinstance(widget, QtGui.QAbstractButton) and not has_menu(widget)
    click = ("mousedown", 1, "mouseup", 1) if is_button else ("click", 1)
    yield from xdotool("mousemove", middle.x(), middle.y(), *click)


def has_menu(button) -> bool:
    """Whether a press that lasts opens a list."""
    return isinstance(button, QtGui.QToolButton) and button.menu() is not None


def tick(box):
    """Clicks a check box where its text is, as beside it a click does nothing; waits for all that
    follows."""
    yield from within_reach(box)
    assert box.isVisible() and box.isEnabled(), box.objectName()
    place = box.mapToGlobal(QtCore.QPoint(20, box.height() // 2))
    yield from xdotool("mousemove", place.x(), place.y(), "click", 1)
    yield from settled()


def enter(field, text: str):
    """Types text into a field as a user would, and leaves it with Tab."""
    yield from click_widget(field)
    yield from until(field.hasFocus, f"{field.objectName()} to be typed into")
    yield from xdotool("key", "ctrl+a")
    yield from xdotool("type", "--delay", 15, "--", text)
    yield from xdotool("key", "Tab")


def choose_below(combo, steps: int):
    """Opens a combo box with the mouse and goes so many entries down, or up if negative; waits for
    all that follows.

    Of a property FreeCAD 1.1 opens it by itself.
    """
    if not combo.view().isVisible():
        yield from click_widget(combo)
    yield from until(combo.view().isVisible, f"the list of {combo.objectName()} to open")
    yield from xdotool("key", *["Down" if steps > 0 else "Up"] * abs(steps), "Return")
    yield from settled()


def press(text: str, waits=done):
    """Presses the visible button with a text in the task view, as soon as there is one, and
    waits for what it does."""
    yield from until(lambda: len(buttons_called(text)) == 1, f"one button {text}")
    (button,) = buttons_called(text)
    yield from within_reach(button)
    yield from click_widget(button)
    yield from waits()


def buttons_called(text: str) -> list:
    """The visible buttons with a text."""
    return [
        button
        for button in Gui.getMainWindow().findChildren(QtGui.QPushButton)
        if button.isVisible() and button.text().replace("&", "") == text
    ]


def press_tool(text: str, waits=done):
    """Presses the toolbar button of a command, as soon as there is one, and waits for what it
    does."""
    yield from until(lambda: tools_called(text), f"a button {text}")
    yield from click_widget(tools_called(text)[0])
    yield from waits()


def tools_called(text: str) -> list:
    """The visible toolbar buttons of a command."""
    found = [b for b in Gui.getMainWindow().findChildren(QtGui.QToolButton) if b.isVisible()]
    found = [b for b in found if b.defaultAction() is not None]
    return [b for b in found if b.defaultAction().text().replace("&", "") == text]


def panel():
    """The form of the open task panel of ours."""
    forms = [
        widget
        for name in (
            "region",
            "move",
            "contact",
            "propagation",
            "feature",
            "thickness",
            "prepare",
            "find",
            "guide",
            "pose",
            "study",
        )
        for widget in Gui.getMainWindow().findChildren(QtGui.QWidget, name)
        if widget.isVisible()
    ]
    assert len(forms) == 1, forms
    return forms[0]


def child(name: str):
    """A widget of the open panel."""
    return panel().findChild(QtGui.QWidget, name)


def report_view() -> str:
    """The text of the report view."""
    texts = Gui.getMainWindow().findChildren(QtGui.QTextEdit, "Report view")
    return "\n".join(text.toPlainText() for text in texts)


def clear_report_view() -> None:
    """Forgets what was said."""
    for text in Gui.getMainWindow().findChildren(QtGui.QTextEdit, "Report view"):
        text.clear()


def activate():
    """Activates the workbench and lets it settle."""
    Gui.activateWorkbench("SheetMorphWorkbench")
    yield from settled()


def draw_along(points, key: str = ""):
    """Drags with the left button from place to place, (x, y, z) global mm, a modifier key
    down; waits for all that follows."""
    places = [on_screen(point) for point in points]
    yield from xdotool("mousemove", *places[0])
    if key:
        yield from xdotool("keydown", key)
    yield from xdotool("mousedown", 1)
    for (x, y), (to_x, to_y) in zip(places, places[1:]):
        steps = max(1, (abs(to_x - x) + abs(to_y - y)) // 12)
        words = []
        for k in range(1, steps + 1):
            words += ["mousemove", x + (to_x - x) * k // steps, y + (to_y - y) * k // steps]
            words += ["sleep", 0.004]
        yield from xdotool(*words)
    yield from xdotool("mouseup", 1)
    if key:
        yield from xdotool("keyup", key)
    yield from settled()


def colour_at(point) -> tuple[int, int, int]:
    """The colour that is seen at a point (3,), global mm."""
    image = QtGui.QImage(picture("colour"))
    colour = image.pixelColor(*on_screen(point))
    return colour.red(), colour.green(), colour.blue()

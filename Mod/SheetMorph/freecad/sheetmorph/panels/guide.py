# SPDX-License-Identifier: LGPL-2.1-or-later
"""The guide, whose panel closes for the panels of commands and returns after them."""

import FreeCAD as App
import FreeCADGui as Gui

from freecad.sheetmorph.panels.guide_panel import GuidePanel
from freecad.sheetmorph.qt import QtCore, QtWidgets, connect

CALM = 100  # ms without a change of the document until the panel shows it
GONE = 50  # ms until the widgets of a closed panel are gone
LOOK = 200  # ms between two checks whether a command's panel is closed


class Guide:
    """The guide from `open` until the user closes its panel; at most one exists."""

    _open = None

    def __init__(self, commands):
        self._panel = None
        self._commands = commands
        self._changes = _Changes(self._change)
        self._calm = _timer(CALM, True, self._refresh)
        self._look = _timer(LOOK, False, self._come_back)
        App.addDocumentObserver(self._changes)
        Gui.Selection.addObserver(self._changes)

    @classmethod
    def open(cls, commands) -> None:
        """Open the guide; `commands` maps names to all commands, for its buttons."""
        cls._open = cls._open or cls(commands)
        cls._open._come_back()

    @classmethod
    def is_shown(cls) -> bool:
        """Return whether the open panel is the guide's, so that commands are available."""
        return cls._open is not None and cls._open._panel is not None

    @classmethod
    def make_room(cls, action) -> None:
        """Call `action`, which may open a panel; the guide returns after it closes.

        The call waits until the guide's widgets are gone. PySide identifies widgets by address, and
        would mistake those of the next panel for them.
        """
        if cls.is_shown():
            cls._open._give_way()
            QtCore.QTimer.singleShot(GONE, action)
        elif not Gui.Control.activeDialog():
            action()

    def _give_way(self) -> None:
        panel, self._panel = self._panel, None
        panel.session.end()
        self._look.start()

    def _come_back(self) -> None:
        """Show the panel when no other one is open."""
        if self._panel is None and not Gui.Control.activeDialog() and not is_modal():
            self._look.stop()
            self._panel = GuidePanel(Gui.runCommand, self._closed)
            self._panel.present()
            self._refresh()

    def _change(self) -> None:
        self._calm.start()

    def _refresh(self) -> None:
        if Guide.is_shown():
            self._panel.refresh(self._commands)

    def _closed(self) -> None:
        """End the guide when the user closes its panel."""
        if self._panel is not None:
            self._end()

    def _end(self) -> None:
        """Release all resources."""
        self._panel = None
        self._calm.stop()
        self._look.stop()
        App.removeDocumentObserver(self._changes)
        Gui.Selection.removeObserver(self._changes)
        Guide._open = None


class _Changes:
    """An observer of all changes of documents and selection that the guide may show."""

    def __init__(self, told):
        self._told = told

    def _tell(self, *_) -> None:
        self._told()

    slotCreatedObject = slotDeletedObject = slotChangedObject = _tell
    slotActivateDocument = slotDeletedDocument = slotRecomputedDocument = _tell
    slotUndoDocument = slotRedoDocument = _tell
    addSelection = removeSelection = setSelection = clearSelection = _tell


def is_modal() -> bool:
    """Return whether a dialog waits for an answer."""
    return QtWidgets.QApplication.activeModalWidget() is not None


def _timer(milliseconds: int, is_single: bool, action):
    timer = QtCore.QTimer()
    timer.setInterval(milliseconds)
    timer.setSingleShot(is_single)
    connect(timer, "timeout()", action)
    return timer

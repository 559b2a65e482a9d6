# SPDX-License-Identifier: LGPL-2.1-or-later
"""The guide: its panel gives way to the panels of commands and comes back after them."""

import FreeCAD as App
import FreeCADGui as Gui

from freecad.sheetmorph.panels.guide_panel import GuidePanel
from freecad.sheetmorph.qt import QtCore, QtWidgets, connect

CALM = 100  # ms without a change of the document until the panel shows it
GONE = 50  # ms until the widgets of a closed panel are gone
LOOK = 200  # ms between two looks whether the panel of a command is closed


class Guide:
    """Open from ``open`` until the user closes its panel; there is one at most."""

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
        """Opens the guide; ``commands``: all of the workbench by name, for its buttons."""
        cls._open = cls._open or cls(commands)
        cls._open._come_back()

    @classmethod
    def is_shown(cls) -> bool:
        """Whether the panel that is open is the guide's, so that commands may be used."""
        return cls._open is not None and cls._open._panel is not None

    @classmethod
    def make_room(cls, action) -> None:
        """Calls ``action``, which may open a panel; the guide comes back when that is closed.

        Only when the widgets of the guide are gone: PySide knows widgets by address and would
        take those of the next panel for them.
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
        """Shows the panel as soon as no other one is open."""
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
        """The panel is closed; unless it gave way to another one the guide ends with it."""
        if self._panel is not None:
            self._end()

    def _end(self) -> None:
        """Nothing is left behind."""
        self._panel = None
        self._calm.stop()
        self._look.stop()
        App.removeDocumentObserver(self._changes)
        Gui.Selection.removeObserver(self._changes)
        Guide._open = None


class _Changes:
    """Tells of everything in documents and selection that the guide may show."""

    def __init__(self, told):
        self._told = told

    def _tell(self, *_) -> None:
        self._told()

    slotCreatedObject = slotDeletedObject = slotChangedObject = _tell
    slotActivateDocument = slotDeletedDocument = slotRecomputedDocument = _tell
    slotUndoDocument = slotRedoDocument = _tell
    addSelection = removeSelection = setSelection = clearSelection = _tell


def is_modal() -> bool:
    """Whether a dialog waits for an answer."""
    return QtWidgets.QApplication.activeModalWidget() is not None


def _timer(milliseconds: int, is_single: bool, action):
    timer = QtCore.QTimer()
    timer.setInterval(milliseconds)
    timer.setSingleShot(is_single)
    connect(timer, "timeout()", action)
    return timer

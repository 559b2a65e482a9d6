# SPDX-License-Identifier: LGPL-2.1-or-later
"""What the task panels share."""

import FreeCADGui as Gui

from freecad.sheetmorph import paths
from freecad.sheetmorph.qt import QtCore, QtGui, QtWidgets, forget
from freecad.sheetmorph.scene import colours

WIDTH = 340  # px at which a panel is readable


class Panel:
    """A task panel with OK and Cancel; subclasses give ``close`` and ``accept``."""

    width = WIDTH

    def __init__(self, widgets: str, icon: str, title: str):
        self.form = Gui.PySideUic.loadUi(paths.panel(widgets))
        self.form.setWindowTitle(title)
        self.form.setWindowIcon(QtGui.QIcon(paths.icon(icon)))

    def present(self) -> None:
        """Shows the panel, in a task view wide enough to read it."""
        Gui.Control.showDialog(self)
        QtCore.QTimer.singleShot(0, self._widen)

    def getStandardButtons(self) -> int:
        """OK and Cancel."""
        buttons = QtWidgets.QDialogButtonBox.Ok | QtWidgets.QDialogButtonBox.Cancel
        return int(buttons)

    def isAllowedAlterSelection(self) -> bool:
        """The selection plays no role while a panel is open."""
        return False

    def isAllowedAlterDocument(self) -> bool:
        """Other commands would end up in the panel's transaction."""
        return False

    def _widen(self) -> None:
        """Makes the dock around the panel wide enough; a wider one stays as it is."""
        window = Gui.getMainWindow()
        for dock in window.findChildren(QtWidgets.QDockWidget):
            if self.form and dock.isAncestorOf(self.form) and dock.width() < self.width:
                window.resizeDocks([dock], [self.width], QtCore.Qt.Horizontal)

    def isAllowedAlterView(self) -> bool:
        """The user may turn and zoom."""
        return True

    def finish(self) -> bool:
        """Closes the task view and lets go of its widgets, which FreeCAD deletes."""
        form, self.form = self.form, None
        forget(form, Gui.Control.closeDialog)
        return True


def say(label, text: str, is_error: bool = False) -> None:
    """Shows a sentence in a label, errors in red; an empty one takes no room."""
    label.setText(text)
    label.setStyleSheet("color: #c62828; font-weight: bold;" if is_error else "")
    label.setVisible(bool(text))


def legend(active: str) -> str:
    """The colours of the roles as rich text, the active role in bold."""
    names = {"fixed": "Fixed", "handle": "Handle", "form feature": "Form&nbsp;feature"}
    if active == "follower":
        names |= {"follower": "Follower"}
    chips = []
    for role, text in names.items():
        shown = f"<b>{text}</b>" if role == active else text
        chips.append(f"{chip(colours.ROLES[role])}&nbsp;{shown}")
    return "&nbsp;&nbsp; ".join(chips)


def chip(colour) -> str:
    """A little square in a colour as rich text."""
    return f'<span style="color:{colours.css(colour)}">&#9632;</span>'

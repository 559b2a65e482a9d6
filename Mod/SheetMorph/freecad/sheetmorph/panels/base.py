# SPDX-License-Identifier: LGPL-2.1-or-later
"""What the task panels share."""

import FreeCAD as App
import FreeCADGui as Gui

from freecad.sheetmorph import paths
from freecad.sheetmorph.qt import QtCore, QtGui, QtWidgets, forget, translate
from freecad.sheetmorph.scene import colours
from freecad.sheetmorph.tools.marked import QT_TRANSLATE_NOOP

LEGEND = {
    "fixed": QT_TRANSLATE_NOOP("panels", "Fixed"),
    "handle": QT_TRANSLATE_NOOP("panels", "Handle"),
    "form feature": QT_TRANSLATE_NOOP("panels", "Form feature"),
    "follower": QT_TRANSLATE_NOOP("panels", "Follower"),
}
WIDTH = 340  # px at which a panel is readable
FAULT_STYLE = "color: #8f1d1d; background: #fde7e7; padding: 3px; border-radius: 3px;"  # any theme
MARGINS = 110  # px of the task view around a panel, with its scroll bar


class Panel:
    """A task panel with OK and Cancel; subclasses give ``close`` and ``accept``."""

    width = WIDTH
    _aside: tuple | list = ()

    def __init__(self, widgets: str, icon: str, title: str):
        self.form = Gui.PySideUic.loadUi(paths.panel(widgets))
        self.form.setWindowTitle(translate(widgets, title))
        self.form.setWindowIcon(QtGui.QIcon(paths.icon(icon)))
        for name, widget in vars(self.form).items():
            if isinstance(widget, QtWidgets.QWidget) and not name.startswith("_"):
                widget.setWhatsThis(widget.whatsThis() or widget.toolTip())
                widget.setStatusTip(widget.statusTip() or widget.toolTip())

    def present(self) -> None:
        """Shows the panel, in a task view wide enough to read it.

        Where the selection plays no role its colour would hide the others: it is put aside.
        """
        if not self.isAllowedAlterSelection():
            self._aside = [(obj.Document.Name, obj.Name) for obj in Gui.Selection.getSelection()]
            Gui.Selection.clearSelection()
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
            if self.form and dock.isAncestorOf(self.form):
                wanted = max(self.width, self.form.minimumSizeHint().width() + MARGINS)
                if dock.width() < wanted:
                    window.resizeDocks([dock], [wanted], QtCore.Qt.Horizontal)

    def isAllowedAlterView(self) -> bool:
        """The user may turn and zoom."""
        return True

    def finish(self) -> bool:
        """Closes the task view and lets go of its widgets, which FreeCAD deletes."""
        form, self.form = self.form, None
        forget(form, Gui.Control.closeDialog)
        for document, name in self._aside:
            if document in App.listDocuments() and App.getDocument(document).getObject(name):
                Gui.Selection.addSelection(document, name)
        return True


def say(label, text: str, is_error: bool = False) -> None:
    """Shows a sentence in a label, errors on red; an empty one takes no room."""
    label.setText(text)
    label.setStyleSheet(FAULT_STYLE if is_error else "")
    label.setVisible(bool(text))


def legend(active: str) -> str:
    """The colours of the roles as rich text, the active role in bold."""
    chips = []
    for role, name in LEGEND.items():
        if role == "follower" and role != active:
            continue
        text = translate("panels", name).replace(" ", "&nbsp;")
        shown = f"<b>{text}</b>" if role == active else text
        chips.append(f"{chip(colours.ROLES[role])}&nbsp;{shown}")
    return "&nbsp;&nbsp; ".join(chips)


def chip(colour) -> str:
    """A little square in a colour as rich text."""
    return f'<span style="color:{colours.css(colour)}">&#9632;</span>'

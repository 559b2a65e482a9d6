# SPDX-License-Identifier: LGPL-2.1-or-later
"""FreeCAD's own section planes, beside an open panel."""

import FreeCADGui as Gui

from freecad.sheetmorph.qt import QtCore, QtWidgets

COMMAND = "Std_ToggleClipPlane"
FIELD = "clipX"  # a field that only FreeCAD's panel of section planes has


def open_section_planes() -> None:
    """Show the section planes at the right of the window.

    FreeCAD puts them below the task panel, which then has no room.
    """
    Gui.runCommand(COMMAND)
    window = Gui.getMainWindow()
    for dock in window.findChildren(QtWidgets.QDockWidget):
        if dock.isVisible() and dock.findChild(QtWidgets.QWidget, FIELD) is not None:
            window.addDockWidget(QtCore.Qt.RightDockWidgetArea, dock)

# SPDX-License-Identifier: LGPL-2.1-or-later
"""Where the toolbars are when the workbench is used for the first time."""

import FreeCAD as App
import FreeCADGui as Gui

from freecad.sheetmorph.qt import QtWidgets

PREFERENCES = "User parameter:BaseApp/Preferences/Mod/SheetMorph"


def place(titles: list[str]) -> None:
    """Gives the toolbars a row of their own, once: FreeCAD's row is full, ours would be cut off.

    Later the user's arrangement stays.
    """
    preferences = App.ParamGet(PREFERENCES)
    window = Gui.getMainWindow()
    bars = [window.findChild(QtWidgets.QToolBar, title) for title in titles]
    if preferences.GetBool("ToolbarsPlaced", False) or None in bars:
        return
    for bar in bars:
        window.removeToolBar(bar)
    window.addToolBarBreak()
    for bar in bars:
        window.addToolBar(bar)
        bar.show()
    preferences.SetBool("ToolbarsPlaced", True)

# SPDX-License-Identifier: LGPL-2.1-or-later
"""The position of the toolbars at the first use of the workbench."""

import FreeCAD as App
import FreeCADGui as Gui

from freecad.sheetmorph.qt import QtWidgets

PREFERENCES = "User parameter:BaseApp/Preferences/Mod/SheetMorph"


def place(titles: list[str]) -> None:
    """Put the toolbars in a separate row, once, because FreeCAD's row is full.

    Afterwards the user's arrangement stays.
    """
    preferences = App.ParamGet(PREFERENCES)
    window = Gui.getMainWindow()
    bars = [window.findChild(QtWidgets.QToolBar, title) for title in titles]
    if preferences.GetBool("ThreeToolbarsPlaced", False) or None in bars:
        return
    for bar in bars:
        window.removeToolBar(bar)
    window.addToolBarBreak()
    for bar in bars:
        window.addToolBar(bar)
        bar.show()
    preferences.SetBool("ThreeToolbarsPlaced", True)

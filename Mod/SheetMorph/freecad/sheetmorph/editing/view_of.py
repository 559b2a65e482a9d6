# SPDX-License-Identifier: LGPL-2.1-or-later
"""The 3D view of a document, whatever tab is on top."""

import FreeCAD as App
import FreeCADGui as Gui

from freecad.sheetmorph.qt import QtWidgets

VIEW = "Gui::View3DInventor"


def shown_view(document):
    """Brings a 3D view of a document to the top, made if there is none; returns it."""
    App.setActiveDocument(document.Name)
    found = Gui.getDocument(document.Name).mdiViewsOfType(VIEW)
    if not found:
        Gui.runCommand("Std_ViewCreate")
        found = Gui.getDocument(document.Name).mdiViewsOfType(VIEW)
    active = mdi_area().activeSubWindow()
    view = next((one for one in found if is_in(one, active)), found[0])
    for window in mdi_area().subWindowList():
        if is_in(view, window) and window is not active:
            mdi_area().setActiveSubWindow(window)
    return view


def mdi_area():
    """Where the tabs are."""
    return Gui.getMainWindow().findChild(QtWidgets.QMdiArea)


def is_alive(view) -> bool:
    """Whether a view has not been closed."""
    try:
        return bool(view.getSize())
    except RuntimeError:
        return False


def is_in(view, window) -> bool:
    """Whether a view is shown in a window."""
    return window is not None and window.isAncestorOf(view.graphicsView())

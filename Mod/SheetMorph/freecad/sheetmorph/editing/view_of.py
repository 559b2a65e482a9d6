# SPDX-License-Identifier: LGPL-2.1-or-later
"""The 3D view of a document, whichever tab is on top."""

import FreeCAD as App
import FreeCADGui as Gui

from freecad.sheetmorph.qt import QtWidgets

VIEW = "Gui::View3DInventor"


def shown_view(document):
    """Bring a 3D view of a document to the top, creating it if necessary, and return it."""
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
    """Return the area with the tabs of the main window."""
    return Gui.getMainWindow().findChild(QtWidgets.QMdiArea)


def is_alive(view) -> bool:
    """Return whether a view is still open."""
    try:
        return bool(view.getSize())
    except RuntimeError:
        return False


def is_in(view, window) -> bool:
    """Return whether a window shows a view."""
    return window is not None and window.isAncestorOf(view.graphicsView())

# SPDX-License-Identifier: LGPL-2.1-or-later
"""Widgets that lie over a 3D view and let the mouse through."""

from freecad.sheetmorph.qt import QtCore


def laid_over(view, make, name: str, look: str):
    """A widget over a view, of that object name and style sheet; ``make`` takes its parent."""
    widget = make(view.graphicsView().viewport())
    widget.setObjectName(name)
    widget.setStyleSheet(look)
    widget.setAttribute(QtCore.Qt.WA_TransparentForMouseEvents)
    return widget


def take_away(widget) -> None:
    """Removes such a widget; the view may be closed already."""
    try:
        widget.hide()
        widget.setParent(None)
        widget.deleteLater()
    except RuntimeError:
        return

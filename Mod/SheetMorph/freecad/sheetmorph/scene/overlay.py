# SPDX-License-Identifier: LGPL-2.1-or-later
"""Widgets on top of a 3D view that ignore the mouse."""

from freecad.sheetmorph.qt import QtCore


def laid_over(view, make, name: str, look: str):
    """Return a widget over a view with an object name and style; `make` takes its parent."""
    widget = make(view.graphicsView().viewport())
    widget.setObjectName(name)
    widget.setStyleSheet(look)
    widget.setAttribute(QtCore.Qt.WA_TransparentForMouseEvents)
    return widget


def take_away(widget) -> None:
    """Remove such a widget; the view may be closed already."""
    try:
        widget.hide()
        widget.setParent(None)
        widget.deleteLater()
    except RuntimeError:
        return

# SPDX-License-Identifier: LGPL-2.1-or-later
"""A value next to the cursor, on top of the 3D view."""

from freecad.sheetmorph.qt import QtCore, QtGui, QtWidgets
from freecad.sheetmorph.scene.overlay import laid_over, take_away

BESIDE = QtCore.QPoint(18, 14)  # px from the tip of the cursor
LOOK = (
    "QLabel { background: rgba(22, 26, 34, 215); color: #f2f4f7; border-radius: 4px;"
    " padding: 2px 6px; font-weight: bold; }"
)


class CursorValue:
    """A label that ignores the mouse, until `remove`."""

    def __init__(self, view):
        self._label = laid_over(view, QtWidgets.QLabel, "SheetMorphCursorValue", LOOK)
        self._label.hide()

    def show(self, text: str) -> None:
        """Show a text next to the cursor; an empty one hides the label."""
        if text:
            over = self._label.parentWidget()
            place = over.mapFromGlobal(QtGui.QCursor.pos()) + BESIDE
            self._label.setText(text)
            self._label.adjustSize()
            room = over.rect().bottomRight() - self._label.rect().bottomRight()
            place = QtCore.QPoint(min(place.x(), room.x()), min(place.y(), room.y()))
            self._label.move(place)
            self._label.raise_()
        self._label.setVisible(bool(text))

    def remove(self) -> None:
        """Remove the label; the view may be closed already."""
        take_away(self._label)

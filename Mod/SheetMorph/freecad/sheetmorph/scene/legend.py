# SPDX-License-Identifier: LGPL-2.1-or-later
"""The legend in a corner of the 3D view, with the colours of roles and the scale of values."""

from freecad.sheetmorph.qt import QtWidgets
from freecad.sheetmorph.scene.overlay import laid_over, take_away

CORNER = 10  # px from the upper left
LOOK = (
    "QFrame#SheetMorphLegend { background: rgba(22, 26, 34, 190); border-radius: 5px; }"
    "QFrame#SheetMorphLegend QLabel { color: #f2f4f7; background: transparent; border: none; }"
)


class ViewLegend:
    """A frame on top of a 3D view that ignores the mouse, until `remove`."""

    def __init__(self, view):
        self._frame = laid_over(view, QtWidgets.QFrame, "SheetMorphLegend", LOOK)
        labels = [QtWidgets.QLabel(self._frame) for _ in range(4)]
        self._roles, self._bars, self._scale, self._values = labels
        column = QtWidgets.QVBoxLayout(self._frame)
        column.setContentsMargins(8, 5, 8, 6)
        column.setSpacing(3)
        for label in labels:
            column.addWidget(label)
        self._frame.move(CORNER, CORNER)
        self.show_values()

    def show_roles(self, text: str) -> None:
        """Show the colours of the roles as rich text."""
        self._roles.setText(text)
        self._fit()

    def show_values(self, pixmap=None, text: str = "", bars=None) -> None:
        """Show a scale, its text and bars above it; None hides them."""
        if bars is not None:
            self._bars.setPixmap(bars)
        self._bars.setVisible(bars is not None)
        if pixmap is not None:
            self._scale.setPixmap(pixmap)
        self._scale.setVisible(pixmap is not None)
        self._values.setVisible(pixmap is not None)
        self._values.setText(text)
        self._fit()

    def remove(self) -> None:
        """Remove the legend; the view may be closed already."""
        take_away(self._frame)

    def _fit(self) -> None:
        self._frame.adjustSize()
        self._frame.setVisible(bool(self._roles.text()) or bool(self._values.text()))
        self._frame.raise_()

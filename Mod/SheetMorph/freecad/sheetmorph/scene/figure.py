# SPDX-License-Identifier: LGPL-2.1-or-later
"""A figure drawn on top of the 3D view: a brush circle, a rectangle or a lasso."""

from freecad.sheetmorph.qt import QtCore, QtGui, QtWidgets

DARK, LIGHT = QtGui.QColor(20, 24, 32, 220), QtGui.QColor(255, 255, 255, 235)
FILL = 28  # of 255


class Figure(QtWidgets.QWidget):
    """A widget on top of the view that ignores all events, until `remove`."""

    def __init__(self, widget, colour):
        """Create it over the view's `widget`; `colour` (r, g, b) fills the figure."""
        super().__init__(widget)
        self._colour = QtGui.QColor.fromRgbF(*colour)
        self._polygon = None
        self.setAttribute(QtCore.Qt.WA_TransparentForMouseEvents)
        self.setAttribute(QtCore.Qt.WA_NoSystemBackground)

    def show_outline(self, outline) -> None:
        """Show a closed figure, (k, 2) px from the lower left of the view; None hides it."""
        if outline is None:
            self.hide()
            return
        view = self.parentWidget()
        ratio = view.devicePixelRatioF()
        places = [QtCore.QPointF(x / ratio, view.height() - 1 - y / ratio) for x, y in outline]
        self._polygon = QtGui.QPolygonF(places)
        self.setGeometry(view.rect())
        self.show()
        self.update()

    def paintEvent(self, _event) -> None:
        """Draw light on dark lines, which are visible on any background and part."""
        painter = QtGui.QPainter(self)
        painter.setRenderHint(QtGui.QPainter.Antialiasing)
        fill = QtGui.QColor(self._colour)
        fill.setAlpha(FILL)
        painter.setBrush(fill)
        painter.setPen(QtGui.QPen(DARK, 3.0))
        painter.drawPolygon(self._polygon, QtCore.Qt.WindingFill)
        painter.setBrush(QtCore.Qt.NoBrush)
        painter.setPen(QtGui.QPen(LIGHT, 1.2))
        painter.drawPolygon(self._polygon)

    def remove(self) -> None:
        """Remove the widget; the view may be closed already."""
        try:
            self.hide()
            self.setParent(None)
            self.deleteLater()
        except RuntimeError:
            return

# SPDX-License-Identifier: LGPL-2.1-or-later
"""The histogram of element quality as a picture: bars for now, lines for rest."""

from freecad.sheetmorph.qt import QtCore, QtGui

WIDTH, HEIGHT = 256, 64
REST, LIMIT = "#8b95a2", "#de2924"  # visible on light panels and on the dark legend


def histogram_picture(histogram):
    """Return a QPixmap of an element_quality.Histogram in the colours of its span."""
    picture = QtGui.QPixmap(WIDTH, HEIGHT)
    picture.fill(QtCore.Qt.transparent)
    painter = QtGui.QPainter(picture)
    for left, right, now, rest, colour in histogram.bars(WIDTH, HEIGHT - 4):
        bar = QtCore.QRectF(left + 0.5, HEIGHT - now, right - left - 1.0, now)
        painter.fillRect(bar, QtGui.QColor.fromRgbF(*colour))
        painter.setPen(QtGui.QPen(QtGui.QColor(REST), 1.5))
        top = HEIGHT - rest - 1.0
        painter.drawLine(QtCore.QPointF(left, top), QtCore.QPointF(right, top))
    place = histogram.place_of_limit()
    if place is not None:
        painter.setPen(QtGui.QPen(QtGui.QColor(LIMIT), 2.0))
        ends = (QtCore.QPointF(place * WIDTH, y) for y in (0.0, HEIGHT))
        painter.drawLine(*ends)
    painter.end()
    return picture

# SPDX-License-Identifier: LGPL-2.1-or-later
"""The colours of a legend as a picture."""

from freecad.sheetmorph.qt import QtGui
from freecad.sheetmorph.tools import colour_scale


def gradient(width: int = 256, height: int = 16):
    """Return a QPixmap of all colours from left to right."""
    colours = colour_scale.ramp(width)
    image = QtGui.QImage(width, height, QtGui.QImage.Format_RGB32)
    for x, colour in enumerate(colours):
        shown = QtGui.QColor.fromRgbF(*colour).rgb()
        for y in range(height):
            image.setPixel(x, y, shown)
    return QtGui.QPixmap.fromImage(image)

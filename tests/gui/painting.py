# SPDX-License-Identifier: LGPL-2.1-or-later
"""How long the 3D views take to draw: no work of ours, and long without a graphics card."""

import time

import FreeCADGui as Gui
from PySide import QtCore, QtGui


class Painting(QtCore.QObject):
    """In this context ``seconds`` adds up what the views take to draw, ``count`` how often."""

    def __init__(self):
        super().__init__()
        self.seconds, self.count = 0.0, 0
        self._is_inside = False
        views = Gui.getMainWindow().findChildren(QtGui.QGraphicsView)
        self._widgets = [view.viewport() for view in views]

    def __enter__(self):
        for widget in self._widgets:
            widget.installEventFilter(self)
        return self

    def __exit__(self, *_):
        for widget in self._widgets:
            widget.removeEventFilter(self)

    def eventFilter(self, widget, event) -> bool:
        """Lets a view draw within, so that the end is seen too."""
        if self._is_inside or event.type() != QtCore.QEvent.Paint:
            return False
        self._is_inside, begin = True, time.monotonic()
        try:
            QtCore.QCoreApplication.sendEvent(widget, event)
        finally:
            self._is_inside = False
        self.seconds += time.monotonic() - begin
        self.count += 1
        return True

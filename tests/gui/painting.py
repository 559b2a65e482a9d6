# SPDX-License-Identifier: LGPL-2.1-or-later
"""Measures how long the 3D view draws: FreeCAD's work, and slow without a graphics card."""

import time

import FreeCADGui as Gui
from PySide import QtCore


class Painting(QtCore.QObject):
    """In this context ``seconds`` adds up what the shown 3D view takes to draw, ``count`` how
    often. The view may be closed in it."""

    def __init__(self):
        super().__init__()
        self.seconds, self.count = 0.0, 0
        self._is_inside = False
        # From FreeCAD, not by findChildren: PySide would keep the wrapper of a closed view.
        document = Gui.activeDocument()
        self._widget = document and document.activeView().graphicsView().viewport()

    def __enter__(self):
        if self._widget is not None:
            self._widget.installEventFilter(self)
        return self

    def __exit__(self, *_):
        try:
            if self._widget is not None:
                self._widget.removeEventFilter(self)
        except RuntimeError:
            pass  # closed
        self._widget = None

    def eventFilter(self, widget, event) -> bool:
        """Sends the paint event on by itself, to measure until drawing has ended."""
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

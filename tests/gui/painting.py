# SPDX-License-Identifier: LGPL-2.1-or-later
"""How long the 3D view takes to draw: no work of ours, and long without a graphics card."""

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
        # From FreeCAD, not by findChildren: PySide would keep what stands for a closed view.
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

# SPDX-License-Identifier: LGPL-2.1-or-later
"""The mouse during a drag of FreeCAD's arrows, seen before FreeCAD acts on it."""

from freecad.sheetmorph.qt import QtCore
from freecad.sheetmorph.scene.viewport import pointer_of


class DragWatch(QtCore.QObject):
    """A filter that reports every move of the mouse from `start` to `stop`, and consumes none."""

    def __init__(self, view, on_move):
        """Watch a view; `on_move(pointer)` gets a viewport.Pointer."""
        super().__init__()
        self._view, self._on_move = view, on_move
        self._widget = None

    def start(self) -> None:
        """Start to watch."""
        if self._widget is None:
            self._widget = self._view.graphicsView().viewport()
            self._widget.installEventFilter(self)

    def stop(self) -> None:
        """Stop watching; the view may be closed already."""
        widget, self._widget = self._widget, None
        try:
            if widget is not None:
                widget.removeEventFilter(self)
        except RuntimeError:
            return  # closed: the filter is gone

    def eventFilter(self, _watched, event) -> bool:
        """Report a move of the mouse."""
        if event.type() == QtCore.QEvent.MouseMove and self._widget is not None:
            self._on_move(pointer_of(self._view, self._widget, event))
        return False

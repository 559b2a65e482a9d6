# SPDX-License-Identifier: LGPL-2.1-or-later
"""Dragging points of parts in the plane of the view, with rays and shifts in global mm.

A Qt event filter sees the mouse before FreeCAD and consumes the events of a drag.
"""

import numpy as np

from freecad.sheetmorph.qt import QtCore
from freecad.sheetmorph.scene.viewport import pointer_of
from freecad.sheetmorph.tools.part_mesh import Ray


class EscapeWatch(QtCore.QObject):
    """A filter that sees Escape first, whichever widget has the focus, from start to stop."""

    def __init__(self, on_escape):
        super().__init__()
        self._on_escape, self._is_on = on_escape, False

    def start(self) -> None:
        """Start to watch."""
        if not self._is_on:
            QtCore.QCoreApplication.instance().installEventFilter(self)
        self._is_on = True

    def stop(self) -> None:
        """Stop watching."""
        if self._is_on:
            QtCore.QCoreApplication.instance().removeEventFilter(self)
        self._is_on = False

    def eventFilter(self, _watched, event) -> bool:
        """Consume Escape if the callback accepts it."""
        is_key = event.type() == QtCore.QEvent.KeyPress
        return is_key and event.key() == QtCore.Qt.Key_Escape and bool(self._on_escape())


class PointDrag(QtCore.QObject):
    r"""A filter that reports drags of points until `remove`.

    `listener` has these methods. on_press(ray) returns the grabbed point (3,), or None to leave the
    mouse to FreeCAD. on_pull(shift (3,)) gets the shift in mm since then, parallel to the screen.
    on_drop() ends the drag. on_escape() returns True if Escape in the view ended a drag.
    on_key(text) gets other keys, "\n" for Enter and "" for backspace. on_resize() reports another
    size of the view. While is_dragging is true, keys are not shortcuts.
    """

    def __init__(self, view, listener):
        super().__init__()
        self._view, self._listener = view, listener
        self._grabbed = None
        self.is_on = False
        self._widget = view.graphicsView().viewport()
        self._widget.installEventFilter(self)
        view.graphicsView().installEventFilter(self)

    def remove(self) -> None:
        """Release the mouse; the view may be closed already."""
        try:
            self._widget.removeEventFilter(self)
            self._view.graphicsView().removeEventFilter(self)
        except RuntimeError:
            pass  # closed: the filters are gone
        self._view = self._widget = self._listener = None

    def cancel(self) -> None:
        """Drop the point; the mouse has no effect until its button is released."""
        if self._grabbed is not None:
            self._grabbed = np.full(3, np.nan)

    def eventFilter(self, _watched, event) -> bool:
        """Consume the drag of a point, and Escape during any drag."""
        kind = event.type()
        if kind == QtCore.QEvent.KeyPress:
            return self._typed(event)
        if kind == QtCore.QEvent.ShortcutOverride and self._listener.is_dragging:
            event.accept()  # digits are typed values here, not shortcuts for standard views
            return True
        if kind == QtCore.QEvent.Resize:
            QtCore.QTimer.singleShot(0, self._resized)
            return False
        if kind == QtCore.QEvent.MouseButtonPress and self.is_on:
            return event.button() == QtCore.Qt.LeftButton and self._press(event)
        if self._grabbed is None:
            return False
        if kind == QtCore.QEvent.MouseMove:
            self._pull(event)
            return True
        if kind == QtCore.QEvent.MouseButtonRelease and event.button() == QtCore.Qt.LeftButton:
            self._grabbed = None
            self._listener.on_drop()
            return True
        return False

    def _typed(self, event) -> bool:
        if event.key() == QtCore.Qt.Key_Escape:
            return bool(self._listener.on_escape())
        text = {QtCore.Qt.Key_Return: "\n", QtCore.Qt.Key_Enter: "\n", QtCore.Qt.Key_Backspace: ""}
        key = text.get(event.key(), event.text())
        is_value = bool(key) or event.key() == QtCore.Qt.Key_Backspace
        return is_value and bool(self._listener.on_key(key))

    def _resized(self) -> None:
        if self._listener is not None:
            self._listener.on_resize()

    def _press(self, event) -> bool:
        self._grabbed = self._listener.on_press(self._ray(event))
        return self._grabbed is not None

    def _pull(self, event) -> None:
        """Move the point to where the ray meets the plane through it, parallel to the screen."""
        if not np.isfinite(self._grabbed).all():
            return
        ray = self._ray(event)
        normal = np.array(tuple(self._view.getViewDirection()))
        depth = ((self._grabbed - ray.origin) @ normal) / (ray.direction @ normal)
        self._listener.on_pull(ray.origin + depth * ray.direction - self._grabbed)

    def _ray(self, event) -> Ray:
        pointer = pointer_of(self._view, self._widget, event)
        return Ray(pointer.origin, pointer.direction)

# SPDX-License-Identifier: LGPL-2.1-or-later
"""Points of parts dragged in the plane of the view: the mouse as rays and shifts, global mm.

A Qt event filter, which sees the mouse before FreeCAD and takes what belongs to a drag.
"""

import numpy as np

from freecad.sheetmorph.qt import QtCore
from freecad.sheetmorph.scene.viewport import pointer_of
from freecad.sheetmorph.tools.part_mesh import Ray


class EscapeWatch(QtCore.QObject):
    """Sees Escape before anything else, whichever widget has the keys, between start and stop."""

    def __init__(self, on_escape):
        super().__init__()
        self._on_escape, self._is_on = on_escape, False

    def start(self) -> None:
        """From now on."""
        if not self._is_on:
            QtCore.QCoreApplication.instance().installEventFilter(self)
        self._is_on = True

    def stop(self) -> None:
        """No longer."""
        if self._is_on:
            QtCore.QCoreApplication.instance().removeEventFilter(self)
        self._is_on = False

    def eventFilter(self, _watched, event) -> bool:
        """Takes Escape."""
        is_key = event.type() == QtCore.QEvent.KeyPress
        return is_key and event.key() == QtCore.Qt.Key_Escape and bool(self._on_escape())


class PointDrag(QtCore.QObject):
    """Reports drags of points until ``remove`` is called.

    ``listener``: on_press(ray) returns the point (3,) that is grabbed, or None to leave the mouse
    to FreeCAD; on_pull(shift (3,)) mm since then, parallel to the screen; on_drop(). Escape in
    the view is asked of on_escape(): True if it was meant for a drag; other keys of on_key(text),
    "\n" for Enter and "" for backspace, while is_dragging. on_resize(): the view has another size.
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
        """Gives the mouse back; the view may be closed already."""
        try:
            self._widget.removeEventFilter(self)
            self._view.graphicsView().removeEventFilter(self)
        except RuntimeError:
            pass  # closed: there is nothing to give back
        self._view = self._widget = self._listener = None

    def cancel(self) -> None:
        """Lets go of the point; what the mouse does until it is released is nobody's."""
        if self._grabbed is not None:
            self._grabbed = np.full(3, np.nan)

    def eventFilter(self, _watched, event) -> bool:
        """Takes the drag of a point, and Escape during any drag."""
        kind = event.type()
        if kind == QtCore.QEvent.KeyPress:
            return self._typed(event)
        if kind == QtCore.QEvent.ShortcutOverride and self._listener.is_dragging:
            event.accept()  # digits are typed, and show no other side of the parts
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
        """Where the ray meets the plane through the point, parallel to the screen."""
        if not np.isfinite(self._grabbed).all():
            return
        ray = self._ray(event)
        normal = np.array(tuple(self._view.getViewDirection()))
        depth = ((self._grabbed - ray.origin) @ normal) / (ray.direction @ normal)
        self._listener.on_pull(ray.origin + depth * ray.direction - self._grabbed)

    def _ray(self, event) -> Ray:
        pointer = pointer_of(self._view, self._widget, event)
        return Ray(pointer.origin, pointer.direction)

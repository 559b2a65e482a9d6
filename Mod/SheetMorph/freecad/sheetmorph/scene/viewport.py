# SPDX-License-Identifier: LGPL-2.1-or-later
"""The mouse in the 3D view, as rays in global coordinates.

A Qt event filter, because FreeCAD keeps button-up events over geometry from its own callbacks.
Nothing is consumed: turning and zooming work in every navigation style while a tool is active.
"""

from dataclasses import dataclass

import numpy as np

from freecad.sheetmorph.qt import QtCore

CLICK_TRAVEL = 4  # logical px that a click may move between button down and up


@dataclass(frozen=True)
class Pointer:
    """Where the mouse points: a ray (mm, global) and the modifier keys."""

    origin: np.ndarray
    direction: np.ndarray
    shift: bool
    control: bool


class Viewport(QtCore.QObject):
    """Calls ``on_move``, ``on_click`` and ``on_escape`` until ``release`` is called."""

    def __init__(self, view, listener):
        """``listener``: on_move(Pointer or None), on_click(Pointer), on_escape()."""
        super().__init__()
        self._view = view
        self._listener = listener
        self._down = None
        self._widget = view.graphicsView().viewport()
        self._role = view.getSceneGraph().getField("selectionRole")
        self._role.set("FALSE")
        self._tracked = self._widget.hasMouseTracking()
        self._widget.setMouseTracking(True)
        self._widget.installEventFilter(self)
        view.graphicsView().installEventFilter(self)

    def release(self) -> None:
        """Gives the mouse back to FreeCAD; the view may be closed already.

        It lets go of the widget too: PySide would take a wrapper that outlives its widget for
        whatever is made at the same address next.
        """
        try:
            self._widget.removeEventFilter(self)
            self._view.graphicsView().removeEventFilter(self)
            self._widget.setMouseTracking(self._tracked)
            self._role.set("TRUE")
        except RuntimeError:
            pass  # closed: there is nothing to give back
        self._view = self._widget = self._listener = None

    def eventFilter(self, _watched, event) -> bool:
        """Watches; consumes nothing but Escape."""
        kind = event.type()
        if kind == QtCore.QEvent.MouseMove:
            self._listener.on_move(None if event.buttons() else self._pointer(event))
        elif kind in (QtCore.QEvent.MouseButtonPress, QtCore.QEvent.MouseButtonDblClick):
            self._down = event.pos() if event.button() == QtCore.Qt.LeftButton else None
        elif kind == QtCore.QEvent.MouseButtonRelease and event.button() == QtCore.Qt.LeftButton:
            if self._down is not None and _near(event.pos(), self._down):
                self._listener.on_click(self._pointer(event))
            self._down = None
        elif kind == QtCore.QEvent.Leave:
            self._listener.on_move(None)
        elif kind == QtCore.QEvent.KeyPress and event.key() == QtCore.Qt.Key_Escape:
            self._listener.on_escape()
            return True
        return False

    def _pointer(self, event) -> Pointer:
        ratio = self._widget.devicePixelRatioF()
        x = round(event.pos().x() * ratio)
        y = round((self._widget.height() - 1 - event.pos().y()) * ratio)
        near, far = (np.array(tuple(p)) for p in self._view.projectPointToLine(x, y))
        keys = event.modifiers()
        shift, control = keys & QtCore.Qt.ShiftModifier, keys & QtCore.Qt.ControlModifier
        return Pointer(near, far - near, bool(shift), bool(control))


def _near(a, b) -> bool:
    return (a - b).manhattanLength() <= CLICK_TRAVEL

# SPDX-License-Identifier: LGPL-2.1-or-later
"""The mouse in the 3D view as rays in global coordinates and places on the screen.

This is a Qt event filter, because FreeCAD withholds button-up events over geometry from its own
callbacks. FreeCAD gets the events that a tool does not claim, so that turning and zooming work in
every navigation style.
"""

from dataclasses import dataclass

import numpy as np
from pivy import coin

from freecad.sheetmorph import generations
from freecad.sheetmorph.qt import QtCore
from freecad.sheetmorph.tools.figures import Camera

CLICK_TRAVEL = 4  # logical px that the mouse may move during a click
WHEEL_STEP = 120.0  # Qt's unit for one step of a wheel


@dataclass(frozen=True)
class Pointer:
    """The position of the mouse: a ray (mm, global), px from the lower left, modifier keys."""

    origin: np.ndarray
    direction: np.ndarray
    shift: bool
    control: bool
    place: tuple[float, float] = (0.0, 0.0)


class Listener:
    """The reactions of a tool to mouse and keys of the view."""

    def on_move(self, pointer) -> None:
        """Handle a move without a button; None if the mouse left or a button is down."""

    def on_click(self, pointer) -> None:
        """Handle a press and release of the left button in one place."""

    def on_press(self, _pointer) -> bool:
        """Handle a press of the left button; return True to claim it until its release.

        FreeCAD gets no events of a claimed button.
        """
        return False

    def on_drag(self, pointer) -> None:
        """Handle a move with the claimed left button."""

    def on_release(self, pointer) -> None:
        """Handle the release of the claimed left button."""

    def on_wheel(self, _steps: float) -> bool:
        """Handle the wheel without keys (up is positive); return True to claim it."""
        return False

    def on_escape(self) -> None:
        """Handle the Escape key."""

    def on_enter(self):
        """Handle the Enter key; return False to leave it to others."""


class Viewport(QtCore.QObject):
    """A filter that reports mouse and keys to a listener until `remove`."""

    def __init__(self, view, listener):
        """Install the filter; `listener` is a Listener or has its methods."""
        super().__init__()
        self._view = view
        self._listener = listener
        self._down = None
        self._is_claimed = False
        self._widget = view.graphicsView().viewport()
        fields = map(view.getSceneGraph().getField, generations.SELECTION_SWITCHES)
        self._role = next(field for field in fields if field is not None)
        self._role.set("FALSE")
        self._tracked = self._widget.hasMouseTracking()
        self._widget.setMouseTracking(True)
        self._widget.installEventFilter(self)
        view.graphicsView().installEventFilter(self)

    def remove(self) -> None:
        """Return the mouse to FreeCAD; the view may be closed already.

        The reference to the widget goes too. PySide would take a wrapper that outlives its widget
        for the next object at the same address.
        """
        try:
            self._widget.removeEventFilter(self)
            self._view.graphicsView().removeEventFilter(self)
            self._widget.setMouseTracking(self._tracked)
            self._role.set("TRUE")
        except RuntimeError:
            pass  # closed: the filters are gone
        self._view = self._widget = self._listener = None

    @property
    def widget(self):
        """The widget that shows the view."""
        return self._widget

    def camera(self) -> Camera:
        """Return the present camera of the view."""
        return camera_of(self._view)

    def eventFilter(self, _watched, event) -> bool:
        """Pass events to the listener and consume those that it claims."""
        kind = event.type()
        if kind == QtCore.QEvent.MouseMove:
            return self._moved(event)
        if kind in (QtCore.QEvent.MouseButtonPress, QtCore.QEvent.MouseButtonDblClick):
            return self._pressed(event)
        if kind == QtCore.QEvent.MouseButtonRelease:
            return event.button() == QtCore.Qt.LeftButton and self._released(event)
        if kind == QtCore.QEvent.Wheel and event.modifiers() == QtCore.Qt.NoModifier:
            return bool(self._listener.on_wheel(event.angleDelta().y() / WHEEL_STEP))
        if kind == QtCore.QEvent.Leave:
            self._listener.on_move(None)
        return kind == QtCore.QEvent.KeyPress and self._typed(event)

    def _moved(self, event) -> bool:
        if self._is_claimed:
            self._listener.on_drag(self._pointer(event))
        else:
            self._listener.on_move(None if event.buttons() else self._pointer(event))
        return self._is_claimed

    def _pressed(self, event) -> bool:
        if event.button() != QtCore.Qt.LeftButton:
            self._down = None
            return False
        self._down = event.pos()
        self._is_claimed = bool(self._listener.on_press(self._pointer(event)))
        return self._is_claimed

    def _released(self, event) -> bool:
        down, is_claimed = self._down, self._is_claimed
        self._down, self._is_claimed = None, False
        if is_claimed:
            self._listener.on_release(self._pointer(event))
        elif down is not None and _near(event.pos(), down):
            self._listener.on_click(self._pointer(event))
        return is_claimed

    def _typed(self, event) -> bool:
        if event.key() == QtCore.Qt.Key_Escape:
            self._listener.on_escape()
            return True
        if event.key() in (QtCore.Qt.Key_Return, QtCore.Qt.Key_Enter):
            return self._listener.on_enter() is not False
        return False

    def _pointer(self, event) -> Pointer:
        return pointer_of(self._view, self._widget, event)


def take_every_move(is_wanted: bool) -> None:
    """Switch whether every mouse move is reported, or only the latest.

    A figure drawn in a slow view would otherwise lose its corners.
    """
    compress = QtCore.Qt.AA_CompressHighFrequencyEvents
    QtCore.QCoreApplication.setAttribute(compress, not is_wanted)


def camera_of(view) -> Camera:
    """Return the present camera of a view."""
    width, height = view.getSize()
    # Coin uses the transpose
    matrix = np.array(view_volume(view).getMatrix().getValue(), dtype=float).T
    return Camera(np.ascontiguousarray(matrix), float(width), float(height))


def pointer_of(view, widget, event) -> Pointer:
    """Return the pointer of a mouse event on the widget of a view."""
    ratio = widget.devicePixelRatioF()
    x = round(event.pos().x() * ratio)
    y = round((widget.height() - 1 - event.pos().y()) * ratio)
    # projectPointToLine of the view is wrong in a view that is higher than wide.
    near, far = camera_of(view).line(x, y)
    keys = event.modifiers()
    shift, control = keys & QtCore.Qt.ShiftModifier, keys & QtCore.Qt.ControlModifier
    return Pointer(near, far - near, bool(shift), bool(control), (float(x), float(y)))


def camera_node(view):
    """Return the Coin camera of a view.

    Raises RuntimeError for a closed or closing view. Such a view may have no camera, for which
    FreeCAD's getCameraNode() crashes.
    """
    camera = generations.viewer_of(view).getSoRenderManager().getCamera()
    if camera is None:
        raise RuntimeError("The view has no camera any more.")
    return camera


def view_volume(view):
    """Return the SbViewVolume of a view."""
    width, height = view.getSize()
    aspect = width / max(height, 1)
    volume = camera_node(view).getViewVolume(aspect)
    if aspect < 1.0:  # as Coin does: what fits into the height must fit into the width
        volume.scale(1.0 / aspect)
    return volume


def mm_per_px(view, place) -> float:
    """Return the size of a pixel at a place, a global SbVec3f, mm."""
    volume, (_, height) = view_volume(view), view.getSize()
    size = volume.getHeight()  # of the near plane
    if volume.getProjectionType() == coin.SbViewVolume.PERSPECTIVE:
        depth = (place - volume.getProjectionPoint()).dot(volume.getProjectionDirection())
        size *= depth / volume.getNearDist()
    return size / max(height, 1)


def _near(a, b) -> bool:
    return (a - b).manhattanLength() <= CLICK_TRAVEL

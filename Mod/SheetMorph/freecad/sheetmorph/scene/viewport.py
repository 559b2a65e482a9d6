# SPDX-License-Identifier: LGPL-2.1-or-later
"""The mouse in the 3D view, as rays in global coordinates and places on the screen.

A Qt event filter, because FreeCAD keeps button-up events over geometry from its own callbacks.
What a tool does not claim is left to FreeCAD: turning and zooming work in every navigation style.
"""

from dataclasses import dataclass

import numpy as np
from pivy import coin

from freecad.sheetmorph import generations
from freecad.sheetmorph.qt import QtCore
from freecad.sheetmorph.tools.figures import Camera

CLICK_TRAVEL = 4  # logical px that a click may move between button down and up
WHEEL_STEP = 120.0  # what Qt counts for one step of a wheel


@dataclass(frozen=True)
class Pointer:
    """Where the mouse points: a ray (mm, global), px from the lower left, the modifier keys."""

    origin: np.ndarray
    direction: np.ndarray
    shift: bool
    control: bool
    place: tuple[float, float] = (0.0, 0.0)


class Listener:
    """What a tool may do with the mouse and the keys of the view."""

    def on_move(self, pointer) -> None:
        """The mouse moved with no button down; None: it left the view, or a button is down."""

    def on_click(self, pointer) -> None:
        """The left button was pressed and released in one place."""

    def on_press(self, _pointer) -> bool:
        """The left button went down; True claims it until it is released: FreeCAD sees nothing."""
        return False

    def on_drag(self, pointer) -> None:
        """The mouse moved while the left button was claimed."""

    def on_release(self, pointer) -> None:
        """The left button that was claimed went up."""

    def on_wheel(self, _steps: float) -> bool:
        """The wheel turned, up positive, with no key down; True claims it."""
        return False

    def on_escape(self) -> None:
        """The Escape key."""

    def on_enter(self) -> None:
        """The Enter key."""


class Viewport(QtCore.QObject):
    """Tells a listener about mouse and keys until ``remove`` is called."""

    def __init__(self, view, listener):
        """``listener``: a Listener, or what has its methods."""
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

    @property
    def widget(self):
        """The widget that shows the view."""
        return self._widget

    def camera(self) -> Camera:
        """What the view shows now."""
        return camera_of(self._view)

    def eventFilter(self, _watched, event) -> bool:
        """Hands events to the listener; consumes those that it claims."""
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
            self._listener.on_enter()
            return True
        return False

    def _pointer(self, event) -> Pointer:
        return pointer_of(self._view, self._widget, event)


def take_every_move(is_wanted: bool) -> None:
    """Whether moves of the mouse that wait come one by one, instead of the last one alone.

    A figure that is drawn while the view is slow would lose its corners otherwise.
    """
    compress = QtCore.Qt.AA_CompressHighFrequencyEvents
    QtCore.QCoreApplication.setAttribute(compress, not is_wanted)


def camera_of(view) -> Camera:
    """What a view shows now."""
    width, height = view.getSize()
    matrix = np.array(view_volume(view).getMatrix().getValue(), dtype=float).T  # Coin's transpose
    return Camera(np.ascontiguousarray(matrix), float(width), float(height))


def pointer_of(view, widget, event) -> Pointer:
    """Where a mouse event on the widget of a view points."""
    ratio = widget.devicePixelRatioF()
    x = round(event.pos().x() * ratio)
    y = round((widget.height() - 1 - event.pos().y()) * ratio)
    # Not by the view's own projectPointToLine: in a view higher than wide that is wrong.
    near, far = camera_of(view).line(x, y)
    keys = event.modifiers()
    shift, control = keys & QtCore.Qt.ShiftModifier, keys & QtCore.Qt.ControlModifier
    return Pointer(near, far - near, bool(shift), bool(control), (float(x), float(y)))


def camera_node(view):
    """The camera of a view in Coin; raises RuntimeError for a view that is closed or closes.

    Such a view may have none any more, and FreeCAD's own getCameraNode() dies of that.
    """
    camera = generations.viewer_of(view).getSoRenderManager().getCamera()
    if camera is None:
        raise RuntimeError("The view has no camera any more.")
    return camera


def view_volume(view):
    """The part of space that a view shows, an SbViewVolume."""
    width, height = view.getSize()
    aspect = width / max(height, 1)
    volume = camera_node(view).getViewVolume(aspect)
    if aspect < 1.0:  # as Coin does: what fits into the height must fit into the width
        volume.scale(1.0 / aspect)
    return volume


def mm_per_px(view, place) -> float:
    """How large a pixel of a view is at a place, an SbVec3f, global."""
    volume, (_, height) = view_volume(view), view.getSize()
    size = volume.getHeight()  # of what is seen nearest to the eye
    if volume.getProjectionType() == coin.SbViewVolume.PERSPECTIVE:
        depth = (place - volume.getProjectionPoint()).dot(volume.getProjectionDirection())
        size *= depth / volume.getNearDist()
    return size / max(height, 1)


def _near(a, b) -> bool:
    return (a - b).manhattanLength() <= CLICK_TRAVEL

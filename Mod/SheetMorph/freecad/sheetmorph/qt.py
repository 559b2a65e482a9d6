# SPDX-License-Identifier: LGPL-2.1-or-later
"""The only module that imports Qt and handles differences between PySide2 and PySide6.

FreeCAD's `PySide` stands for the version that it was built with; in FreeCAD 0.20 it lacks
`QtWidgets`.
"""

from functools import cache

import FreeCAD as App
from PySide import QtCore, QtGui

try:
    from PySide import QtWidgets
except ImportError:
    QtWidgets = QtGui
try:
    import shiboken6 as shiboken
except ImportError:
    import shiboken2 as shiboken

__all__ = ["QtCore", "QtGui", "QtWidgets", "connect", "draw", "forget", "frame_of", "icon_of"]
__all__ += ["number", "translate", "widen"]

OVERLAY, GRIP = "Gui::OverlayTabWidget", "Gui::OverlaySizeGrip"  # widgets of FreeCAD since 1.0


def number(choice) -> int:
    """Return the integer of a Qt enumeration value or flags, which PySide6 does not convert."""
    return int(getattr(choice, "value", choice))


def translate(context: str, text: str) -> str:
    """Return a text in the user's language, else unchanged."""
    return QtCore.QCoreApplication.translate(context, text)


def connect(sender, signal: str, action) -> None:
    """Call a function when an object of Qt sends a signal, given with its types: "clicked()".

    PySide2 never frees the wrapper of an object of which a signal was read as an attribute. It
    also loses the meta-object of a class, so the class itself must have the signal.
    Raises AttributeError for a signal that the sender does not have.
    """
    name = signal[: signal.index("(")]
    if not hasattr(type(sender), name):  # PySide2 would accept any name
        raise AttributeError(f"{type(sender).__name__} has no signal {signal}.")
    if QtCore.qVersion().startswith("6."):
        getattr(sender, name).connect(action)
    else:
        QtCore.QObject.connect(sender, QtCore.SIGNAL(signal), action)


@cache
def icon_of(path: str):
    """Return the icon of a file, read once, because Qt caches the drawings of every icon."""
    return QtGui.QIcon(path)


def forget(form) -> None:
    """Invalidate PySide's wrappers of a form's widgets, which are about to be deleted.

    PySide keeps the wrapper of a widget with a connected signal or an event filter. It identifies
    widgets by address, and would mistake the next widget at that address for the deleted one.
    """
    for widget in [form, *form.findChildren(QtWidgets.QWidget)]:
        shiboken.invalidate(widget)


def frame_of(dock):
    """Return the widget that has the visible width of a dock: the dock or its container.

    Since FreeCAD 1.0 a dock may be in a widget on top of the 3D view, at the window's edge. The
    layout of the window ignores this widget, which clips wider content.
    """
    over = dock.parentWidget()
    while over is not None and not over.inherits(OVERLAY):
        over = over.parentWidget()
    return dock if over is None else over


def widen(dock, width: int):
    """Widen a dock of the main window to at least `width`, px; return a function to undo it.

    The function restores a dock on top of the 3D view, unless the user has resized it meanwhile.
    The frame of such a dock stores its own width and returns to it at every press of the mouse,
    under which the widgets then move. Only its grip changes the stored width.
    """
    frame = frame_of(dock)
    if frame is dock:
        if dock.width() < width:
            dock.window().resizeDocks([dock], [width], QtCore.Qt.Horizontal)
        return lambda: None
    kept = App.ParamGet(f"User parameter:BaseApp/MainWindow/DockWindows/{frame.objectName()}")
    before = kept.GetInt("Width")
    if before < width:
        draw(frame, width)
    given = kept.GetInt("Width")

    def give_back() -> None:
        if before < given == kept.GetInt("Width"):
            draw(frame_of(dock), before)

    return give_back


def draw(frame, width: int) -> None:
    """Set the width (px) of such a frame at a side of the window, as the mouse does."""
    grip, room = _grip_of(frame), frame.parentWidget()
    edges = {"OverlayRight": room.width() - width, "OverlayLeft": width - 1}
    if grip is not None and frame.objectName() in edges:
        edge = room.mapToGlobal(QtCore.QPoint(edges[frame.objectName()], frame.y()))
        places = QtCore.QPointF(grip.mapFromGlobal(edge)), QtCore.QPointF(edge)
        buttons = QtCore.Qt.NoButton, QtCore.Qt.LeftButton, QtCore.Qt.NoModifier
        move = QtGui.QMouseEvent(QtCore.QEvent.MouseMove, *places, *buttons)
        QtCore.QCoreApplication.sendEvent(grip, move)


def _grip_of(frame):
    """Return the grip with which the mouse resizes such a frame, None without one.

    The search does not use the children of the frame. Otherwise PySide would treat them, and the
    form of an open panel among them, as deleted together with the frame's wrapper.
    """
    for title in frame.window().findChildren(QtWidgets.QWidget, "OverlayTitle"):
        if frame.isAncestorOf(title):
            for widget in title.findChildren(QtWidgets.QWidget):
                if widget.inherits(GRIP):
                    return widget
    return None

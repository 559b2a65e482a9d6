# SPDX-License-Identifier: LGPL-2.1-or-later
"""The only place that imports Qt and knows what differs between PySide2 and PySide6.

FreeCAD's `PySide` stands for the one it was built with; FreeCAD 0.20's lacks `QtWidgets`.
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

OVERLAY, GRIP = "Gui::OverlayTabWidget", "Gui::OverlaySizeGrip"  # FreeCAD's, since 1.0


def number(choice) -> int:
    """The number of a Qt enumeration's value or flags, which PySide6 does not convert itself."""
    return int(getattr(choice, "value", choice))


def translate(context: str, text: str) -> str:
    """A text in the user's language, else as it is."""
    return QtCore.QCoreApplication.translate(context, text)


def connect(sender, signal: str, action) -> None:
    """Calls a function when an object of Qt sends a signal, given with its types: "clicked()".

    PySide2 never frees the wrapper of an object of which a signal was read as an attribute.
    Raises AttributeError for a signal that the sender does not have.
    """
    kind = type(sender)  # PySide2 would make up a signal that does not exist
    if kind.staticMetaObject.indexOfSignal(signal) < 0:
        raise AttributeError(f"{kind.__name__} has no signal {signal}.")
    if QtCore.qVersion().startswith("6."):
        getattr(sender, signal[: signal.index("(")]).connect(action)
    else:
        QtCore.QObject.connect(sender, QtCore.SIGNAL(signal), action)


@cache
def icon_of(path: str):
    """The icon of a file, read once: Qt keeps what it has drawn of each icon that is made."""
    return QtGui.QIcon(path)


def forget(form) -> None:
    """Tells PySide that the widgets of a form, which somebody is about to delete, are gone.

    It keeps the wrapper of a widget whose signal was connected or that has an event filter, knows
    widgets by address, and would take the next widget at that address for the one deleted.
    """
    for widget in [form, *form.findChildren(QtWidgets.QWidget)]:
        shiboken.invalidate(widget)


def frame_of(dock):
    """What has the width that a dock of the main window is seen with: itself, or what holds it.

    Since FreeCAD 1.0 a dock may lie over the 3D view, in a widget at the window's edge of which the
    window's layout knows nothing, and which cuts off what is wider.
    """
    over = dock.parentWidget()
    while over is not None and not over.inherits(OVERLAY):
        over = over.parentWidget()
    return dock if over is None else over


def widen(dock, width: int):
    """Makes a dock of the main window at least so wide, px; returns a function that makes one that
    lies over the 3D view as it was, unless the user has drawn it meanwhile.

    Its frame has a width of its own in mind, to which it returns whenever the mouse is pressed, and
    what is pressed moves away under it: the frame learns another one by its grip alone.
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
    """Gives such a frame at a side of the window a width, px, as the mouse does that draws it."""
    grip, room = _grip_of(frame), frame.parentWidget()
    edges = {"OverlayRight": room.width() - width, "OverlayLeft": width - 1}
    if grip is not None and frame.objectName() in edges:
        edge = room.mapToGlobal(QtCore.QPoint(edges[frame.objectName()], frame.y()))
        places = QtCore.QPointF(grip.mapFromGlobal(edge)), QtCore.QPointF(edge)
        buttons = QtCore.Qt.NoButton, QtCore.Qt.LeftButton, QtCore.Qt.NoModifier
        move = QtGui.QMouseEvent(QtCore.QEvent.MouseMove, *places, *buttons)
        QtCore.QCoreApplication.sendEvent(grip, move)


def _grip_of(frame):
    """What the mouse draws such a frame wider and narrower with; None if there is none.

    Not by the children of the frame: PySide would take them, and with them the form of an open
    panel, for deleted as soon as it forgets the frame.
    """
    for title in frame.window().findChildren(QtWidgets.QWidget, "OverlayTitle"):
        if frame.isAncestorOf(title):
            for widget in title.findChildren(QtWidgets.QWidget):
                if widget.inherits(GRIP):
                    return widget
    return None

# SPDX-License-Identifier: LGPL-2.1-or-later
"""The only place that imports Qt and knows what differs between PySide2 and PySide6.

FreeCAD's `PySide` stands for the one it was built with; FreeCAD 0.20's lacks `QtWidgets`.
"""

from PySide import QtCore, QtGui

try:
    from PySide import QtWidgets
except ImportError:
    QtWidgets = QtGui
try:
    import shiboken6 as shiboken
except ImportError:
    import shiboken2 as shiboken

__all__ = ["QtCore", "QtGui", "QtWidgets", "forget", "frame_of", "number", "translate", "widen"]


def number(choice) -> int:
    """The number of a Qt enumeration's value or flags, which PySide6 does not convert itself."""
    return int(getattr(choice, "value", choice))


def translate(context: str, text: str) -> str:
    """A text in the user's language, else as it is."""
    return QtCore.QCoreApplication.translate(context, text)


def forget(form) -> None:
    """Tells PySide that the widgets of a form, which somebody is about to delete, are gone.

    It keeps the wrapper of a widget whose signal was connected or that has an event filter, knows
    widgets by address, and would take the next widget at that address for the one deleted.
    """
    for widget in [form, *form.findChildren(QtWidgets.QWidget)]:
        shiboken.invalidate(widget)


def frame_of(dock):
    """What has the width that a dock of the main window is seen with: itself, or what lies round it.

    Since FreeCAD 1.0 a dock may lie over the 3D view, in a widget at the window's edge of which the
    window's layout knows nothing, and which cuts off what is wider.
    """
    over = dock.parentWidget()
    while over is not None and not over.metaObject().className().endswith("OverlayTabWidget"):
        over = over.parentWidget()
    return dock if over is None else over


def widen(dock, width: int) -> None:
    """Makes a dock of the main window at least so wide, px; one that is folded away is left so."""
    frame = frame_of(dock)
    if frame is dock:
        if dock.width() < width:
            dock.window().resizeDocks([dock], [width], QtCore.Qt.Horizontal)
        return
    place = frame.geometry()
    if place.width() >= width or not dock.isVisible():
        return
    if place.right() >= dock.window().width() - 2:
        place.setLeft(place.right() + 1 - width)
    else:
        place.setWidth(width)
    frame.setGeometry(place)

# SPDX-License-Identifier: LGPL-2.1-or-later
"""The only place that imports Qt: FreeCAD 0.20 lacks `PySide.QtWidgets`, later ones `PySide2`."""

import shiboken2
from PySide import QtCore, QtGui

try:
    from PySide import QtWidgets
except ImportError:
    QtWidgets = QtGui

__all__ = ["QtCore", "QtGui", "QtWidgets", "forget", "translate"]


def translate(context: str, text: str) -> str:
    """A text in the user's language, else as it is."""
    return QtCore.QCoreApplication.translate(context, text)


def forget(form) -> None:
    """Tells PySide that the widgets of a form, which somebody is about to delete, are gone.

    It keeps the wrapper of a widget whose signal was connected or that has an event filter, knows
    widgets by address, and would take the next widget at that address for the one deleted.
    """
    for widget in [form, *form.findChildren(QtWidgets.QWidget)]:
        shiboken2.invalidate(widget)

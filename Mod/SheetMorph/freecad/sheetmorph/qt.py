# SPDX-License-Identifier: LGPL-2.1-or-later
"""The only place that imports Qt: FreeCAD 0.20 lacks `PySide.QtWidgets`, later ones `PySide2`."""

from PySide import QtCore, QtGui

try:
    from PySide import QtWidgets
except ImportError:
    QtWidgets = QtGui

__all__ = ["QtCore", "QtGui", "QtWidgets"]

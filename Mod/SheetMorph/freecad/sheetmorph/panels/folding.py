# SPDX-License-Identifier: LGPL-2.1-or-later
"""Groups of a panel that fold to their title, so that it fits a small screen."""

from freecad.sheetmorph import preferences
from freecad.sheetmorph.qt import QtCore, QtGui, QtWidgets

RIGHT, DOWN = ((10, 6), (24, 16), (10, 26)), ((6, 10), (26, 10), (16, 24))


class Folds:
    """Lets groups fold; the preferences remember which are open."""

    def __init__(self, entries: dict):
        """``entries``: QGroupBox -> entry of the preferences."""
        self._buttons = {entry: foldable(group) for group, entry in entries.items()}
        for entry, button in self._buttons.items():
            button.setChecked(preferences.get(entry))
            button.toggled.connect(lambda is_open, of=entry: preferences.put(of, is_open))


def foldable(group):
    """Puts what is in a QGroupBox below a button with its title; returns the button, off."""
    inside = QtWidgets.QWidget(group)
    inside.setLayout(group.layout())  # which takes it from the group
    inside.layout().setContentsMargins(9, 0, 9, 6)
    button = QtWidgets.QToolButton(group)
    button.setObjectName(f"fold_{group.objectName()}")
    button.setText(group.title())
    button.setToolTip(group.toolTip())
    button.setIcon(arrows(button.palette()))
    button.setToolButtonStyle(QtCore.Qt.ToolButtonTextBesideIcon)
    button.setAutoRaise(True)
    button.setCheckable(True)
    group.setTitle("")
    group.setFlat(True)
    column = QtWidgets.QVBoxLayout(group)
    column.setContentsMargins(0, 0, 0, 0)
    column.setSpacing(2)
    column.addWidget(button)
    column.addWidget(inside)
    inside.setVisible(False)
    button.toggled.connect(inside.setVisible)
    return button


def arrows(palette):
    """An icon that points to the right while off and down while on, as dark as the text."""
    icon = QtGui.QIcon()
    for state, corners in ((QtGui.QIcon.Off, RIGHT), (QtGui.QIcon.On, DOWN)):
        image = QtGui.QPixmap(32, 32)
        image.fill(QtCore.Qt.transparent)
        painter = QtGui.QPainter(image)
        painter.setRenderHint(QtGui.QPainter.Antialiasing)
        painter.setPen(QtCore.Qt.NoPen)
        painter.setBrush(palette.color(QtGui.QPalette.ButtonText))
        painter.drawPolygon(QtGui.QPolygonF([QtCore.QPointF(x, y) for x, y in corners]))
        painter.end()
        icon.addPixmap(image, QtGui.QIcon.Normal, state)
    return icon

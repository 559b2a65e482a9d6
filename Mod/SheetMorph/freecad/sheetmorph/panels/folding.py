# SPDX-License-Identifier: LGPL-2.1-or-later
"""Groups of a panel that fold to their title, so that it fits a small screen."""

from freecad.sheetmorph import preferences
from freecad.sheetmorph.qt import QtCore, QtWidgets, connect


class Folds:
    """Foldable groups; the preferences store which are open."""

    def __init__(self, entries: dict):
        """Make groups foldable; `entries` maps QGroupBox to preference entries."""
        self._buttons = {entry: foldable(group) for group, entry in entries.items()}
        for entry, button in self._buttons.items():
            button.setChecked(preferences.get(entry))
            connect(button, "toggled(bool)", lambda is_open, of=entry: preferences.put(of, is_open))


def foldable(group):
    """Put the content of a QGroupBox below a button with its title; return the button, off."""
    inside = QtWidgets.QWidget(group)
    inside.setLayout(group.layout())  # this takes the layout from the group
    inside.layout().setContentsMargins(9, 0, 9, 6)
    button = QtWidgets.QToolButton(group)
    button.setObjectName(f"fold_{group.objectName()}")
    button.setText(group.title())
    button.setToolTip(group.toolTip())
    point(button, False)
    button.setToolButtonStyle(QtCore.Qt.ToolButtonTextBesideIcon)
    button.setAutoRaise(True)
    button.setCheckable(True)
    group.setTitle("")
    group.setFlat(True)
    # the empty title takes no space
    group.setStyleSheet("QGroupBox { border: 0; margin: 0; padding: 0; }")
    column = QtWidgets.QVBoxLayout(group)
    column.setContentsMargins(0, 0, 0, 0)
    column.setSpacing(2)
    column.addWidget(button)
    column.addWidget(inside)
    inside.setVisible(False)
    connect(button, "toggled(bool)", inside.setVisible)
    connect(button, "toggled(bool)", lambda is_open: point(button, is_open))
    return button


def point(button, is_open: bool) -> None:
    """Show a down arrow for an open group, else a right arrow, drawn by the style."""
    button.setArrowType(QtCore.Qt.DownArrow if is_open else QtCore.Qt.RightArrow)

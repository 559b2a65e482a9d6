# SPDX-License-Identifier: LGPL-2.1-or-later
"""A field of a panel in which Enter does not mean OK."""

from freecad.sheetmorph.qt import QtCore

_ENTER = (QtCore.Qt.Key_Return, QtCore.Qt.Key_Enter)


class Typed(QtCore.QObject):
    """A filter that calls a function when Enter is pressed in a field."""

    def __init__(self, field, on_enter):
        super().__init__(field)
        self._on_enter = on_enter
        field.installEventFilter(self)

    def eventFilter(self, _field, event) -> bool:
        """Consume Enter and no other key."""
        if event.type() != QtCore.QEvent.KeyPress or event.key() not in _ENTER:
            return False
        self._on_enter()
        return True

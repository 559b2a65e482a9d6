# SPDX-License-Identifier: LGPL-2.1-or-later
"""The strip at the top of a panel for faults and the status.

Its height is fixed, so that nothing below it moves while frames arrive, and a fault is visible
without scrolling.
"""

from freecad.sheetmorph.qt import QtCore, QtWidgets

TAKEN = ("staying", "status", "part", "hint", "type_text", "counts")
"""Labels with changing text, which follow the fault in this order."""
PADDING = 10  # px of the red background of a fault


class Notices:
    """A strip of fixed height for the labels of a form whose text changes."""

    def __init__(self, form, lines: int):
        """Create the strip with room for a number of lines of text."""
        column = form.layout()
        self._area = QtWidgets.QScrollArea(form)
        self._area.setObjectName("notices")
        self._area.setFrameShape(QtWidgets.QFrame.NoFrame)
        self._area.setHorizontalScrollBarPolicy(QtCore.Qt.ScrollBarAlwaysOff)
        self._area.setWidgetResizable(True)
        self._area.setFixedHeight(lines * form.fontMetrics().lineSpacing() + PADDING)
        inside = QtWidgets.QWidget()
        self._lines = QtWidgets.QVBoxLayout(inside)
        self._lines.setContentsMargins(0, 0, 0, 0)
        self._lines.setSpacing(2)
        first = QtWidgets.QWidget(inside)
        beside = QtWidgets.QHBoxLayout(first)
        beside.setContentsMargins(0, 0, 0, 0)
        column.removeWidget(form.message)
        beside.addWidget(form.message, 1)  # the buttons of a fault are next to it
        self._lines.addWidget(first)
        self._lines.addStretch(1)
        self._area.setWidget(inside)
        for ground in (inside, self._area.viewport()):
            ground.setAutoFillBackground(False)
        for name in TAKEN:
            label = getattr(form, name, None)
            if label is not None and column.indexOf(label) >= 0:
                column.removeWidget(label)
                self.take(label)
        column.insertWidget(0, self._area)

    def take(self, label) -> None:
        """Append a label to the strip."""
        label.setWordWrap(True)
        self._lines.insertWidget(self._lines.count() - 1, label)

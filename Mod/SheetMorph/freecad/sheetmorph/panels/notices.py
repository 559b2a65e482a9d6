# SPDX-License-Identifier: LGPL-2.1-or-later
"""The strip at the top of a panel that says what is wrong and what is under way.

Its height is fixed. So nothing below it moves while frames arrive, and a fault is seen without
scrolling.
"""

from freecad.sheetmorph.qt import QtCore, QtWidgets

TAKEN = ("staying", "status", "part", "hint", "type_text", "counts")
"""Labels that change by themselves; they stand below the fault, in this order."""
PADDING = 10  # px: of the red ground of a fault


class Notices:
    """Takes the labels of a form that change by themselves into a strip of a fixed height."""

    def __init__(self, form, lines: int):
        """``lines``: how many lines of text the strip has room for."""
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
        beside.addWidget(form.message, 1)  # the buttons of a fault come beside it
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
        """Lets a label be the last one in the strip."""
        label.setWordWrap(True)
        self._lines.insertWidget(self._lines.count() - 1, label)

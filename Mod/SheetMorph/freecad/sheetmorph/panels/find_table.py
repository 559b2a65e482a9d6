# SPDX-License-Identifier: LGPL-2.1-or-later
"""The list of proposals: one row each, sortable, with a check box."""

from freecad.sheetmorph.qt import QtCore, QtGui, QtWidgets

NUMBER = QtCore.Qt.UserRole
VALUE = QtCore.Qt.UserRole + 1
HEIGHT = 230  # px, for ten rows
GREY = (128, 132, 138)  # readable on white and on dark styles


class Cell(QtWidgets.QTableWidgetItem):
    """A cell that is sorted by its value, not by its text."""

    def __lt__(self, other) -> bool:
        mine, theirs = self.data(VALUE), other.data(VALUE)
        return mine < theirs if type(mine) is type(theirs) else str(mine) < str(theirs)


def prepare(table, columns) -> None:
    """Set the columns and report the row under the mouse."""
    table.setColumnCount(len(columns))
    table.setHorizontalHeaderLabels(columns)
    table.setMinimumHeight(HEIGHT)
    table.setMouseTracking(True)
    table.verticalHeader().setVisible(False)
    rows = table.verticalHeader()
    rows.setMinimumSectionSize(22)
    rows.setSectionResizeMode(QtWidgets.QHeaderView.ResizeToContents)  # show names in full
    table.setWordWrap(True)
    header = table.horizontalHeader()
    for column in range(len(columns)):
        fit = QtWidgets.QHeaderView.ResizeToContents
        header.setSectionResizeMode(column, fit if column else QtWidgets.QHeaderView.Stretch)


def freeze(table) -> None:
    """Fix the heights of all rows, which closing a long list would measure again."""
    table.verticalHeader().setSectionResizeMode(QtWidgets.QHeaderView.Fixed)


def fill(table, rows) -> None:
    """Show rows of (texts, values to sort by, is checked, may be checked, tooltip)."""
    table.blockSignals(True)
    table.setSortingEnabled(False)
    table.setRowCount(len(rows))
    for number, (texts, values, is_checked, may_be, tip) in enumerate(rows):
        for column, (text, value) in enumerate(zip(texts, values)):
            cell = Cell(text)
            cell.setData(VALUE, value)
            cell.setToolTip(tip)
            flags = QtCore.Qt.ItemIsSelectable | QtCore.Qt.ItemIsEnabled
            # dark styles draw the text of a disabled item as dark as its background
            if not may_be:
                cell.setForeground(QtGui.QBrush(QtGui.QColor(*GREY)))
            if column == 0:
                cell.setData(NUMBER, number)
                flags |= QtCore.Qt.ItemIsUserCheckable if may_be else QtCore.Qt.NoItemFlags
                cell.setCheckState(QtCore.Qt.Checked if is_checked else QtCore.Qt.Unchecked)
            else:
                cell.setTextAlignment(QtCore.Qt.AlignRight | QtCore.Qt.AlignVCenter)
            cell.setFlags(flags)
            table.setItem(number, column, cell)
    table.setSortingEnabled(True)
    table.blockSignals(False)


def number_in(table, row: int) -> int:
    """Return the number of the proposal in a row."""
    return int(table.item(row, 0).data(NUMBER))


def checked(table) -> list[int]:
    """Return the sorted numbers of the proposals that are checked and visible."""
    rows = [row for row in range(table.rowCount()) if not table.isRowHidden(row)]
    is_on = [table.item(row, 0).checkState() == QtCore.Qt.Checked for row in rows]
    return sorted(number_in(table, row) for row, on in zip(rows, is_on) if on)


def set_checks(table, is_on: bool) -> None:
    """Check or clear all visible rows that may be checked, without signals."""
    table.blockSignals(True)
    for row in range(table.rowCount()):
        cell = table.item(row, 0)
        if not table.isRowHidden(row) and cell.flags() & QtCore.Qt.ItemIsUserCheckable:
            cell.setCheckState(QtCore.Qt.Checked if is_on else QtCore.Qt.Unchecked)
    table.blockSignals(False)
    table.viewport().update()

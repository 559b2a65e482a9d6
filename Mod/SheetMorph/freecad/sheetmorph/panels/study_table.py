# SPDX-License-Identifier: LGPL-2.1-or-later
"""The two tables of the study panel: parameters and results."""

from freecad.sheetmorph.bridge.units import number_in
from freecad.sheetmorph.panels.find_table import VALUE, Cell
from freecad.sheetmorph.qt import QtCore, QtGui, QtWidgets, translate
from freecad.sheetmorph.tools import words
from freecad.sheetmorph.tools.marked import QT_TRANSLATE_NOOP
from freecad.sheetmorph.tools.studies import LENGTH, NUMBER

NAME, WHAT, LOW, HIGH = range(4)
HEADS = (
    QT_TRANSLATE_NOOP("SheetMorph_panels", "Name"),
    QT_TRANSLATE_NOOP("SheetMorph_panels", "Number"),
    QT_TRANSLATE_NOOP("SheetMorph_panels", "From"),
    QT_TRANSLATE_NOOP("SheetMorph_panels", "To"),
)
MARKS = {
    "passed": ("✓", "#2e9e5b", QT_TRANSLATE_NOOP("SheetMorph_panels", "passed")),
    "failed": ("✗", "#d64545", QT_TRANSLATE_NOOP("SheetMorph_panels", "failed")),
    "refused": ("–", "#c98500", QT_TRANSLATE_NOOP("SheetMorph_panels", "refused")),
    "error": ("!", "#d64545", QT_TRANSLATE_NOOP("SheetMorph_panels", "error")),
}
HEADINGS = {
    "angle": QT_TRANSLATE_NOOP("SheetMorph_panels", "smallest corner, °"),
    "stretch": QT_TRANSLATE_NOOP("SheetMorph_panels", "stretch, %"),
}
"""The headings of measures whose names do not say their unit."""
READ_ONLY = QtCore.Qt.ItemIsEnabled | QtCore.Qt.ItemIsSelectable
RIGHT = QtCore.Qt.AlignRight | QtCore.Qt.AlignVCenter


def prepare(table, heads, stretched: int) -> None:
    """Set the columns; one of them takes the remaining width."""
    table.setColumnCount(len(heads))
    table.setHorizontalHeaderLabels(heads)
    table.verticalHeader().setVisible(False)
    table.setSelectionBehavior(QtWidgets.QAbstractItemView.SelectRows)
    header = table.horizontalHeader()
    for column in range(len(heads)):
        fit = QtWidgets.QHeaderView.ResizeToContents
        fit = QtWidgets.QHeaderView.Stretch if column == stretched else fit
        header.setSectionResizeMode(column, fit)


def fill_parameters(table, rows) -> None:
    """Show rows of (name, variable, low, high)."""
    table.setRowCount(len(rows))
    for row, (name, variable, low, high) in enumerate(rows):
        texts = (name, variable.label, told(low, variable.unit), told(high, variable.unit))
        for column, text in enumerate(texts):
            item = QtWidgets.QTableWidgetItem(text)
            if column == WHAT:
                item.setFlags(READ_ONLY)
            if column in (LOW, HIGH):
                item.setTextAlignment(RIGHT)
            table.setItem(row, column, item)


def lock(table, is_locked: bool) -> None:
    """Lock or unlock editing; a disabled table would be unreadable in dark styles."""
    by_hand = QtWidgets.QAbstractItemView.DoubleClicked | QtWidgets.QAbstractItemView.AnyKeyPressed
    never = QtWidgets.QAbstractItemView.NoEditTriggers
    table.setEditTriggers(never if is_locked else by_hand)


def parameters_in(table, variables) -> list:
    """Return the (name, variable, low, high) that the user has entered.

    Raises ValueError for text that is not a number.
    """
    found = []
    for row, variable in enumerate(variables):
        name = table.item(row, NAME).text().strip()
        ends = []
        for column in (LOW, HIGH):
            text = table.item(row, column).text()
            value = number_in(text, variable.unit)
            if value is None:
                fault = translate("SheetMorph_panels", "“{0}” for “{1}” is not a number.")
                raise ValueError(fault.format(text, name))
            ends.append(value)
        found.append((name, variable, *ends))
    return found


def told(value: float, unit: str) -> str:
    """Return a number with its unit, from which it is read back exactly."""
    if unit == NUMBER:
        return repr(value)
    return f"{value!r} mm" if unit == LENGTH else f"{value!r}°"


def fill_results(table, results: dict) -> None:
    """Show the results of a study, empty before the first run."""
    names, measures = list(results.get("parameters", {})), results.get("measures", [])
    heads = [
        translate("SheetMorph_panels", "Run"),
        translate("SheetMorph_panels", "State"),
        *names,
        *(translate("SheetMorph_panels", HEADINGS[m]) if m in HEADINGS else m for m in measures),
    ]
    prepare(table, heads, len(heads) - 1)
    table.setSortingEnabled(False)
    rows = results.get("runs", [])
    table.setRowCount(len(rows))
    for number, row in enumerate(rows):
        put(table, (number, 0), str(row["run"]), row["run"])
        mark, colour, word = MARKS[row["status"]]
        state = f"{mark} {translate('SheetMorph_panels', word)}"
        cell = put(table, (number, 1), state, row["status"])
        cell.setForeground(QtGui.QBrush(QtGui.QColor(colour)))
        cell.setToolTip(row["why"])
        values = [row["parameters"].get(name) for name in names]
        values += [row["measures"].get(name) for name in measures]
        for column, value in enumerate(values, 2):
            is_share = column - 2 >= len(names) and measures[column - 2 - len(names)] == "stretch"
            put(table, (number, column), shown(value, 100.0 if is_share else 1.0), value)
    table.setSortingEnabled(True)


def shown(value: float | None, factor: float) -> str:
    """Return a value of the table as text, empty without one."""
    return "" if value is None else words.plain(factor * value, 4)


def put(table, place: tuple, text: str, value):
    """Create a cell that is sorted by its value, and return it."""
    cell = Cell(text)
    cell.setData(VALUE, value)
    cell.setFlags(READ_ONLY)
    cell.setTextAlignment(RIGHT)
    table.setItem(*place, cell)
    return cell


def run_in(table, row: int) -> int:
    """Return the number of the run in a row."""
    return int(table.item(row, 0).data(VALUE))


def counted(results: dict) -> str:
    """Return the number of variants in each state as text."""
    texts = [
        f"{count} {translate('SheetMorph_panels', MARKS[status][2])}"
        for status, count in results.get("counts", {}).items()
        if count
    ]
    return ", ".join(texts)

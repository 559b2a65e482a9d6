# SPDX-License-Identifier: LGPL-2.1-or-later
"""A field for a number, a length or an angle that stores its exact value.

The fields of Qt and FreeCAD replace a number by its rounded text: 1.2345 mm becomes 1.23 mm when
shown, and 1 mm becomes 0 in feet. FreeCAD also reads a number without a unit in the unit shown
before, which may be nanometres.
"""

from functools import cache

import FreeCADGui as Gui

from freecad.sheetmorph.bridge import units
from freecad.sheetmorph.qt import QtCore, QtGui, QtWidgets, connect

LENGTH = "Gui::QuantitySpinBox"  # FreeCAD's field for a length
REPLACED = (LENGTH, "QDoubleSpinBox")
COPIED = ("objectName", "toolTip", "minimumSize", "sizePolicy", "suffix", "singleStep")
COPIED += ("keyboardTracking", "buttonSymbols", "specialValueText")
FARTHEST = 1e15
DIGITS = 30  # decimals: Qt rounds the stored number to these
USUAL = 12345.67  # a number that the field must have room for


class NumberField(QtWidgets.QDoubleSpinBox):
    """A field with an exact `value()`, shown with a unit or `shown_decimals`.

    If the minimum has a `specialValueText`, an empty field means the minimum too. With
    `leaves_undo`, the keys of undo and redo go to the document unless the user is typing.
    """

    leaves_undo = False

    def __init__(self, unit: str = "", shown_decimals: int = 2):
        """Create a field; `unit` is "mm", "deg" or empty."""
        super().__init__()
        self._unit, self._decimals = unit, shown_decimals
        self._shown = "", 1.0  # the text, and the size of its unit in mm or degrees
        connect(self, "editingFinished()", self._finish)
        self.setDecimals(DIGITS)
        self.setRange(-FARTHEST, FARTHEST)

    @property
    def is_edited(self) -> bool:
        """Whether the user has typed something that does not count yet."""
        return self.hasFocus() and self.lineEdit().isModified()

    def setValue(self, value: float) -> None:
        """Set the value, unless the user is typing another one."""
        if not self.is_edited:
            super().setValue(value)

    def _finish(self) -> None:
        self.lineEdit().setModified(False)

    def focusInEvent(self, event) -> None:
        """Watch the keys; not before, since a filter slows down every event of a field."""
        super().focusInEvent(event)
        self.installEventFilter(self)

    def focusOutEvent(self, event) -> None:
        """Watch the keys no longer."""
        self.removeEventFilter(self)
        super().focusOutEvent(event)

    def eventFilter(self, _watched, event) -> bool:
        """Leave the keys of undo and redo to the document, which the field would claim."""
        if event.type() != QtCore.QEvent.ShortcutOverride or self.is_edited:
            return False
        is_step = event.matches(QtGui.QKeySequence.Undo) or event.matches(QtGui.QKeySequence.Redo)
        if is_step and self.leaves_undo:
            event.ignore()
        return is_step and self.leaves_undo

    def measure(self, unit: str) -> None:
        """Set the unit, "mm" for lengths or "deg" for angles."""
        self._unit = unit
        self.setValue(self.value())

    def textFromValue(self, value: float) -> str:
        """Return the number as text, without the suffix that Qt adds."""
        said = self._said(value)
        if value == self.value():
            self._shown = said
        return said[0]

    def valueFromText(self, text: str) -> float:
        """Return the typed value; for the shown text, the exact value."""
        if self._is_special(text):
            return self.minimum()
        found = None if text == self._shown[0] + self.suffix() else self._typed(text)
        return self.value() if found is None else found

    def validate(self, text: str, place: int):
        """Accept any text while typing, but only numbers as final."""
        is_said = self._is_special(text) or self._typed(text) is not None
        states = QtGui.QValidator
        return (states.Acceptable if is_said else states.Intermediate, text, place)

    def sizeHint(self):
        """Return a size for usual numbers, not for the largest."""
        option = QtWidgets.QStyleOptionSpinBox()
        self.initStyleOption(option)
        room, ends = self.fontMetrics().horizontalAdvance, (self.minimum(), self.maximum())
        usual = (min(max(end, -USUAL), USUAL) for end in ends)
        width = max(room(f"{self._said(value)[0]}{self.suffix()} ") for value in usual)
        width = max(width, room(f"{self.specialValueText()} "))
        size = QtCore.QSize(width, self.lineEdit().sizeHint().height())
        return self.style().sizeFromContents(QtWidgets.QStyle.CT_SpinBox, option, size, self)

    def minimumSizeHint(self):
        """Return the same size."""
        return self.sizeHint()

    def _is_special(self, text: str) -> bool:
        return bool(self.specialValueText()) and text.strip() in ("", self.specialValueText())

    def _typed(self, text: str):
        """Return the typed number, in the shown unit if it has none; None if it is invalid."""
        text = text.replace(self.suffix().strip() or " ", " ")
        return units.number_in(text, self._unit, self._shown[1])

    def _said(self, value: float) -> tuple[str, float]:
        if not self._unit:
            return f"{value:.{self._decimals}f}", 1.0
        return units.said(value, self._unit)


@cache
def loader():
    """Return the one loader of Qt Designer files: each loader leaks a little memory."""
    return Gui.UiLoader()


def loaded(file: str):
    """Return the widgets of a Qt Designer file, with its number fields replaced."""
    form = loader().load(file)
    layouts = form.findChildren(QtWidgets.QLayout)
    for name, widget in list(vars(form).items()):
        # widget.metaObject() would give the class too, but PySide never frees its result.
        if isinstance(widget, QtWidgets.QWidget) and any(map(widget.inherits, REPLACED)):
            layout = next(one for one in layouts if one.indexOf(widget) >= 0)
            setattr(form, name, replaced(widget, layout))
    return form


def replaced(old, layout) -> NumberField:
    """Return a field that replaces an old one, which is deleted."""
    is_length = old.inherits(LENGTH)
    new = NumberField("mm") if is_length else NumberField("", old.property("decimals"))
    low, high = float(old.property("minimum")), float(old.property("maximum"))
    new.setRange(max(low, -FARTHEST), min(high, FARTHEST))
    for name in COPIED:
        value = old.property(name)
        if value is not None:
            new.setProperty(name, value)
    new.setValue(float(old.property("rawValue" if is_length else "value")))
    layout.replaceWidget(old, new)
    QtWidgets.QWidget.setTabOrder(old, new)
    old.setObjectName("")  # it exists for a moment longer
    old.hide()
    old.deleteLater()
    return new

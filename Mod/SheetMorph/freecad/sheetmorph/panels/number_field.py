# SPDX-License-Identifier: LGPL-2.1-or-later
"""A field for a number, a length or an angle that keeps the number it was given.

The fields of Qt and FreeCAD take their rounded text for the number: 1.2345 mm is 1.23 mm as soon
as it is shown, 1 mm is 0 where lengths are in feet. And FreeCAD takes a number without a unit for
one of whatever unit was shown before, of nanometres perhaps.
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
DIGITS = 30  # after the point: Qt rounds the number itself to them
USUAL = 12345.67  # what there is room for


class NumberField(QtWidgets.QDoubleSpinBox):
    """``value()`` is exact; what is shown has a unit, or ``shown_decimals``.

    Where the least one has a ``specialValueText``, an empty field stands for it too.
    """

    def __init__(self, unit: str = "", shown_decimals: int = 2):
        """``unit``: "mm", "deg" or none."""
        super().__init__()
        self._unit, self._decimals = unit, shown_decimals
        self._shown = "", 1.0  # and how many mm or degrees its unit has
        connect(self, "editingFinished()", self._finish)
        self.setDecimals(DIGITS)
        self.setRange(-FARTHEST, FARTHEST)

    @property
    def is_edited(self) -> bool:
        """Whether the user has typed something that does not count yet."""
        return self.hasFocus() and self.lineEdit().isModified()

    def setValue(self, value: float) -> None:
        """Shows a value, except where the user is typing another one: that one will count."""
        if not self.is_edited:
            super().setValue(value)

    def _finish(self) -> None:
        self.lineEdit().setModified(False)

    def measure(self, unit: str) -> None:
        """Is for lengths, "mm", or angles, "deg"."""
        self._unit = unit
        self.setValue(self.value())

    def textFromValue(self, value: float) -> str:
        """The number as it is read, without what Qt puts behind it."""
        said = self._said(value)
        if value == self.value():
            self._shown = said
        return said[0]

    def valueFromText(self, text: str) -> float:
        """What was typed; of what is shown the number itself."""
        if self._is_special(text):
            return self.minimum()
        found = None if text == self._shown[0] + self.suffix() else self._typed(text)
        return self.value() if found is None else found

    def validate(self, text: str, place: int):
        """Everything may be typed on the way; what says no number is not taken."""
        is_said = self._is_special(text) or self._typed(text) is not None
        states = QtGui.QValidator
        return (states.Acceptable if is_said else states.Intermediate, text, place)

    def sizeHint(self):
        """Room for usual numbers, not for the farthest."""
        option = QtWidgets.QStyleOptionSpinBox()
        self.initStyleOption(option)
        room, ends = self.fontMetrics().horizontalAdvance, (self.minimum(), self.maximum())
        usual = (min(max(end, -USUAL), USUAL) for end in ends)
        width = max(room(f"{self._said(value)[0]}{self.suffix()} ") for value in usual)
        width = max(width, room(f"{self.specialValueText()} "))
        size = QtCore.QSize(width, self.lineEdit().sizeHint().height())
        return self.style().sizeFromContents(QtWidgets.QStyle.CT_SpinBox, option, size, self)

    def minimumSizeHint(self):
        """As much."""
        return self.sizeHint()

    def _is_special(self, text: str) -> bool:
        return bool(self.specialValueText()) and text.strip() in ("", self.specialValueText())

    def _typed(self, text: str):
        """A number without a unit is one of the unit that is shown; None if it says nothing."""
        text = text.replace(self.suffix().strip() or " ", " ")
        return units.number_in(text, self._unit, self._shown[1])

    def _said(self, value: float) -> tuple[str, float]:
        if not self._unit:
            return f"{value:.{self._decimals}f}", 1.0
        return units.said(value, self._unit)


@cache
def loader():
    """FreeCAD's loader of files of Qt Designer, one for all: it keeps a little of each that is
    made."""
    return Gui.UiLoader()


def loaded(file: str):
    """The widgets of a file of Qt Designer; all its fields for numbers are ones of this kind."""
    form = loader().load(file)
    layouts = form.findChildren(QtWidgets.QLayout)
    for name, widget in list(vars(form).items()):
        # widget.metaObject() would say so too, but PySide never frees what it returns.
        if isinstance(widget, QtWidgets.QWidget) and any(map(widget.inherits, REPLACED)):
            layout = next(one for one in layouts if one.indexOf(widget) >= 0)
            setattr(form, name, replaced(widget, layout))
    return form


def replaced(old, layout) -> NumberField:
    """A field in the place of an old one, which goes."""
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
    old.setObjectName("")  # it stays for a moment
    old.hide()
    old.deleteLater()
    return new

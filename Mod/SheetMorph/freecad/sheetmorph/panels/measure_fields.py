# SPDX-License-Identifier: LGPL-2.1-or-later
"""The measurement in the Move Handle panel."""

from freecad.sheetmorph.bridge import units
from freecad.sheetmorph.interaction.measuring import Measuring
from freecad.sheetmorph.qt import connect, translate


class MeasureFields:
    """The link from the widgets to a Measuring, until `remove`."""

    def __init__(self, form, view):
        self._form, self._measuring = form, Measuring(view, beside_line, self._tell)
        form.distance.setFixedHeight(2 * form.fontMetrics().lineSpacing())
        connect(form.measure, "toggled(bool)", self._use)
        connect(form.points, "toggled(bool)", self._give_way)
        self._tell()

    def connect(self, live) -> None:
        """Follow the frames of a LiveUpdate."""
        self._measuring.connect(live)

    def remove(self) -> None:
        """End the measurement."""
        self._measuring.remove()

    def _use(self, is_on: bool) -> None:
        if is_on:
            self._form.points.setChecked(False)  # each of the two needs the clicks
        self._measuring.use(is_on)

    def _give_way(self, is_dragging: bool) -> None:
        if is_dragging:
            self._form.measure.setChecked(False)

    def _tell(self) -> None:
        form, measuring = self._form, self._measuring
        form.measure.setChecked(measuring.is_on)
        form.distance.setVisible(measuring.is_on)
        if measuring.distance is not None:
            form.distance.setText(described(measuring.distance))
        elif measuring.is_begun:
            form.distance.setText(translate("SheetMorph_panels", "Click the second point."))
        else:
            form.distance.setText(translate("SheetMorph_panels", "Click two points of the parts."))


def described(distance) -> str:
    """Return a places.Distance as a sentence."""
    now, rest, change = said(distance.now), said(distance.rest), signed(distance.change)
    text = translate("SheetMorph_panels", "Distance {0}; at rest {1}; change {2}")
    return text.format(now, rest, change)


def beside_line(distance) -> str:
    """Return the short text at the line in the 3D view."""
    return f"{said(distance.now)} ({signed(distance.change)})"


def said(length: float) -> str:
    """Return a length in the user's unit; a frame is not exact below 0.001 mm."""
    return units.said(round(length, 3) + 0.0, "mm")[0]


def signed(length: float) -> str:
    """Return a change of length with its sign."""
    text = said(length)
    return f"+{text}" if round(length, 3) > 0.0 else text

# SPDX-License-Identifier: LGPL-2.1-or-later
"""The options of the mouse in the Move Handle panel."""

from freecad.sheetmorph import preferences
from freecad.sheetmorph.qt import connect


class MouseFields:
    """The link from the widgets to the drag; the preferences store the choices."""

    def __init__(self, form, drag):
        self._form, self._drag = form, drag
        form.arrows.setChecked(preferences.get("ShowArrows"))
        form.snap.setChecked(preferences.get("Snap"))
        for field, unit, entry in self._steps():
            field.measure(unit)
            field.setMinimum(0.001)
            field.setValue(preferences.get(entry))
            connect(field, "valueChanged(double)", self._choose_steps)
        connect(form.arrows, "toggled(bool)", self._show_arrows)
        connect(form.points, "toggled(bool)", drag.use_points)
        form.snap_points.setChecked(preferences.get("SnapPoints"))
        for box in (form.snap, form.snap_points):
            connect(box, "toggled(bool)", self._choose_steps)
        connect(form.move_pivot, "toggled(bool)", self._move_pivot)
        self._snap()
        drag.show_arrows(form.arrows.isChecked())

    def _steps(self):
        return (
            (self._form.snap_length, "mm", "SnapLength"),
            (self._form.snap_angle, "deg", "SnapAngle"),
        )

    def _snap(self) -> None:
        values = [field.value() for field, *_ in self._steps()]
        form = self._form
        self._drag.snap(values, form.snap.isChecked(), form.snap_points.isChecked())

    def _choose_steps(self, *_) -> None:
        preferences.put("Snap", self._form.snap.isChecked())
        preferences.put("SnapPoints", self._form.snap_points.isChecked())
        for field, _unit, entry in self._steps():
            preferences.put(entry, field.value())
        self._snap()

    def _show_arrows(self, is_shown: bool) -> None:
        preferences.put("ShowArrows", is_shown)
        self._drag.show_arrows(is_shown)

    def _move_pivot(self, is_on: bool) -> None:
        self._drag.moves_pivot = is_on

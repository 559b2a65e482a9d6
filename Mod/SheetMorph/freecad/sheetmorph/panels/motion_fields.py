# SPDX-License-Identifier: LGPL-2.1-or-later
"""The fields of a motion in the Move Handle panel."""

from freecad.sheetmorph.panels.base import CHOSEN
from freecad.sheetmorph.qt import QtCore, connect, translate
from freecad.sheetmorph.tools.local_axes import GLOBAL, to_global, to_local
from freecad.sheetmorph.tools.motion import UP, Motion

DRIVEN = {
    "translation_x": "TranslationX",
    "translation_y": "TranslationY",
    "translation_z": "TranslationZ",
    "angle": "Angle",
}


class MotionFields(QtCore.QObject):
    """The link from fields to a motion; `changed` is sent when the user changes one."""

    changed = QtCore.Signal()

    def __init__(self, form):
        super().__init__()
        self._form = form
        self._is_writing = False
        self._at_centroid = True
        self.axes = GLOBAL
        form.angle.measure("deg")
        connect(form.angle, "valueChanged(double)", self._send)
        for c in "xyz":
            connect(getattr(form, f"translation_{c}"), "valueChanged(double)", self._send)
            connect(getattr(form, f"axis_{c}"), "valueChanged(double)", self._send)
            connect(getattr(form, f"pivot_{c}"), "valueChanged(double)", self._leave_centroid)
            getattr(form, f"along_{c}").setCheckable(True)
            getattr(form, f"along_{c}").setStyleSheet(CHOSEN)
            connect(
                getattr(form, f"along_{c}"), "clicked()", lambda _=False, d=c: self._turn_about(d)
            )
        connect(form.centre, "clicked()", self._return_to_centroid)

    def read(self) -> Motion:
        """Return the motion in the fields, whose vectors are along the columns of `axes`."""
        form = self._form
        shift, axis = (to_global(self.axes, self._vector(kind)) for kind in ("translation", "axis"))
        pivot = tuple(getattr(form, f"pivot_{c}").value() for c in "xyz")
        return Motion(shift, axis, form.angle.value(), None if self._at_centroid else pivot)

    @property
    def is_global(self) -> bool:
        """Whether the fields are about global axes."""
        return self.axes is GLOBAL

    def _vector(self, kind: str) -> tuple:
        return tuple(getattr(self._form, f"{kind}_{c}").value() for c in "xyz")

    def write(self, motion: Motion, pivot) -> None:
        """Show a motion without sending `changed`; `pivot` (3,) mm is the centroid."""
        self._is_writing = True
        self._at_centroid = motion.pivot is None
        shown = pivot if self._at_centroid else motion.pivot
        shift, axis = (to_local(self.axes, v) for v in (motion.translation, motion.axis))
        if not motion.angle and not self.is_global:
            axis = UP  # the handle's normal, as no axis is in use
        for k, c in enumerate("xyz"):
            getattr(self._form, f"translation_{c}").setValue(shift[k])
            getattr(self._form, f"axis_{c}").setValue(axis[k])
            getattr(self._form, f"pivot_{c}").setValue(shown[k])
        self._form.angle.setValue(motion.angle)
        self._form.centre.setEnabled(not self._at_centroid)
        self._show_direction()
        self._is_writing = False

    def show_pivot(self, pivot) -> None:
        """Show the position of the pivot, (3,) mm, if it is the centroid."""
        if not self._at_centroid:
            return
        self._is_writing = True
        for k, c in enumerate("xyz"):
            getattr(self._form, f"pivot_{c}").setValue(pivot[k])
        self._is_writing = False

    def lock(self, expressions: dict[str, str]) -> None:
        """Lock the fields that an expression drives; `expressions` are by property."""
        for field, owner in DRIVEN.items():
            text = expressions.get(owner, "")
            widget = getattr(self._form, field)
            widget.setEnabled(not text)
            if text:
                said = translate("SheetMorph_panels", "Driven by the expression {0}")
                widget.setToolTip(said.format(text))

    def _send(self, *_) -> None:
        if not self._is_writing:
            self._show_direction()
            self.changed.emit()

    def _show_direction(self) -> None:
        """Press the button of the axis in the fields, if it is x, y or z."""
        axis = self._vector("axis")
        for k, c in enumerate("xyz"):
            is_along = axis[k] > 0.0 and not any(axis[:k] + axis[k + 1 :])
            getattr(self._form, f"along_{c}").setChecked(is_along)

    def _leave_centroid(self, *_) -> None:
        if not self._is_writing:
            self._at_centroid = False
            self._form.centre.setEnabled(True)
            self.changed.emit()

    def _return_to_centroid(self) -> None:
        self._at_centroid = True
        self._form.centre.setEnabled(False)
        self.changed.emit()

    def _turn_about(self, direction: str) -> None:
        self._is_writing = True
        for c in "xyz":
            getattr(self._form, f"axis_{c}").setValue(1.0 if c == direction else 0.0)
        self._show_direction()
        self._is_writing = False
        self.changed.emit()

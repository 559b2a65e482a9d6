# SPDX-License-Identifier: LGPL-2.1-or-later
"""The fields of a motion in the Move Handle panel."""

from freecad.sheetmorph.panels.base import CHOSEN, say
from freecad.sheetmorph.qt import connect, translate
from freecad.sheetmorph.tools.local_axes import to_global, to_local
from freecad.sheetmorph.tools.motion import UP, Motion

DRIVEN = {
    "translation_x": "TranslationX",
    "translation_y": "TranslationY",
    "translation_z": "TranslationZ",
    "angle": "Angle",
}


class MotionFields:
    """The fields that set and observe a motion.Moving."""

    def __init__(self, form, moving):
        self._form, self._moving = form, moving
        self._is_writing = False
        self._at_centroid = True
        form.angle.measure("deg")
        groups = ("translation", "axis", "pivot")
        fields = [getattr(form, f"{group}_{c}") for group in groups for c in "xyz"] + [form.angle]
        for field in fields:
            moved = self._leave_centroid if field in fields[6:9] else self._send
            connect(field, "valueChanged(double)", moved)
            connect(field, "editingFinished()", self._end_typing)
            field.leaves_undo = True
        for c in "xyz":
            button = getattr(form, f"along_{c}")
            button.setCheckable(True)
            button.setStyleSheet(CHOSEN)
            connect(button, "clicked()", lambda _=False, d=c: self._turn_about(d))
        connect(form.centre, "clicked()", self._return_to_centroid)
        moving.observe(self._show)

    @property
    def is_valid(self) -> bool:
        """Whether the fields have a motion; a message says why not."""
        return not self._read().fault()

    def _read(self) -> Motion:
        """Return the motion in the fields, whose vectors are along the axes of `moving`."""
        form, axes = self._form, self._moving.axes
        shift, axis = (to_global(axes, self._vector(kind)) for kind in ("translation", "axis"))
        pivot = tuple(getattr(form, f"pivot_{c}").value() for c in "xyz")
        return Motion(shift, axis, form.angle.value(), None if self._at_centroid else pivot)

    def _vector(self, kind: str) -> tuple:
        return tuple(getattr(self._form, f"{kind}_{c}").value() for c in "xyz")

    def _show(self, moving, _before=None) -> None:
        """Show the motion without setting it again."""
        self._is_writing = True
        motion, pivot = moving.motion, moving.pivot
        self._at_centroid = motion.pivot is None
        shift, axis = (to_local(moving.axes, v) for v in (motion.translation, motion.axis))
        if not motion.angle and not moving.is_global:
            axis = UP  # the handle's normal, as no axis is in use
        for k, c in enumerate("xyz"):
            getattr(self._form, f"translation_{c}").setValue(shift[k])
            getattr(self._form, f"axis_{c}").setValue(axis[k])
            getattr(self._form, f"pivot_{c}").setValue(pivot[k])
        self._form.angle.setValue(motion.angle)
        self._form.centre.setEnabled(not self._at_centroid)
        say(self._form.axis_message, "")
        self._show_direction()
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
        if self._is_writing:
            return
        self._show_direction()
        motion = self._read()
        say(self._form.axis_message, motion.fault(), True)
        if not motion.fault():
            self._moving.set(motion)

    def _end_typing(self) -> None:
        """Show the value that the mouse has set while the field kept a typed one."""
        if self.is_valid:
            self._show(self._moving)

    def _show_direction(self) -> None:
        """Press the button of the axis in the fields, if it is x, y or z."""
        axis = self._vector("axis")
        for k, c in enumerate("xyz"):
            is_along = axis[k] > 0.0 and not any(axis[:k] + axis[k + 1 :])
            getattr(self._form, f"along_{c}").setChecked(is_along)

    def _leave_centroid(self, *_) -> None:
        if not self._is_writing:
            self._at_centroid = False
            self._send()

    def _return_to_centroid(self) -> None:
        self._at_centroid = True
        self._send()

    def _turn_about(self, direction: str) -> None:
        self._is_writing = True
        for c in "xyz":
            getattr(self._form, f"axis_{c}").setValue(1.0 if c == direction else 0.0)
        self._is_writing = False
        self._send()

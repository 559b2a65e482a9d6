# SPDX-License-Identifier: LGPL-2.1-or-later
"""The buttons that pick: what a click takes, and what can be done with what is picked."""

import math

from freecad.sheetmorph import paths
from freecad.sheetmorph.qt import QtGui
from freecad.sheetmorph.tools import picking

ICONS = {"facet": "PickFacet", "face": "PickFace", "rim": "PickRim", "whole": "PickPart"}
STEPS = {"grow": "grow", "shrink": "shrink", "back": "back", "clear": "clear"}
STEPS |= {"holes": "take_holes"}


class PickTools:
    """Lets the buttons of a form act on a picker; panels name their widgets alike."""

    def __init__(self, form, picker, on_change):
        """``on_change()`` is called when a button has picked or taken back."""
        self._form = form
        self._on_change = on_change
        self._tool = picking.FACE
        form.angle.setProperty("unit", "deg")
        form.angle.setProperty("minimum", 1.0)
        form.angle.setProperty("maximum", 180.0)
        form.angle.setProperty("rawValue", 30.0)
        form.angle.valueChanged.connect(self._apply)
        form.rings.valueChanged.connect(self._apply)
        for tool, icon in ICONS.items():
            button = getattr(form, tool)
            button.setIcon(QtGui.QIcon(paths.icon(icon)))
            button.clicked.connect(lambda _=False, t=tool: self.choose(t))
        for button, step in STEPS.items():
            if hasattr(form, button):
                getattr(form, button).clicked.connect(lambda _=False, s=step: self._do(s))
        self.use(picker)

    def use(self, picker) -> None:
        """Acts on a picker from now on; None: on nothing."""
        self._picker = picker
        self._apply()

    def choose(self, tool: str) -> None:
        """Chooses what a click takes."""
        self._tool = tool
        getattr(self._form, tool).setChecked(True)
        for widget in (self._form.angle, self._form.angle_label):
            widget.setVisible(tool == picking.FACE)
        for widget in (self._form.rings, self._form.rings_label):
            widget.setVisible(tool == picking.RIM)
        self._apply()

    def release(self) -> None:
        """Lets go of the widgets, see Panel.finish; nothing is picked any more."""
        self._form = self._picker = None

    def show_state(self) -> None:
        """Buttons that would do nothing are off."""
        self._form.back.setEnabled(bool(self._picker and self._picker.can_go_back))

    def _apply(self, *_) -> None:
        if self._picker is not None:
            crease = math.radians(self._form.angle.property("rawValue"))
            rings = self._form.rings.value()
            self._picker.choose(what=self._tool, crease=crease, rings=rings)

    def _do(self, step: str) -> None:
        if self._picker is not None:
            getattr(self._picker, step)()
            self._on_change()

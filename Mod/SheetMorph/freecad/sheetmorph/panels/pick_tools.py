# SPDX-License-Identifier: LGPL-2.1-or-later
"""The picking widgets that all panels share."""

import json
import math

from freecad.sheetmorph import paths, preferences
from freecad.sheetmorph.bridge import selecting
from freecad.sheetmorph.panels.base import CHOSEN
from freecad.sheetmorph.panels.folding import Folds
from freecad.sheetmorph.panels.number_field import loaded
from freecad.sheetmorph.panels.typed import Typed
from freecad.sheetmorph.qt import connect, icon_of, translate
from freecad.sheetmorph.tools import figures, picking
from freecad.sheetmorph.tools.marked import QT_TRANSLATE_NOOP
from freecad.sheetmorph.tools.sentences import KEPT

ICONS = {"vertex": "PickVertex", "facet": "PickFacet", "face": "PickFace", "rim": "PickRim"}
ICONS |= {"whole": "PickPart", "brush": "PickBrush", "rectangle": "PickRectangle"}
ICONS |= {"lasso": "PickLasso"}
STEPS = {"grow": "grow", "shrink": "shrink", "invert": "invert", "back": "back"}
STEPS |= {"clear": "clear", "holes": "take_holes"}
MODES = (picking.REPLACE, picking.ADD, picking.REMOVE)
ONLY_FOR = {
    "angle": (picking.FACE, picking.RIM),
    "rings": (picking.RIM,),
    "radius": (figures.BRUSH,),
}
KEYS = QT_TRANSLATE_NOOP("SheetMorph_picking", "Click picks, Shift adds, Ctrl removes.")
HINTS = {
    figures.BRUSH: QT_TRANSLATE_NOOP(
        "SheetMorph_picking",
        "Paint with the left button. The wheel changes the size, Ctrl+wheel zooms. "
        "Ctrl+paint removes.",
    ),
    figures.RECTANGLE: QT_TRANSLATE_NOOP(
        "SheetMorph_picking", "Drag from corner to corner. Shift adds, Ctrl removes."
    ),
    figures.LASSO: QT_TRANSLATE_NOOP(
        "SheetMorph_picking", "Hold the left button and draw an outline. Shift adds, Ctrl removes."
    ),
}


class PickTools:
    """Widgets that act on a picker, in the layout `pick_column` of a form."""

    def __init__(self, form, on_change, on_fault):
        """Create the widgets without a picker.

        `on_change()` follows a change of the picks, `on_fault(error)` an invalid selector.
        """
        self._on_change, self._on_fault = on_change, on_fault
        self._tool = picking.FACE
        self._picker = self._part = self.where = None
        self._form = widgets = loaded(paths.panel("picking"))
        form.pick_column.addWidget(widgets)
        widgets.setStyleSheet(CHOSEN)
        widgets.angle.measure("deg")
        widgets.angle.setRange(1.0, 180.0)
        widgets.angle.setValue(preferences.get("CreaseAngle"))
        widgets.rings.setValue(preferences.get("HoleRings"))
        widgets.radius.setValue(preferences.get("BrushRadius"))
        connect(widgets.angle, "valueChanged(double)", self._apply)
        for field in (widgets.rings, widgets.radius):
            connect(field, "valueChanged(int)", self._apply)
        connect(widgets.through, "toggled(bool)", self._apply)
        for mode in MODES:
            connect(getattr(widgets, f"mode_{mode}"), "toggled(bool)", self._apply)
        for tool, icon in ICONS.items():
            button = getattr(widgets, tool)
            button.setIcon(icon_of(paths.icon(icon)))
            connect(button, "clicked()", lambda _=False, t=tool: self.choose(t))
        for button, step in STEPS.items():
            connect(getattr(widgets, button), "clicked()", lambda _=False, s=step: self._do(s))
        Folds({widgets.advanced: "OpenSelector"})
        self._typed = Typed(widgets.where, self._take_typed)

    def use(self, picker, part) -> None:
        """Act on the picker of a part from now on; None for none."""
        self._picker, self._part = picker, part
        self._apply()

    def choose(self, tool: str) -> None:
        """Choose the target of a click."""
        self._tool = tool
        getattr(self._form, tool).setChecked(True)
        for field, tools in ONLY_FOR.items():
            getattr(self._form, field).setVisible(tool in tools)
            getattr(self._form, f"{field}_label").setVisible(tool in tools)
        self._form.hint.setText(translate("SheetMorph_picking", HINTS.get(tool, KEYS)))
        self._apply()

    @property
    def hint(self):
        """The label that explains the chosen tool."""
        return self._form.hint

    def offer_holes(self, is_offered: bool) -> None:
        """Show or hide the button that picks all holes."""
        self._form.holes.setVisible(is_offered)

    def turn_wheel(self, steps: float) -> None:
        """Change the radius of the brush."""
        radius = self._form.radius.value()
        wanted = figures.resized(radius, steps)
        step = 1 if steps > 0 else -1
        self._form.radius.setValue(round(wanted) if round(wanted) != radius else radius + step)

    def show_state(self) -> None:
        """Show the selector of the picks, and disable the buttons that have no effect now."""
        picker = self._picker
        self._form.back.setEnabled(bool(picker and picker.can_go_back))
        is_ready = picker is not None and self._part is not None
        self.where = selecting.words_of(self._part, picker.said) if is_ready else None
        self._form.where.setText(json.dumps(self.where) if self.where else "")

    def _take_typed(self) -> None:
        """Pick the vertices of the typed selector, or report its error."""
        text = self._form.where.text().strip()
        if not text or self._part is None:
            return
        try:
            where = json.loads(text)
            found = selecting.select(self._part, where)
        except (ValueError, TypeError) as error:
            self._on_fault(error)
            return
        self._picker.take(found, picking.REPLACE, {KEPT: where})
        self._on_change()

    def _mode(self) -> str:
        chosen = [mode for mode in MODES if getattr(self._form, f"mode_{mode}").isChecked()]
        return chosen[0] if chosen else picking.REPLACE

    def _apply(self, *_) -> None:
        if self._picker is None:
            return
        self._picker.choose(
            what=self._tool,
            mode=self._mode(),
            crease=math.radians(self._form.angle.value()),
            rings=self._form.rings.value(),
            through=self._form.through.isChecked(),
            radius=float(self._form.radius.value()),
        )

    def _do(self, step: str) -> None:
        if self._picker is not None:
            getattr(self._picker, step)()
            self._on_change()

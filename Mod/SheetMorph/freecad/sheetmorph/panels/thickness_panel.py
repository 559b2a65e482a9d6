# SPDX-License-Identifier: LGPL-2.1-or-later
"""The panel that shows the thickness of a part as colours with a legend."""

from freecad.sheetmorph import api
from freecad.sheetmorph.actions import call, name
from freecad.sheetmorph.bridge.snapshots import snapshot_of
from freecad.sheetmorph.editing.session import EditingSession
from freecad.sheetmorph.objects import assembly_of
from freecad.sheetmorph.panels import keeping
from freecad.sheetmorph.panels.base import Panel, chip, say
from freecad.sheetmorph.panels.scale import gradient
from freecad.sheetmorph.qt import QtWidgets, connect, number, translate
from freecad.sheetmorph.scene.value_map import ValueMap
from freecad.sheetmorph.tools import colour_scale, words


def open_panel(part):
    """Open the panel for a part, and return it."""
    session = EditingSession(part.Document, [part], goes_with_undo=True)
    return ThicknessPanel.opened(session, part)


class ThicknessPanel(Panel):
    """A panel without Cancel, in which the switch and the holes are undo steps."""

    def __init__(self, session, part):
        super().__init__(session, "thickness", "ThicknessMap", "Thickness")
        self._part = part
        self._solid, self._reason = api.thin_solid(part)
        self.form.bend.setChecked(part.Thin != "no")
        connect(self.form.bend, "toggled(bool)", self._switch)
        connect(self.form.mark, "clicked()", self._mark)
        session.changed.connect(self._show_switch)
        self._fill()

    def getStandardButtons(self) -> int:
        """Return Close only."""
        return number(QtWidgets.QDialogButtonBox.Close)

    def _show_switch(self) -> None:
        """Show the state of the switch after an undo."""
        self.form.bend.blockSignals(True)
        self.form.bend.setChecked(self._part.Thin != "no")
        self.form.bend.blockSignals(False)

    def _fill(self) -> None:
        form, solid = self.form, self._solid
        for widget in (form.scale, form.low, form.high, form.bend, form.mark):
            widget.setVisible(solid is not None)
        if solid is None:
            text = translate("SheetMorph_panels", "'{0}' is not a thin solid: {1}.")
            say(form.message, text.format(self._part.Label, self._reason))
            return
        values = solid.thicknesses
        span = colour_scale.span_of(values)
        form.scale.setPixmap(gradient())
        form.low.setText(words.length(span[0]))
        form.high.setText(words.length(span[1]))
        form.mark.setEnabled(bool(solid.holes))
        say(form.message, summary(solid))
        triangles = snapshot_of(self._part.Source).triangles
        colours = colour_scale.colours_of(values, span)
        self.session.show(ValueMap(self.session.view, self._part, triangles, colours))

    def _switch(self, is_on: bool) -> None:
        line = call("set_thin", name(self._part), repr("auto" if is_on else False))
        keeping.attempt("Thin Solid", line, document=self._part.Document)

    def _mark(self) -> None:
        owner = name(assembly_of(self._part))
        line = call("add_through_holes", owner, name(self._part))
        keeping.attempt("Mark Holes", line, document=self._part.Document)


def summary(solid) -> str:
    """Return the result as rich text."""
    low, high = colour_scale.range_of(solid.thicknesses)
    thickness = translate("SheetMorph_panels", "Median thickness <b>{0}</b>, from {1} to {2}")
    holes = translate("SheetMorph_panels", "Holes through both skins: {0}")
    thick = translate("SheetMorph_panels", "Thick regions (stay rigid): {0}")
    missing = translate("SheetMorph_panels", "{0} walls and thick regions: no thickness")
    values = words.length(solid.thickness, 4), words.plain(low, 4), words.length(high, 4)
    lines = [
        thickness.format(*values),
        holes.format(len(solid.holes)),
        thick.format(len(solid.lumps)),
        missing.format(chip(colour_scale.MISSING)),
    ]
    return "<br>".join(lines)

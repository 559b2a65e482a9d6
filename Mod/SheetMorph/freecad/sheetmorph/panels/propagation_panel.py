# SPDX-License-Identifier: LGPL-2.1-or-later
"""The panel that shows and controls how the motion propagates from part to part."""

import FreeCADGui as Gui

from freecad.sheetmorph import actions, api
from freecad.sheetmorph.bridge import seen
from freecad.sheetmorph.actions import call, name
from freecad.sheetmorph.editing.session import EditingSession
from freecad.sheetmorph.objects import model
from freecad.sheetmorph.objects.assembly import PROPAGATIONS, UNHELD, WHOLE
from freecad.sheetmorph.interaction import control_meshes
from freecad.sheetmorph.interaction.finishing import finishing
from freecad.sheetmorph.panels import contact_types, keeping, propagation_tree
from freecad.sheetmorph.panels.base import Panel, listed, say, say_error
from freecad.sheetmorph.qt import QtWidgets, connect, number, translate
from freecad.sheetmorph.scene import colours
from freecad.sheetmorph.scene.highlight import Highlight
from freecad.sheetmorph.scene.wireframe import Wireframe


def open_panel(assembly):
    """Open the panel for a morph, and return it."""
    session = EditingSession(assembly.Document, [assembly], goes_with_undo=True)
    return PropagationPanel.opened(session, assembly)


class PropagationPanel(Panel):
    """A panel without Cancel, in which every change is an undo step and a macro line."""

    width = 460  # for names in a tree

    def __init__(self, session, assembly):
        super().__init__(session, "propagation", "Propagation", "Propagation")
        self._assembly = assembly
        self._chosen_name = ""
        self._steps = []
        self._is_filling = False
        self._highlight = session.show(Highlight())
        self._wires = None
        session.at_end(self._remove_wires)
        session.changed.connect(self._fill)
        finishing().finished.connect(self._fill_when_done)
        session.at_end(lambda: finishing().finished.disconnect(self._fill_when_done))
        self._prepare_widgets()
        self._fill()

    def getStandardButtons(self) -> int:
        """Return Close only."""
        return number(QtWidgets.QDialogButtonBox.Close)

    def isAllowedAlterSelection(self) -> bool:
        """Return True, since a click in the panel selects in the document."""
        return True

    @property
    def _chosen(self):
        """The object of the chosen row, None if it was deleted."""
        return self._assembly.Document.getObject(self._chosen_name) if self._chosen_name else None

    # -- changes by the user

    def _change(self, title: str, function: str, *arguments: str, **keywords: str) -> None:
        """Make a change in one undo step, and show the result."""
        if not self._is_filling:
            keeping.attempt(
                title, call(function, *arguments, **keywords), document=self._assembly.Document
            )
            self._fill()

    def _change_propagation(self, *_) -> None:
        form = self.form
        self._change(
            "Propagation",
            "set_propagation",
            name(self._assembly),
            repr(PROPAGATIONS[form.kind.currentIndex()]),
            levels=repr(form.levels.value()),
            smoothness=repr(round(form.smoothness.value(), 6)),
        )

    def _change_unheld(self, index: int) -> None:
        way = repr(UNHELD[index])
        self._change("Loose Pieces", "set_unheld", name(self._assembly), way)

    def _change_mode(self, mode: int) -> None:
        self._change("Mode", "set_mode", name(self._chosen), repr(mode))

    def _change_type(self, index: int) -> None:
        kind = repr(contact_types.TYPES[index])
        self._change("Contact Type", "set_contact_type", name(self._chosen), kind)

    def _change_active(self, active: bool) -> None:
        self._change("Use Contact", "set_active", name(self._chosen), repr(bool(active)))

    def _make_primary(self, *_) -> None:
        self._change("Set as Primary", "set_primary", name(self._assembly), name(self._chosen))

    # -- the display

    def _fill(self) -> None:
        """Show the morph of the document."""
        self._is_filling = True
        form = self.form
        form.kind.setCurrentIndex(PROPAGATIONS.index(self._assembly.Propagation))
        form.unheld.setCurrentIndex(UNHELD.index(self._assembly.Unheld))
        for widget in (form.levels, form.smoothness, form.meshes):
            widget.setEnabled(self._has_meshes())
        form.levels.setValue(self._assembly.Levels)
        form.smoothness.setValue(self._assembly.Smoothness)
        try:
            if not finishing().is_due(self._assembly):
                self._steps = api.propagation(self._assembly)
            is_late = finishing().is_due(self._assembly)
            text = translate("SheetMorph_panels", "The parts follow in the background…")
            say(form.message, text if is_late else "")
        except actions.FAULTS as error:
            self._steps = []
            say_error(form.message, error)
        chosen = self._chosen_name
        propagation_tree.fill(form.tree, self._assembly, self._steps)
        form.tree.setCurrentItem(propagation_tree.row_of(form.tree, chosen) if chosen else None)
        self._is_filling = False
        opened = propagation_tree.opened(self._assembly) if self._steps else []
        say(form.hint, self._hint(opened), bool(opened))
        self._choose()

    def _fill_when_done(self, assembly) -> None:
        """Show the morph after its parts have followed a change."""
        if assembly == self._assembly:
            self._fill()

    def _has_meshes(self) -> bool:
        """Return whether control meshes and modes have any effect."""
        return self._assembly.Propagation != WHOLE

    def _hint(self, opened: list) -> str:
        """Return a hint about the next action, empty without one."""
        if not self._steps:
            return (
                ""
                if self.form.message.text()
                else translate("SheetMorph_panels", "Mark a fixed region and a handle first.")
            )
        hints = [contact.Warning for contact in opened[:1]]
        if any(step.level < 0 for step in self._steps):
            hints.append(propagation_tree.HINT)
        return listed(hints)

    def _choose(self) -> None:
        """Show the details of the chosen row."""
        if self._is_filling:
            return
        row = self.form.tree.currentItem()
        self._chosen_name = (row.data(0, propagation_tree.OBJECT) or "") if row else ""
        self._show_details()
        self._show_highlight()
        self._draw_meshes()
        Gui.Selection.clearSelection()
        if self._chosen is not None:
            Gui.Selection.addSelection(self._chosen)

    def _show_details(self) -> None:
        """Show the fields of a part or of a contact."""
        form, chosen = self.form, self._chosen
        kind = model.kind(chosen) if chosen else ""
        self._is_filling = True
        form.part_box.setVisible(kind == model.PART)
        form.contact_box.setVisible(kind == model.CONTACT)
        if kind == model.PART:
            form.part_box.setTitle(chosen.Label)
            is_primary = chosen == self._assembly.Primary
            form.mode.setEnabled(not is_primary and self._has_meshes())
            mode = chosen.getEnumerationsOfProperty("Mode").index(chosen.Mode)
            form.mode.setCurrentIndex(mode)
            form.mode_text.setText(translate("SheetMorph_panels", contact_types.MODE_TEXTS[mode]))
            form.primary.setEnabled(not is_primary)
        elif kind == model.CONTACT:
            form.contact_box.setTitle(chosen.Label)
            kind = contact_types.TYPES.index(chosen.Type)
            form.type.setCurrentIndex(kind)
            form.type_text.setText(translate("SheetMorph_panels", contact_types.TYPE_TEXTS[kind]))
            form.active.setChecked(chosen.Active)
        self._is_filling = False

    def _contacts(self) -> list:
        """Return the chosen contact, or the contacts that drive the chosen part."""
        if self._chosen is None:
            return []
        if model.kind(self._chosen) == model.CONTACT:
            return [self._chosen]
        return [c for step in self._steps if step.part == self._chosen for c in step.contacts]

    def _show_highlight(self) -> None:
        """Tint the parts, and colour both sides of the contacts."""
        self._highlight.clear()
        sides = [
            (part, model.contact_vertices(contact, side), colours.SIDES[side])
            for contact in self._contacts()
            for side, part in (("a", contact.PartA), ("b", contact.PartB))
            if part is not None
        ]
        tints = {part.Name: (part, colours.light(colour)) for part, _, colour in sides}
        if self._chosen is not None and model.kind(self._chosen) == model.PART:
            tints = {self._chosen.Name: (self._chosen, colours.HOVER)}
        for part, tint in tints.values():
            self._highlight.paint(part.ViewObject, seen.triangles(part), tint)
        for part, vertices, colour in sides:
            self._highlight.paint(part.ViewObject, seen.triangles(part), colour, vertices)

    def _show_meshes(self, is_shown: bool) -> None:
        """Show or hide the control meshes in the view."""
        self._remove_wires()
        if is_shown:
            self._wires = Wireframe(self.session.view)
            self._draw_meshes()

    def _remove_wires(self) -> None:
        if self._wires is not None:
            self._wires.remove()
        self._wires = None

    def _draw_meshes(self) -> None:
        """Draw the control mesh of the chosen contact, else all of them."""
        if self._wires is None or finishing().is_due(self._assembly):
            return
        try:
            meshes = control_meshes.collect(
                self._assembly, lambda c: api.control_mesh(self._assembly, c), self._contacts()
            )
        except actions.FAULTS as error:
            meshes = []
            say_error(self.form.message, error)
        self._wires.show(meshes)

    # -- the widgets

    def _prepare_widgets(self) -> None:
        form = self.form
        contact_types.fill(form.type, contact_types.TYPE_NAMES, contact_types.TYPE_TEXTS)
        contact_types.fill(form.mode, contact_types.MODE_NAMES, contact_types.MODE_TEXTS)
        connect(form.kind, "currentIndexChanged(int)", self._change_propagation)
        connect(form.levels, "valueChanged(int)", self._change_propagation)
        connect(form.smoothness, "valueChanged(double)", self._change_propagation)
        connect(form.unheld, "activated(int)", self._change_unheld)
        connect(form.tree, "itemSelectionChanged()", self._choose)
        connect(form.mode, "activated(int)", self._change_mode)
        connect(form.primary, "clicked()", self._make_primary)
        connect(form.type, "activated(int)", self._change_type)
        connect(form.active, "clicked(bool)", self._change_active)
        connect(form.meshes, "toggled(bool)", self._show_meshes)

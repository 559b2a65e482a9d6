# SPDX-License-Identifier: LGPL-2.1-or-later
"""The panel that marks a contact between two parts."""

from freecad.sheetmorph import actions, api
from freecad.sheetmorph.bridge import seen, selecting
from freecad.sheetmorph.actions import call, name
from freecad.sheetmorph.editing.session import EditingSession
from freecad.sheetmorph.objects import model
from freecad.sheetmorph.panels import contact_types, keeping
from freecad.sheetmorph.panels.base import Panel, chip, say, vertices_said
from freecad.sheetmorph.panels.fault_bar import FaultBar
from freecad.sheetmorph.interaction.pick_mouse import PickMouse
from freecad.sheetmorph.panels.pick_tools import PickTools
from freecad.sheetmorph.qt import connect, translate
from freecad.sheetmorph.scene import colours
from freecad.sheetmorph.scene.highlight import PartLight
from freecad.sheetmorph.scene.pick_view import PickView
from freecad.sheetmorph.tools import picking
from freecad.sheetmorph.tools.contact_sides import ContactSides, reach_that_touches

WAYS = ("", "a", "b")  # of the combo box: by distance, by hand on side "a", on side "b"


def create(assembly, chosen=()):
    """Open the panel for a new contact between up to two chosen parts, and return it."""
    return ContactPanel.opened(session_on(assembly), assembly, chosen)


def edit(contact):
    """Open the panel for an existing contact, and return it.

    Raises ValueError if the contact has lost a part.
    """
    if None in (contact.PartA, contact.PartB):
        raise ValueError(f"Contact '{contact.Label}' has lost a part; delete the contact.")
    assembly = model.assembly_of(contact)
    return ContactPanel.opened(session_on(assembly, contact), assembly, (), contact)


def session_on(assembly, *needed) -> EditingSession:
    """Return a session on all parts of a morph, which ends if one of them is deleted."""
    return EditingSession(assembly.Document, [assembly, *model.parts(assembly), *needed])


class ContactPanel(Panel):
    """The panel that finds or picks the vertices of both sides; OK changes the document."""

    def __init__(self, session, assembly, chosen=(), contact=None):
        super().__init__(session, "contact", "MarkContact", "Contact")
        self._assembly, self._contact = assembly, contact
        self._parts = {part.Name: part for part in model.parts(assembly)}
        with actions.waiting():
            self._sides = ContactSides(seen.part_meshes(assembly))
        self._views = {}
        self._light = session.show(PartLight())
        session.at_end(self._remove_views)
        self._mouse = session.show(PickMouse(session.view, self))
        self._tools = PickTools(self.form, self.picked, lambda error: self._faults.say(error))
        self.notices.take(self._tools.hint)
        self._tools.offer_holes(False)
        self._tools.choose(picking.FACE)
        self._faults = FaultBar(self.form, session, assembly)
        self._prepare_widgets()
        if contact is None:
            self._begin(chosen)
        else:
            self._begin_with(contact)

    def _begin(self, chosen) -> None:
        """Start with up to two selected parts."""
        for part in chosen[:2]:
            self._sides.take(part.Name)
        self._estimate_distance()
        self._follow_parts()

    def _begin_with(self, contact) -> None:
        """Start with the values of a contact."""
        for side, part in (("a", contact.PartA), ("b", contact.PartB)):
            self._sides.put(side, part.Name, model.contact_vertices(contact, side).tolist())
            if selecting.sentence_of(contact, side) is not None:
                self._sides.pickers[side].begin_with(selecting.sentence_of(contact, side))
            getattr(self.form, f"part_{side}").setEnabled(False)
        self.form.way.setCurrentIndex(WAYS.index("a"))
        self.form.active.setChecked(contact.Active)
        self.form.type.setCurrentIndex(contact_types.TYPES.index(contact.Type))
        self._follow_parts()

    # -- the mouse in the 3D view while no side is picked by hand

    def hover(self, ray) -> None:
        """Highlight the part that a click would choose."""
        is_choosing = self._contact is None and not self._side_by_hand() and ray is not None
        part = self._sides.part_at(ray) if is_choosing else ""
        if not part or part in self._sides.parts.values():
            self._light.show()
        else:
            self._light.show(part, self._parts[part].ViewObject, self._sides.triangles(part))

    def click(self, ray) -> None:
        """Choose a part."""
        is_choosing = self._contact is None and not self._side_by_hand()
        if is_choosing and self._sides.take(self._sides.part_at(ray)):
            self._light.show()
            self._estimate_distance()
            self._follow_parts()

    def turn_wheel(self, steps: float) -> None:
        """Change the size of the brush."""
        self._tools.turn_wheel(steps)

    # -- the buttons of the task view

    def keep(self) -> bool:
        """Store the contact in one undo step; return False while a side is empty."""
        fault = self._fault()
        if fault:
            say(self.form.message, fault, True)
            return False
        try:
            keeping.keep("Mark Contact", *self._lines(), document=self._assembly.Document)
        except actions.FAULTS as error:
            self._faults.say(error)
            return False
        return True

    def _fault(self) -> str:
        """Return the reason why the contact cannot be made yet; empty if it can."""
        if not self._sides.are_chosen:
            return translate(
                "SheetMorph_panels", "Choose two parts: click on one, then on the other."
            )
        if all(self._sides.picked(side) for side in "ab"):
            return ""
        if self._side_by_hand():
            return translate(
                "SheetMorph_panels", "One side is empty: pick at least one vertex on each part."
            )
        return translate(
            "SheetMorph_panels",
            "The parts are farther apart than the gap distance: enter a larger one, "
            "or pick by hand.",
        )

    def _lines(self) -> list[str]:
        """Return the API calls that create the contact, or change its values."""
        kind, active = contact_types.TYPES[self.form.type.currentIndex()], self._is_active()
        picked = {side: self._sides.picked(side) for side in "ab"}
        if self._contact is not None:
            return self._changes(picked, kind, active)
        ends = [f"({name(self._parts[self._sides.parts[s]])}, {self._words(s)})" for s in "ab"]
        made = call("add_contact", name(self._assembly), *ends, type=repr(kind))
        return [made if active else call("set_active", made, "False")]

    def _changes(self, picked, kind: str, active: bool) -> list[str]:
        contact, lines = self._contact, []
        for side, vertices in picked.items():
            if vertices != model.contact_vertices(contact, side).tolist():
                wanted = self._words(side)
                lines.append(call("set_contact_vertices", name(contact), repr(side), wanted))
        if kind != contact.Type:
            lines.append(call("set_contact_type", name(contact), repr(kind)))
        if active != contact.Active:
            lines.append(call("set_active", name(contact), repr(active)))
        return lines

    def _words(self, side: str) -> str:
        """Return the vertices of a side as source text."""
        picker, part = self._sides.pickers[side], self._parts[self._sides.parts[side]]
        return selecting.source_for(part, [picker.said], picker.picked)

    def _remove_views(self) -> None:
        for view in self._views.values():
            view.remove()
        self._views = {}

    # -- the widgets

    def _prepare_widgets(self) -> None:
        form = self.form
        for side in "ab":
            getattr(form, f"chip_{side}").setText(chip(colours.SIDES[side]))
            combo = getattr(form, f"part_{side}")
            combo.addItem(translate("SheetMorph_panels", "Click on a part…"), "")
            for part in self._parts.values():
                combo.addItem(part.Label, part.Name)
            connect(combo, "activated(int)", lambda _index, s=side: self._choose_part(s))
        form.distance.setMinimum(0.0)
        form.distance.setValue(2.0)
        connect(form.distance, "valueChanged(double)", self._touch)
        connect(form.way, "currentIndexChanged(int)", self._choose_way)
        connect(form.type, "currentIndexChanged(int)", self._explain)
        contact_types.fill(form.type, contact_types.TYPE_NAMES, contact_types.TYPE_TEXTS)

    def _explain(self, index: int) -> None:
        self.form.type_text.setText(translate("SheetMorph_panels", contact_types.TYPE_TEXTS[index]))

    def _is_active(self) -> bool:
        return self.form.active.isChecked()

    def _side_by_hand(self) -> str:
        """Return the side that is picked by hand, or an empty string."""
        return WAYS[self.form.way.currentIndex()]

    def _choose_part(self, side: str) -> None:
        """Handle the choice of a part in a list."""
        self._sides.put(side, getattr(self.form, f"part_{side}").currentData())
        self._estimate_distance()
        self._follow_parts()

    def _estimate_distance(self) -> None:
        """Set a distance at which the parts touch, 2 mm if that is enough."""
        if self._sides.are_chosen:
            with actions.waiting():
                reach = reach_that_touches(self._touching, self._sides.size())
            self.form.distance.setValue(reach)

    def _touching(self, distance: float) -> tuple:
        first, second = (self._parts[self._sides.parts[side]] for side in "ab")
        return api.touching_vertices(first, second, distance)

    def _touch(self, *_) -> None:
        """Pick the vertices within the gap distance, unless they are picked by hand."""
        if self._sides.are_chosen and not self._side_by_hand():
            with actions.waiting():
                self._sides.pick(*self._touching(self.form.distance.value()))
        self.picked()

    def _choose_way(self, *_) -> None:
        self._light.show()
        self._follow_parts()

    def _follow_parts(self) -> None:
        """Show both parts in the lists, and the colour of each side in the view."""
        self._remove_views()
        for side, part in self._sides.parts.items():
            combo = getattr(self.form, f"part_{side}")
            combo.setCurrentIndex(combo.findData(part))
            if part:
                view, mesh = self._parts[part].ViewObject, self._sides.mesh(side)
                self._views[side] = PickView(view, mesh, colours.SIDES[side], on_top=True)
        by_hand = self._side_by_hand()
        picker = self._sides.pickers[by_hand] if by_hand else None
        self._tools.use(picker, self._parts.get(self._sides.parts.get(by_hand)))
        self._mouse.use(picker, self._views.get(by_hand))
        self.form.pick.setVisible(bool(by_hand))
        self.form.distance.setVisible(not by_hand)
        self._touch()

    def picked(self) -> None:
        """Show the picked vertices."""
        for side in "ab":
            picked = self._sides.picked(side)
            text = vertices_said(len(picked)) if picked else ""
            getattr(self.form, f"count_{side}").setText(text)
            if side in self._views:
                self._views[side].show_picked(picked)
                self._views[side].show_aimed(())
        self._tools.show_state()
        fault = self._fault()
        self._faults.say("")
        say(self.form.message, fault, self._sides.are_chosen and bool(fault))

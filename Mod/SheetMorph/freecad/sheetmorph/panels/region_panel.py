# SPDX-License-Identifier: LGPL-2.1-or-later
"""The panel that picks a region."""

from freecad.sheetmorph import actions
from freecad.sheetmorph.bridge import seen, selecting
from freecad.sheetmorph.actions import call, name
from freecad.sheetmorph.editing.session import EditingSession
from freecad.sheetmorph.objects import model
from freecad.sheetmorph.panels import keeping
from freecad.sheetmorph.panels.base import Panel, legend, say, vertices_said
from freecad.sheetmorph.panels.fault_bar import FaultBar
from freecad.sheetmorph.interaction.pick_mouse import PickMouse
from freecad.sheetmorph.panels.pick_tools import PickTools
from freecad.sheetmorph.qt import translate
from freecad.sheetmorph.scene import colours
from freecad.sheetmorph.scene.highlight import PartLight
from freecad.sheetmorph.scene.legend import ViewLegend
from freecad.sheetmorph.scene.pick_view import PickView
from freecad.sheetmorph.scene.wireframe import Wireframe
from freecad.sheetmorph.tools import picking
from freecad.sheetmorph.tools.marked import QT_TRANSLATE_NOOP
from freecad.sheetmorph.tools.part_mesh import nearest_part
from freecad.sheetmorph.tools.sentences import operands

TITLES = {
    "fixed": QT_TRANSLATE_NOOP("SheetMorph_region", "Fixed Region"),
    "handle": QT_TRANSLATE_NOOP("SheetMorph_region", "Handle"),
    "form feature": QT_TRANSLATE_NOOP("SheetMorph_region", "Form Features"),
    "follower": QT_TRANSLATE_NOOP("SheetMorph_region", "Follower"),
}
ICONS = {"fixed": "MarkFixed", "handle": "MarkHandle", "form feature": "MarkFeature"}
ICONS |= {"follower": "MarkFollower"}
FUNCTIONS = {"fixed": "add_fixed", "handle": "add_handle", "form feature": "add_feature"}
FUNCTIONS |= {"follower": "add_follower"}


def create(part, role: str):
    """Open the panel for a new region, or new form features, of a part; return it."""
    return RegionPanel.opened(session_on(part), part, role)


def edit(region):
    """Open the panel for an existing region, and return it."""
    if region.Part is None:
        raise ValueError(f"Region '{region.Label}' has lost its part; delete the region.")
    return RegionPanel.opened(session_on(region.Part, region), region.Part, region.Role, region)


def session_on(part, *needed) -> EditingSession:
    """Return a session on all parts of a morph, which ends if one of them is deleted."""
    assembly = model.assembly_of(part)
    return EditingSession(part.Document, [assembly, *model.parts(assembly), *needed])


def taken_from(part, role: str, region=None) -> dict:
    """Return the vertices by label that a region of a role must leave to others.

    Two handles cannot move one vertex, and a fixed vertex cannot move.
    """
    others = {"handle": ("handle", "fixed"), "fixed": ("handle",)}.get(role, ())
    found = [r for r in model.regions(model.assembly_of(part), part) if r != region]
    return {r.Label: model.vertices(r) for r in found if r.Role in others}


class RegionPanel(Panel):
    """The panel that picks vertices of one part; OK changes the document."""

    def __init__(self, session, part, role: str, region=None):
        super().__init__(session, "region", ICONS[role], TITLES[role])
        self._part, self._role, self._region = part, role, region
        with actions.waiting():
            self._meshes = seen.visible_meshes(model.assembly_of(part), part)
        self._picker = self._view = None
        self._light = session.show(PartLight())
        session.show(ViewLegend(session.view)).show_roles(legend(role))
        self._spaces = session.show(Wireframe(session.view))
        session.at_end(self._remove_view)
        self._mouse = session.show(PickMouse(session.view, self))
        self._tools = PickTools(self.form, self.picked, lambda error: self._faults.say(error))
        self._tools.choose(picking.RIM if role == "form feature" else picking.FACE)
        self._faults = FaultBar(self.form, session, model.assembly_of(part))
        self._prepare_widgets()
        self._begin(part, model.vertices(region) if region else ())

    def _begin(self, part, vertices=()) -> None:
        """Pick on a part from now on."""
        self._remove_view()
        self._part = part
        mesh = self._meshes[part.Name]
        others = [other for name, other in self._meshes.items() if name != part.Name]
        options = picking.Options(holes_only=self._role == "form feature")
        with actions.waiting():
            mesh.prepare()
        self._picker = picking.RegionPicker(mesh, vertices, options, others)
        if self._region is not None and selecting.sentence_of(self._region) is not None:
            self._picker.begin_with(selecting.sentence_of(self._region))
        self._picker.leave(picking.Taken(taken_from(part, self._role, self._region)))
        self._view = PickView(part.ViewObject, mesh, colours.ROLES[self._role])
        self._tools.use(self._picker, part)
        self._mouse.use(self._picker, self._view)
        self.form.part.setText(
            translate("SheetMorph_region", "On {0}").format(f"<b>{part.Label}</b>")
        )
        self.picked()

    # -- the mouse outside the picked part

    def hover(self, ray) -> None:
        """Highlight another part to which a click would change."""
        other = self._other_part(ray)
        if other is None:
            self._light.show()
        else:
            self._light.show(other.Name, other.ViewObject, self._meshes[other.Name].triangles)

    def click(self, ray) -> None:
        """Change to another part as long as nothing is picked."""
        other = self._other_part(ray)
        if other is not None:
            self._light.show()
            self._begin(other)

    def turn_wheel(self, steps: float) -> None:
        """Change the size of the brush."""
        self._tools.turn_wheel(steps)

    def picked(self) -> None:
        """Show the picked vertices."""
        picked = self._picker.picked
        self._view.show_picked(picked)
        self._view.show_aimed(())
        self._tools.show_state()
        pieces = len(self._picker.groups()) if len(picked) else 0
        text = translate("SheetMorph_region", "Nothing picked yet")
        if pieces == 1:
            text = translate("SheetMorph_region", "Picked: {0}, 1 piece")
        elif pieces:
            text = translate("SheetMorph_region", "Picked: {0}, {1} pieces")
        self.form.count.setText(text.format(vertices_said(len(picked)), pieces))
        self._faults.say("")
        self._spaces.show(selecting.spaces_of(self._part, self._tools.where))
        refused = ", ".join(f"'{label}'" for label in self._picker.refused)
        text = translate("SheetMorph_region", "Skipped vertices that already belong to {0}.")
        say(self.form.message, text.format(refused) if refused else "", bool(refused))

    def _other_part(self, ray):
        """Return the front part under a ray, if picking may change to it."""
        if ray is None or self._region is not None or len(self._picker.picked):
            return None
        found = nearest_part(self._meshes, ray)
        is_other = found not in ("", self._part.Name)
        return self._part.Document.getObject(found) if is_other else None

    # -- the buttons of the task view

    def keep(self) -> bool:
        """Store the regions in one undo step; return False if nothing is picked."""
        if not len(self._picker.picked):
            text = translate("SheetMorph_region", "Nothing is picked: click on the part first.")
            say(self.form.message, text, True)
            return False
        try:
            keeping.keep(f"Mark {TITLES[self._role]}", *self._lines(), document=self._part.Document)
        except actions.FAULTS as error:
            self._faults.say(error)
            return False
        return True

    def _lines(self) -> list[str]:
        """Return the API calls that create or change the regions."""
        if self._region is not None:
            return [call("set_vertices", name(self._region), self._words(self._picker.picked))]
        groups = [self._picker.picked]
        if self._role == "form feature" and self.form.separate.isChecked():
            groups = self._picker.groups()
        owner, part = name(model.assembly_of(self._part)), name(self._part)
        function = FUNCTIONS[self._role]
        return [call(function, owner, part, self._words(group)) for group in groups]

    def _words(self, group) -> str:
        """Return vertices as source text: as a selector of the picks, else as ids."""
        said = self._picker.said
        if len(group) == len(self._picker.picked):
            wanted = [said]
        else:
            wanted = operands(said)
        return selecting.source_for(self._part, wanted, group)

    def _remove_view(self) -> None:
        if self._view is not None:
            self._view.remove()

    # -- the widgets

    def _prepare_widgets(self) -> None:
        form = self.form
        is_new_feature = self._role == "form feature" and self._region is None
        form.separate.setVisible(is_new_feature)
        self._tools.offer_holes(is_new_feature)
        form.legend.setText(legend(self._role))

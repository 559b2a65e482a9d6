# SPDX-License-Identifier: LGPL-2.1-or-later
"""The panel in which a region is picked."""

import FreeCADGui as Gui

from freecad.sheetmorph import actions, seen
from freecad.sheetmorph.actions import call, name
from freecad.sheetmorph.objects import model
from freecad.sheetmorph.panels.base import Panel, legend, say
from freecad.sheetmorph.panels.pick_tools import PickTools
from freecad.sheetmorph.scene import colours
from freecad.sheetmorph.scene.pick_view import PickView
from freecad.sheetmorph.scene.viewport import Viewport
from freecad.sheetmorph.tools import picking
from freecad.sheetmorph.tools.part_mesh import Ray

TITLES = {"fixed": "Fixed Region", "handle": "Handle", "form feature": "Form Features"}
TITLES |= {"follower": "Follower"}
ICONS = {"fixed": "MarkFixed", "handle": "MarkHandle", "form feature": "MarkFeature"}
ICONS |= {"follower": "MarkFollower"}
FUNCTIONS = {"fixed": "add_fixed", "handle": "add_handle", "form feature": "add_feature"}
FUNCTIONS |= {"follower": "add_follower"}


def create(part, role: str):
    """Opens the panel for a new region, or new form features, of a part; returns the panel."""
    panel = RegionPanel(part, role)
    panel.present()
    return panel


def edit(region):
    """Opens the panel for a region that exists; returns the panel."""
    panel = RegionPanel(region.Part, region.Role, region)
    panel.present()
    return panel


class RegionPanel(Panel):
    """Picks vertices of one part; the document changes when the user says OK."""

    def __init__(self, part, role: str, region=None):
        super().__init__("region", ICONS[role], TITLES[role])
        self._part, self._role, self._region = part, role, region
        mesh = seen.part_mesh(part)
        picked = model.vertices(region).tolist() if region else []
        options = picking.Options(holes_only=role == "form feature")
        self._picker = picking.RegionPicker(mesh, picked, options)
        self._view = PickView(part.ViewObject, mesh.triangles, colours.ROLES[role])
        self._viewport = Viewport(Gui.activeDocument().activeView(), self)
        self._prepare_widgets()
        self._tools = PickTools(self.form, self._picker, self._refresh)
        self._tools.choose(picking.RIM if role == "form feature" else picking.FACE)
        self._refresh()

    # -- the mouse in the 3D view

    def on_move(self, pointer) -> None:
        """Highlights what a click would take."""
        aimed = () if pointer is None else self._picker.aim(Ray(pointer.origin, pointer.direction))
        self._view.show_aimed(aimed)

    def on_click(self, pointer) -> None:
        """Picks."""
        mode = picking.mode_of(pointer.shift, pointer.control)
        self._picker.click(Ray(pointer.origin, pointer.direction), mode)
        self._refresh()

    def on_escape(self) -> None:
        """Escape in the view is Cancel."""
        self.reject()

    # -- the buttons of the task view

    def accept(self) -> bool:
        """OK: one undo step, one macro line a region; with nothing picked the panel stays."""
        if not self._picker.picked:
            say(self.form.message, "Nothing is picked: click on the part first.", True)
            return False
        try:
            actions.run(f"Mark {TITLES[self._role]}", *self._lines(), document=self._part.Document)
        except actions.FAULTS as error:
            say(self.form.message, str(error), True)
            return False
        self._release()
        return self.finish()

    def reject(self) -> bool:
        """Cancel: nothing has changed."""
        self._release()
        return self.finish()

    def _lines(self) -> list[str]:
        """The calls of the API that make what is picked."""
        if self._region is not None:
            picked = actions.vertices(sorted(self._picker.picked))
            return [call("set_vertices", name(self._region), picked)]
        groups = [sorted(self._picker.picked)]
        if self._role == "form feature" and self.form.separate.isChecked():
            groups = self._picker.groups()
        owner, part = name(model.assembly_of(self._part)), name(self._part)
        function = FUNCTIONS[self._role]
        return [call(function, owner, part, actions.vertices(group)) for group in groups]

    def _release(self) -> None:
        """Gives the mouse back and takes the drawing away."""
        self._viewport.release()
        self._tools.release()
        self._view.remove()

    # -- the widgets

    def _prepare_widgets(self) -> None:
        form = self.form
        form.part.setText(f"On <b>{self._part.Label}</b>")
        is_new_feature = self._role == "form feature" and self._region is None
        form.separate.setVisible(is_new_feature)
        form.holes.setVisible(is_new_feature)
        form.legend.setText(legend(self._role))
        say(form.message, "")

    def _refresh(self) -> None:
        """Shows what is picked."""
        picked = self._picker.picked
        self._view.show_picked(picked)
        self._view.show_aimed(())
        self._tools.show_state()
        pieces = len(self._picker.groups()) if picked else 0
        text = f"{len(picked)} vertices in {pieces} piece{'s' if pieces != 1 else ''}"
        self.form.count.setText(f"Picked: <b>{text if picked else 'nothing yet'}</b>")
        say(self.form.message, "")

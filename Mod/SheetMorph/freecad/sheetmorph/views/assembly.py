# SPDX-License-Identifier: LGPL-2.1-or-later
"""How a morph and its hidden deformation look in the tree."""

from freecad.sheetmorph.interaction.finishing import finishing
from freecad.sheetmorph.objects import model
from freecad.sheetmorph.qt import QtCore
from freecad.sheetmorph.views import menus
from freecad.sheetmorph.views.base import FollowingView, OwnerView


class AssemblyView(FollowingView, OwnerView):
    """A group; double click moves its first handle."""

    icon = "Morph"

    def attach(self, view_object) -> None:
        """What was saved before its final shape was there gets it after the opening."""
        super().attach(view_object)
        if view_object.Object.Document.Restoring:
            finishing().look_at(view_object.Object.Document)

    def doubleClicked(self, _view_object) -> bool:
        """Opens the Move Handle panel if there is a handle."""
        handles = [r for r in model.regions(self.object) if r.Role == "handle"]
        if handles:
            menus.move(handles[0])
        return bool(handles)

    def getIcon(self) -> str:
        """Another icon for a morph that cannot be computed."""
        self.icon = self._due_icon()
        return super().getIcon()

    def _due_icon(self) -> str:
        return "MorphFault" if model.failure_of(self.object) else "Morph"

    def updateData(self, obj, name: str) -> None:
        """The icons of the parts tell which one is the primary, its own whether all is well."""
        if name == "Status":  # the recompute that says so has not come to its end
            QtCore.QTimer.singleShot(0, self._change_icon)
        if name == "Primary":
            views = [part.ViewObject for part in model.parts(obj)]
            for view in filter(None, views):  # a part that is being deleted has none any more
                view.signalChangeIcon()

    def _change_icon(self) -> None:
        try:
            if self.icon != self._due_icon():  # the tree takes long with a large group
                self._view_object.signalChangeIcon()
        except (ReferenceError, RuntimeError):
            return  # deleted meanwhile

    def setupContextMenu(self, _view_object, menu) -> bool:
        """How its parts follow."""
        menus.add_assembly_actions(menu, self.object)
        return False


class DeformationView(FollowingView):
    """An object that only computes: not in the tree."""

    icon = "Morph"

    def attach(self, view_object) -> None:
        """Hides the object from the tree."""
        super().attach(view_object)
        view_object.ShowInTree = False

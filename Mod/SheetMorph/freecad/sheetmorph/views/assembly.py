# SPDX-License-Identifier: LGPL-2.1-or-later
"""The appearance of a morph and of its hidden deformation in the tree."""

from freecad.sheetmorph.interaction.finishing import finishing
from freecad.sheetmorph.objects import model
from freecad.sheetmorph.qt import QtCore
from freecad.sheetmorph.views import menus
from freecad.sheetmorph.views.base import FollowingView, OwnerView


class AssemblyView(FollowingView, OwnerView):
    """A group; a double click moves its first handle."""

    icon = "Morph"

    def attach(self, view_object) -> None:
        """Attach the view, and compute a final shape that is missing in an opened document."""
        super().attach(view_object)
        if view_object.Object.Document.Restoring:
            finishing().look_at(view_object.Object.Document)

    def doubleClicked(self, _view_object) -> bool:
        """Open the Move Handle panel if there is a handle."""
        handles = [r for r in model.regions(self.object) if r.Role == "handle"]
        if handles:
            menus.move(handles[0])
        return bool(handles)

    def getIcon(self) -> str:
        """Return the icon, another one for a morph that cannot be computed."""
        self.icon = self._due_icon()
        return super().getIcon()

    def _due_icon(self) -> str:
        return "MorphFault" if model.failure_of(self.object) else "Morph"

    def updateData(self, obj, name: str) -> None:
        """Update the icons of the primary part and of a faulty morph."""
        if name == "Status":  # the recompute that sets the status is not finished yet
            QtCore.QTimer.singleShot(0, self._change_icon)
        if name == "Primary":
            views = [part.ViewObject for part in model.parts(obj)]
            for view in filter(None, views):  # a part that is being deleted has no view
                view.signalChangeIcon()

    def _change_icon(self) -> None:
        try:
            if self.icon != self._due_icon():  # the tree is slow with a large group
                self._view_object.signalChangeIcon()
        except (ReferenceError, RuntimeError):
            return  # deleted meanwhile

    def setupContextMenu(self, _view_object, menu) -> bool:
        """Add the entries of a morph."""
        menus.add_assembly_actions(menu, self.object)
        return False


class DeformationView(FollowingView):
    """The view of an object that only computes, hidden in the tree."""

    icon = "Morph"

    def attach(self, view_object) -> None:
        """Hide the object in the tree."""
        super().attach(view_object)
        view_object.ShowInTree = False

# SPDX-License-Identifier: LGPL-2.1-or-later
"""The appearance of a morph and of its hidden deformation in the tree."""

from freecad.sheetmorph.interaction.finishing import finishing
from freecad.sheetmorph.kinds import PART, kind
from freecad.sheetmorph.objects import model
from freecad.sheetmorph.qt import QtCore
from freecad.sheetmorph.views import menus
from freecad.sheetmorph.views.base import FollowingView, OwnerView
from freecad.sheetmorph.views.part import parts_of


class AssemblyView(FollowingView, OwnerView):
    """A group; a double click moves its first handle."""

    icon = "Morph"
    _is_due = False

    def attach(self, view_object) -> None:
        """Attach the view, and compute a final shape that is missing in an opened document."""
        super().attach(view_object)
        if view_object.Object.Document.Restoring:
            finishing().look_at(view_object.Object.Document)

    @property
    def opened_by(self) -> str:
        """The command that moves the first handle, empty without any."""
        is_movable = any(region.Role == "handle" for region in model.regions(self.object))
        return "MoveHandle" if is_movable else ""

    def getIcon(self) -> str:
        """Return the icon, another one for a morph that cannot be computed."""
        self.icon = self._due_icon()
        return super().getIcon()

    def _due_icon(self) -> str:
        return "MorphFault" if model.failure_of(self.object) else "Morph"

    def updateData(self, obj, name: str) -> None:
        """Update the icons of the primary part and of a faulty morph, and the rows of parts."""
        if name == "Group" and not (self._is_due or obj.Document.Restoring):
            self._is_due = True
            QtCore.QTimer.singleShot(0, self._show_members)
        if name == "Status":  # the recompute that sets the status is not finished yet
            QtCore.QTimer.singleShot(0, self._change_icon)
        if name == "Primary":
            views = [part.ViewObject for part in model.parts(obj)]
            for view in filter(None, views):  # a part that is being deleted has no view
                view.signalChangeIcon()

    def _show_members(self) -> None:
        """Let the tree ask the parts for their children, which are links from others to them.

        FreeCAD asks a touched object. A part that waits for a recompute stays touched.
        """
        self._is_due = False
        try:
            for part in model.parts(self.object):
                is_due = "Touched" in part.State
                part.touch("")  # without a request to recompute it
                if not is_due:
                    part.purgeTouched()
        except (ReferenceError, RuntimeError):
            return  # deleted meanwhile

    def _change_icon(self) -> None:
        try:
            if self.icon != self._due_icon():  # the tree is slow with a large group
                self._view_object.signalChangeIcon()
        except (ReferenceError, RuntimeError):
            return  # deleted meanwhile

    def setupContextMenu(self, view_object, menu) -> bool:
        """Add an entry that shows a fault, and the commands."""
        if model.failure_of(self.object):
            menus.add_problem(menu)
        return super().setupContextMenu(view_object, menu)

    def claimChildren(self) -> list:
        """Return the members of the group, apart from those that a part of it claims."""
        group = self.object.Group
        parts = {member for member in group if kind(member) == PART}
        return [member for member in group if parts.isdisjoint(parts_of(member))]


class DeformationView(FollowingView):
    """The view of an object that only computes, hidden in the tree."""

    icon = "Morph"

    def attach(self, view_object) -> None:
        """Hide the object in the tree."""
        super().attach(view_object)
        view_object.ShowInTree = False

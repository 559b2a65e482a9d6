# SPDX-License-Identifier: LGPL-2.1-or-later
"""How a morph and its hidden deformation look in the tree."""

from freecad.sheetmorph.objects import model
from freecad.sheetmorph.views import menus
from freecad.sheetmorph.views.base import OwnerView, View


class AssemblyView(OwnerView):
    """A group; double click moves its first handle."""

    icon = "Morph"

    def doubleClicked(self, _view_object) -> bool:
        """Opens the Move Handle panel if there is a handle."""
        handles = [r for r in model.regions(self.object) if r.Role == "handle"]
        if handles:
            menus.move(handles[0])
        return bool(handles)

    def updateData(self, obj, name: str) -> None:
        """The icons of the parts tell which one is the primary."""
        if name == "Primary":
            views = [part.ViewObject for part in model.parts(obj)]
            for view in filter(None, views):  # a part that is being deleted has none any more
                view.signalChangeIcon()

    def setupContextMenu(self, _view_object, menu) -> bool:
        """How its parts follow."""
        menus.add_assembly_actions(menu, self.object)
        return False


class DeformationView(View):
    """An object that only computes: not in the tree."""

    icon = "Morph"

    def attach(self, view_object) -> None:
        """Hides the object from the tree."""
        super().attach(view_object)
        view_object.ShowInTree = False

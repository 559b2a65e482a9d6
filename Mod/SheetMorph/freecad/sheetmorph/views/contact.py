# SPDX-License-Identifier: LGPL-2.1-or-later
"""How a contact looks: hidden at first; shown, both sides have a colour each on their parts."""

from freecad.sheetmorph.objects import model
from freecad.sheetmorph.scene import colours
from freecad.sheetmorph.views import menus
from freecad.sheetmorph.views.patches import PatchView


class ContactView(PatchView):
    """A contact between two parts."""

    drawn_properties = ("PartA", "PartB", "VerticesA", "VerticesB")

    def __init__(self, view_object):
        super().__init__(view_object)
        # An assembly has dozens of them, over the regions that the user wants to see.
        view_object.Visibility = False

    def patches(self, obj) -> list:
        """Both sides."""
        sides = (("a", "PartA"), ("b", "PartB"))
        return [
            (getattr(obj, link), model.contact_vertices(obj, side), colours.SIDES[side])
            for side, link in sides
            if getattr(obj, link, None) is not None
        ]

    def getIcon(self) -> str:
        """Another icon for a contact that is not used."""
        self.icon = "MarkContact" if getattr(self.object, "Active", True) else "ContactOff"
        return super().getIcon()

    def updateData(self, obj, name: str) -> None:
        """Draws anew, and shows whether it is used."""
        super().updateData(obj, name)
        if name == "Active":
            self._view_object.signalChangeIcon()

    def doubleClicked(self, _view_object) -> bool:
        """Opens it in its panel."""
        menus.edit_contact(self.object)
        return True

    def setupContextMenu(self, _view_object, menu) -> bool:
        """What can be done with a contact."""
        menus.add_contact_actions(menu, self.object)
        return False

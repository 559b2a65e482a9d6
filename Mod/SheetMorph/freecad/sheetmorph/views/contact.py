# SPDX-License-Identifier: LGPL-2.1-or-later
"""The appearance of a contact: hidden at first; else each side has a colour on its part."""

from freecad.sheetmorph.objects import model
from freecad.sheetmorph.scene import colours
from freecad.sheetmorph.views.patches import PatchView


class ContactView(PatchView):
    """A contact between two parts."""

    drawn_properties = ("PartA", "PartB", "VerticesA", "VerticesB")
    opened_by = "EditContact"

    def __init__(self, view_object):
        super().__init__(view_object)
        # An assembly has dozens of contacts, which would cover the regions.
        view_object.Visibility = False

    def patches(self, obj) -> list:
        """Return both sides."""
        sides = (("a", "PartA"), ("b", "PartB"))
        return [
            (getattr(obj, link), model.contact_vertices(obj, side), colours.SIDES[side])
            for side, link in sides
            if getattr(obj, link, None) is not None
        ]

    def getIcon(self) -> str:
        """Return the icon, another one for an inactive contact."""
        self.icon = "MarkContact" if getattr(self.object, "Active", True) else "ContactOff"
        return super().getIcon()

    def updateData(self, obj, name: str) -> None:
        """Redraw the contact and update its icon."""
        super().updateData(obj, name)
        if name == "Active":
            self._view_object.signalChangeIcon()

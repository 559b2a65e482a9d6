# SPDX-License-Identifier: LGPL-2.1-or-later
"""The appearance of a region: its vertices in the colour of its role on the displayed part."""

from freecad.sheetmorph.objects import model
from freecad.sheetmorph.scene import colours
from freecad.sheetmorph.views.patches import PatchView

ICONS = {"fixed": "MarkFixed", "handle": "MarkHandle", "form feature": "MarkFeature"}
ICONS |= {"follower": "MarkFollower"}


class RegionView(PatchView):
    """A fixed region, handle, form feature or follower."""

    drawn_properties = ("Part", "Vertices", "Role")

    def patches(self, obj) -> list:
        """Return its vertices."""
        part = getattr(obj, "Part", None)
        if part is None:
            return []
        return [(part, model.vertices(obj), colours.ROLES[obj.Role])]

    def getIcon(self) -> str:
        """Return the icon of the role."""
        self.icon = ICONS.get(getattr(self.object, "Role", ""), "Morph")
        return super().getIcon()

    @property
    def opened_by(self) -> str:
        """The command that moves a handle, or edits any other region."""
        return "MoveHandle" if self.object.Role == "handle" else "EditRegion"

# SPDX-License-Identifier: LGPL-2.1-or-later
"""How a region looks: its vertices in the colour of its role, over the part as it is shown."""

from freecad.sheetmorph.objects import model
from freecad.sheetmorph.scene import colours
from freecad.sheetmorph.views import menus
from freecad.sheetmorph.views.patches import PatchView

ICONS = {"fixed": "MarkFixed", "handle": "MarkHandle", "form feature": "MarkFeature"}
ICONS |= {"follower": "MarkFollower"}


class RegionView(PatchView):
    """A fixed region, handle, form feature or follower."""

    drawn_properties = ("Part", "Vertices", "Role")

    def patches(self, obj) -> list:
        """Its vertices."""
        part = getattr(obj, "Part", None)
        if part is None:
            return []
        return [(part, model.vertices(obj), colours.ROLES[obj.Role])]

    def getIcon(self) -> str:
        """The icon of the role."""
        self.icon = ICONS.get(getattr(self.object, "Role", ""), "Morph")
        return super().getIcon()

    def doubleClicked(self, _view_object) -> bool:
        """A handle is moved, any other region picked anew."""
        if self.object.Role == "handle":
            menus.move(self.object)
        else:
            menus.edit(self.object)
        return True

    def setupContextMenu(self, _view_object, menu) -> bool:
        """What can be done with a region."""
        menus.add_region_actions(menu, self.object)
        return False

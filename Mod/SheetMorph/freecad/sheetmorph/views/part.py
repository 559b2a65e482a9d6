# SPDX-License-Identifier: LGPL-2.1-or-later
"""How a morphed part looks: its source beneath it in the tree, sheet-metal colour, smooth bends."""

from freecad.sheetmorph.objects import model
from freecad.sheetmorph.scene import colours
from freecad.sheetmorph.views import menus
from freecad.sheetmorph.views.base import OwnerView


class PartView(OwnerView):
    """The result mesh of one part."""

    icon = "Part"

    def __init__(self, view_object):
        super().__init__(view_object)
        view_object.ShapeColor = colours.SHEET
        view_object.CreaseAngle = 30.0
        view_object.Lighting = "Two side"

    def getIcon(self) -> str:
        """The primary has an icon of its own."""
        owner = model.assembly_of(self.object)
        is_primary = owner is not None and getattr(owner, "Primary", None) == self.object
        self.icon = "PartPrimary" if is_primary else "Part"
        return super().getIcon()

    def claimChildren(self) -> list:
        """The source mesh lies beneath the part, and what it was prepared from."""
        meshes = (getattr(self.object, name, None) for name in ("Source", "Original"))
        return [mesh for mesh in meshes if mesh is not None]

    def setupContextMenu(self, _view_object, menu) -> bool:
        """Primary and regions of this part."""
        owner = model.assembly_of(self.object)
        if owner is not None:
            menus.add_part_actions(menu, owner, self.object)
        return False

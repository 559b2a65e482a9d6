# SPDX-License-Identifier: LGPL-2.1-or-later
"""The appearance of a part: sheet-metal colour, smooth bends, its source below it in the tree."""

from freecad.sheetmorph import generations
from freecad.sheetmorph.bridge.rest import read_kept
from freecad.sheetmorph.objects import model
from freecad.sheetmorph.qt import QtCore
from freecad.sheetmorph.scene import colours
from freecad.sheetmorph.scene.element_lines import ElementLines
from freecad.sheetmorph.views import menus
from freecad.sheetmorph.views.base import OwnerView


class PartView(OwnerView):
    """The result mesh of one part."""

    icon = "Part"

    def __init__(self, view_object):
        super().__init__(view_object)
        view_object.ShapeColor = colours.SHEET
        generations.take_gloss(view_object)
        view_object.CreaseAngle = 30.0
        view_object.Lighting = "Two side"

    def attach(self, view_object) -> None:
        """Attach the view; element edges follow when all objects exist."""
        super().attach(view_object)
        self._lines = None

    def updateData(self, _obj, name: str) -> None:
        """Redraw the element edges for another mesh at rest."""
        if name == "RestData":
            QtCore.QTimer.singleShot(0, self._draw)

    def onChanged(self, view_object, name: str) -> None:
        """Hide or show the element edges with the part."""
        if name == "Visibility" and getattr(self, "_lines", None) is not None:
            self._lines.show(view_object.Visibility)

    def _draw(self) -> None:
        try:
            obj = self.object
            if obj.Document.Restoring:
                QtCore.QTimer.singleShot(20, self._draw)
                return
            faces = None if obj.Source is None else read_kept(obj).faces
        except (ReferenceError, RuntimeError):
            return  # deleted meanwhile
        if self._lines is not None:
            self._lines.remove()
        self._lines = None if faces is None else ElementLines(self._view_object, faces)

    def getIcon(self) -> str:
        """Return the icon, another one for the primary."""
        owner = model.assembly_of(self.object)
        is_primary = owner is not None and getattr(owner, "Primary", None) == self.object
        self.icon = "PartPrimary" if is_primary else "Part"
        return super().getIcon()

    def claimChildren(self) -> list:
        """Return the source mesh, the mesh it was prepared from, and the property shells."""
        meshes = (getattr(self.object, name, None) for name in ("Source", "Original"))
        shells = getattr(self.object, "Shells", None) or []
        return [*(mesh for mesh in meshes if mesh is not None), *shells]

    def setupContextMenu(self, _view_object, menu) -> bool:
        """Add the entries of a part."""
        owner = model.assembly_of(self.object)
        if owner is not None:
            menus.add_part_actions(menu, owner, self.object)
        return False

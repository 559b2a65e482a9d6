# SPDX-License-Identifier: LGPL-2.1-or-later
"""The appearance of a part: sheet-metal colour, smooth bends, its source below it in the tree."""

from freecad.sheetmorph import generations
from freecad.sheetmorph.bridge.rest import read_kept
from freecad.sheetmorph.kinds import CONTACT, REGION, kind
from freecad.sheetmorph.objects import model
from freecad.sheetmorph.qt import QtCore
from freecad.sheetmorph.scene import colours
from freecad.sheetmorph.scene.element_lines import ElementLines
from freecad.sheetmorph.views.base import OwnerView

ROLES = ("fixed", "handle", "form feature", "follower")  # the order of regions in the tree


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
        """Return regions and contacts, the source mesh, its original, and the property shells."""
        meshes = (getattr(self.object, name, None) for name in ("Source", "Original"))
        shells = getattr(self.object, "Shells", None) or []
        return [*members_of(self.object), *(mesh for mesh in meshes if mesh is not None), *shells]


def parts_of(member) -> list:
    """Return the part of a region, or the parts of a contact, which may be None."""
    links = {REGION: ("Part",), CONTACT: ("PartA", "PartB")}.get(kind(member), ())
    return [getattr(member, link, None) for link in links]


def members_of(part) -> list:
    """Return the regions of a part by role, then its contacts; a contact has two parts.

    They are searched in the group, because the part itself must not depend on them.
    """
    owner = model.assembly_of(part)
    found = [member for member in owner.Group if part in parts_of(member)] if owner else []
    return sorted(found, key=rank)


def rank(member) -> tuple[int, int]:
    """Return the place of a region or contact among those of its part: by kind, then by age."""
    role = getattr(member, "Role", "")
    return (ROLES.index(role) if role in ROLES else len(ROLES)), member.ID

# SPDX-License-Identifier: LGPL-2.1-or-later
"""What the views of regions and contacts share: coloured vertices over parts as they are shown."""

from freecad.sheetmorph.bridge.snapshots import snapshot_of
from freecad.sheetmorph.qt import QtCore
from freecad.sheetmorph.scene import nodes
from freecad.sheetmorph.scene.patch import Patch, group
from freecad.sheetmorph.views.base import FollowingView, OwnerView


class PatchView(FollowingView, OwnerView):
    """Draws what ``patches`` returns; subclasses also name the properties that decide it."""

    drawn_properties: tuple[str, ...] = ()

    def patches(self, obj) -> list:
        """What to draw: (part, vertices, colour) each."""
        return []

    def attach(self, view_object) -> None:
        """Prepares an empty drawing; what is in it follows when all objects are there."""
        super().attach(view_object)
        self._root = group()
        self._drawn = []
        self._is_filled = True
        self._is_due = False
        view_object.addDisplayMode(self._root, "Region")

    def getDisplayModes(self, _view_object) -> list[str]:
        """There is one."""
        return ["Region"]

    def getDefaultDisplayMode(self) -> str:
        """The only one."""
        return "Region"

    def setDisplayMode(self, mode: str) -> str:
        """FreeCAD asks back which one it is."""
        return mode

    def updateData(self, _obj, name: str) -> None:
        """Draws anew when it must; later, because part and mesh may not be there yet."""
        if name in self.drawn_properties and not self._is_due:
            self._is_due = True
            QtCore.QTimer.singleShot(0, self.draw)

    def draw(self) -> None:
        """Draws; an object that was deleted meanwhile is left alone."""
        self._is_due = False
        try:
            obj = self.object
            if obj.Document.Restoring:
                QtCore.QTimer.singleShot(20, self.draw)
                return
            wanted = self.patches(obj)
        except (ReferenceError, RuntimeError):
            return
        self._root.removeAllChildren()
        places = [place for place in wanted if place[0] is not None and place[0].Source is not None]
        self._drawn = [drawn_patch(*place) for place in places]
        for patch in self._drawn:
            self._root.addChild(patch.node)
        self.fill(self._is_filled)

    @property
    def is_drawn(self) -> bool:
        """Whether what is to be seen is in the scene."""
        return bool(self._drawn) and not self._is_due

    def fill(self, is_on: bool) -> None:
        """Facets in their colour, or only their outline, so that other colours are seen."""
        self._is_filled = is_on
        for patch in self._drawn:
            patch.fill(is_on)


def drawn_patch(part, vertices, colour) -> Patch:
    """The coloured vertices of a part; they follow it."""
    view = part.ViewObject
    patch = Patch(nodes.coordinates(view), colour, transform=nodes.transform(view))
    patch.show(snapshot_of(part.Source).touching(vertices), vertices)
    return patch

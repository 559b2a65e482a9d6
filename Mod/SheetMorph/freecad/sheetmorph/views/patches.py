# SPDX-License-Identifier: LGPL-2.1-or-later
"""The common base of region and contact views: coloured vertices on displayed parts."""

from freecad.sheetmorph.bridge.snapshots import snapshot_of
from freecad.sheetmorph.qt import QtCore
from freecad.sheetmorph.scene import nodes
from freecad.sheetmorph.scene.patch import Patch, group
from freecad.sheetmorph.views.base import FollowingView, OwnerView


class PatchView(FollowingView, OwnerView):
    """A view that draws the result of `patches`; subclasses name the properties behind it."""

    drawn_properties: tuple[str, ...] = ()

    def patches(self, obj) -> list:
        """Return the (part, vertices, colour) to draw."""
        return []

    def attach(self, view_object) -> None:
        """Attach an empty drawing; its content follows when all objects exist."""
        super().attach(view_object)
        self._root = group()
        self._drawn = []
        self._is_filled = True
        self._is_due = False
        view_object.addDisplayMode(self._root, "Region")

    def getDisplayModes(self, _view_object) -> list[str]:
        """Return the only mode."""
        return ["Region"]

    def getDefaultDisplayMode(self) -> str:
        """Return the only mode."""
        return "Region"

    def setDisplayMode(self, mode: str) -> str:
        """Return the mode unchanged."""
        return mode

    def updateData(self, _obj, name: str) -> None:
        """Redraw later if a relevant property changed, since part and mesh may not exist yet."""
        if name in self.drawn_properties and not self._is_due:
            self._is_due = True
            QtCore.QTimer.singleShot(0, self.draw)

    def draw(self) -> None:
        """Draw the patches unless the object was deleted meanwhile."""
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
        """Whether the scene has the present patches."""
        return bool(self._drawn) and not self._is_due

    def fill(self, is_on: bool) -> None:
        """Show coloured facets, or only their outline so that other colours are visible."""
        self._is_filled = is_on
        for patch in self._drawn:
            patch.fill(is_on)


def drawn_patch(part, vertices, colour) -> Patch:
    """Return the coloured vertices of a part, which follow it."""
    view = part.ViewObject
    patch = Patch(nodes.coordinates(view), colour, transform=nodes.transform(view))
    patch.show(snapshot_of(part.Source).touching(vertices), vertices)
    return patch

# SPDX-License-Identifier: LGPL-2.1-or-later
"""The live preview: kernel positions in place of a mesh, without a change of the document.

It is under the root of the part's view provider and uses its coordinates node. So it moves with the
part and its containers, and the coloured regions follow.
"""

from freecad.sheetmorph.scene import nodes
from freecad.sheetmorph.scene.in_place import InPlace
from freecad.sheetmorph.scene.surface import Surface


class Preview(Surface):
    """A drawing of one part at other positions until `remove`."""

    def __init__(self, view_object, drawer, points, triangles, *, also=()):
        """Draw `points` (n, 3) local mm with `triangles` (m, 3); see `drawing` for `drawer`.

        `also` are further views that represent the part.
        """
        super().__init__(nodes.coordinates(view_object))
        self._view_object = view_object
        self.fill(drawer, points, triangles)
        self.plain()
        self._in_place = InPlace(view_object, view_object.RootNode, self.node, also)

    def plain(self) -> None:
        """Show the part in its own colour."""
        transparency = self._view_object.Transparency / 100.0
        self.paint(tuple(self._view_object.ShapeColor[:3]), transparency)

    def remove(self) -> None:
        """Show the mesh of the document again; the part may be deleted already."""
        self._in_place.remove()
        try:
            self._view_object.update()
        except (ReferenceError, RuntimeError):
            return

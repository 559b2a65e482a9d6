# SPDX-License-Identifier: LGPL-2.1-or-later
"""The drawing of picked vertices, and of those that a click would pick."""

from freecad.sheetmorph.scene import colours, nodes
from freecad.sheetmorph.scene.hanging import Hanging
from freecad.sheetmorph.scene.patch import Patch


class PickView:
    """Two patches over a part until `remove`."""

    def __init__(self, view_object, mesh, colour, *, on_top=False):
        """Create the patches; `mesh` is the PartMesh, `colour` (r, g, b) that of picked vertices.

        With `on_top`, their outline is visible through other objects.
        """
        self.colour = colour
        self._mesh = mesh
        shown = nodes.coordinates(view_object)
        self._picked = Patch(shown, colour, 3.0 if on_top else 5.0, on_top=on_top)
        self._aimed = Patch(shown, colours.HOVER, 3.0)
        self._last = None
        root, patches = view_object.RootNode, (self._picked, self._aimed)
        self._hanging = [Hanging(root, patch.node) for patch in patches]

    def show_picked(self, vertices) -> None:
        """Colour the picked vertices."""
        self._picked.show(self._mesh.triangles, vertices)

    def show_aimed(self, vertices) -> None:
        """Highlight the vertices under the mouse; the same array again costs nothing."""
        if vertices is not self._last:
            self._last = vertices
            self._aimed.show(self._mesh.triangles, vertices)

    def remove(self) -> None:
        """Remove both patches."""
        for hanging in self._hanging:
            hanging.remove()

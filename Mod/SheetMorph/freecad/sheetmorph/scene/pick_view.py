# SPDX-License-Identifier: LGPL-2.1-or-later
"""What is seen while picking: the picked vertices, and what a click would take."""

from freecad.sheetmorph.scene import colours
from freecad.sheetmorph.scene.patch import Patch
from freecad.sheetmorph.scene import nodes


class PickView:
    """Two patches over a part until ``remove`` is called."""

    def __init__(self, view_object, triangles, colour, *, on_top=False):
        """``triangles`` (m, 3) of the part; ``colour``: (r, g, b) of the picked vertices.

        ``on_top``: their outline is seen through whatever hides it.
        """
        self._root = view_object.RootNode
        self._triangles = triangles
        shown = nodes.coordinates(view_object)
        self._picked = Patch(shown, colour, 3.0 if on_top else 5.0, on_top=on_top)
        self._aimed = Patch(shown, colours.HOVER, 3.0)
        for patch in (self._picked, self._aimed):
            self._root.addChild(patch.node)

    def show_picked(self, vertices) -> None:
        """Colours the picked vertices."""
        self._picked.show(self._triangles, vertices)

    def show_aimed(self, vertices) -> None:
        """Highlights what a click would take."""
        self._aimed.show(self._triangles, vertices)

    def remove(self) -> None:
        """Takes both out of the view."""
        for patch in (self._picked, self._aimed):
            if self._root.findChild(patch.node) >= 0:
                self._root.removeChild(patch.node)

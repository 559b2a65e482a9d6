# SPDX-License-Identifier: LGPL-2.1-or-later
"""A temporary colour on parts or on some of their vertices."""

import numpy as np

from freecad.sheetmorph.scene import colours, nodes
from freecad.sheetmorph.scene.hanging import Hanging
from freecad.sheetmorph.scene.patch import Patch


class Highlight:
    """Painted patches until `clear`; a later one covers an earlier one."""

    def __init__(self):
        self._painted = []

    def paint(self, view_object, triangles, colour, vertices=None) -> None:
        """Colour `vertices` (ids) of a part with `triangles` (m, 3), or tint the whole part."""
        is_tint = vertices is None
        shown, width = nodes.coordinates(view_object), 0.0 if is_tint else 3.0
        patch = Patch(shown, colour, width, on_top=not is_tint)
        patch.show(triangles, np.unique(triangles) if is_tint else vertices)
        self._painted.append(Hanging(view_object.RootNode, patch.node))

    def clear(self) -> None:
        """Remove all patches."""
        for hanging in self._painted:
            hanging.remove()
        self._painted = []

    remove = clear


class PartLight:
    """A tint on at most one part, the one under the mouse."""

    def __init__(self):
        self._highlight = Highlight()
        self._lit = ""

    def show(self, name: str = "", view_object=None, triangles=None) -> None:
        """Tint the named part, which `view_object` draws; an empty name tints none."""
        if name == self._lit:
            return
        self._lit = name
        self._highlight.clear()
        if name:
            self._highlight.paint(view_object, triangles, colours.HOVER)

    def remove(self) -> None:
        """Remove the tint."""
        self.show()

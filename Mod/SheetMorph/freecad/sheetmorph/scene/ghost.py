# SPDX-License-Identifier: LGPL-2.1-or-later
"""A part as it was, seen through, while it moves."""

from pivy import coin

from freecad.sheetmorph.scene import colours
from freecad.sheetmorph.scene.hanging import Hanging
from freecad.sheetmorph.scene.surface import Surface


class Ghost:
    """In the view of a part, at its placement, until ``remove`` is called."""

    def __init__(self, view_object, drawer, points, triangles):
        """``drawer``: see `drawing`; ``points`` (n, 3) local mm, ``triangles`` (m, 3)."""
        self._surface = Surface(coin.SoCoordinate3())
        self._surface.paint(colours.GHOST, 0.45)
        self._surface.fill(drawer, points, triangles)
        self._hanging = Hanging(view_object.RootNode, self._surface.node)

    def remove(self) -> None:
        """Takes it out of the view."""
        self._hanging.remove()

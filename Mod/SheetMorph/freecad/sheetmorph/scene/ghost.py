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
        self._hanging = Hanging(view_object.RootNode, behind(self._surface.node))

    def remove(self) -> None:
        """Takes it out of the view."""
        self._hanging.remove()


def behind(node):
    """A node a little farther from the eye: where a part has not moved, its own facets are seen
    and not, from frame to frame, now these and now those of the ghost."""
    offset = coin.SoPolygonOffset()
    offset.factor, offset.units = 2.0, 100.0
    group = coin.SoSeparator()
    group.addChild(offset)
    group.addChild(node)
    return group

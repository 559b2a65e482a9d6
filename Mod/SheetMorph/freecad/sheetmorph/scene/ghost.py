# SPDX-License-Identifier: LGPL-2.1-or-later
"""The transparent initial shape of a part during a motion."""

from pivy import coin

from freecad.sheetmorph.scene import colours
from freecad.sheetmorph.scene.hanging import Hanging
from freecad.sheetmorph.scene.surface import Surface


class Ghost:
    """A drawing in the view of a part, at its placement, until `remove`."""

    def __init__(self, view_object, drawer, points, triangles):
        """Draw `points` (n, 3) local mm with `triangles` (m, 3); see `drawing` for `drawer`."""
        self._surface = Surface(coin.SoCoordinate3())
        self._surface.paint(colours.GHOST, 0.45)
        self._surface.fill(drawer, points, triangles)
        self._hanging = Hanging(view_object.RootNode, behind(self._surface.node))

    def remove(self) -> None:
        """Remove the drawing."""
        self._hanging.remove()


def behind(node):
    """Return a group that draws a node a little farther from the eye.

    Where a part has not moved, its facets would otherwise flicker with those of the ghost.
    """
    offset = coin.SoPolygonOffset()
    offset.factor, offset.units = 2.0, 100.0
    group = coin.SoSeparator()
    group.addChild(offset)
    group.addChild(node)
    return group

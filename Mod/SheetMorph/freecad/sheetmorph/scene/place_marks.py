# SPDX-License-Identifier: LGPL-2.1-or-later
"""Points with labels on top of the parts."""

from pivy import coin

from freecad.sheetmorph.scene import nodes
from freecad.sheetmorph.scene.hanging import Hanging


class PlaceMarks:
    """Marks of a size (px) in a 3D view until `remove`, below the node `root`."""

    def __init__(self, view, name: str, colour, size: float = 6.0):
        self._coordinates = coin.SoCoordinate3()
        self._points = coin.SoPointSet()
        self._points.numPoints = 0  # by default Coin draws a point at the origin
        self._texts = coin.SoSeparator()
        self.root = coin.SoAnnotation()
        self.root.setName(name)
        for node in (*look(colour, size), self._coordinates, self._points, self._texts):
            self.root.addChild(node)
        self._hanging = Hanging(view.getSceneGraph(), self.root)

    def show(self, places) -> None:
        """Show a point and a label at every (place (3,) mm, text), reusing the nodes."""
        self._coordinates.point.setNum(len(places))
        self._points.numPoints = len(places)
        while self._texts.getNumChildren() < len(places):
            self._texts.addChild(_text())
        while self._texts.getNumChildren() > len(places):
            self._texts.removeChild(len(places))
        for k, (place, words) in enumerate(places):
            point, group = [float(c) for c in place], self._texts.getChild(k)
            self._coordinates.point.set1Value(k, *point)
            group.getChild(0).translation.setValue(*point)
            group.getChild(1).string.setValue(words)

    def remove(self) -> None:
        """Remove the marks."""
        self._hanging.remove()


def _text():
    group = coin.SoSeparator()
    group.addChild(coin.SoTranslation())
    group.addChild(coin.SoText2())
    return group


def look(colour, size: float) -> tuple:
    """Return the nodes before points of a size (px) and texts of one colour."""
    font = coin.SoFont()
    font.name = "Arial"
    font.size = 14.0
    return *nodes.unlit(colour, 2.0, size), font

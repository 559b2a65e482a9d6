# SPDX-License-Identifier: LGPL-2.1-or-later
"""Points with words beside them, over the parts."""

from pivy import coin

from freecad.sheetmorph.scene import nodes
from freecad.sheetmorph.scene.hanging import Hanging


class PlaceMarks:
    """Marks in a 3D view until ``remove`` is called; ``root``: the node that they are below."""

    def __init__(self, view, name: str, colour):
        self._coordinates = coin.SoCoordinate3()
        self._points = coin.SoPointSet()
        self._texts = coin.SoSeparator()
        self.root = coin.SoAnnotation()
        self.root.setName(name)
        for node in (*_look(colour), self._coordinates, self._points, self._texts):
            self.root.addChild(node)
        self._hanging = Hanging(view.getSceneGraph(), self.root)

    def show(self, places) -> None:
        """Shows a point at every (place (3,) mm, words)."""
        self._coordinates.point.setNum(len(places))
        self._points.numPoints = len(places)
        self._texts.removeAllChildren()
        for k, (place, words) in enumerate(places):
            point = [float(c) for c in place]
            self._coordinates.point.set1Value(k, *point)
            self._texts.addChild(_text(point, words))

    def remove(self) -> None:
        """Takes them out of the view."""
        self._hanging.remove()


def _text(place, words: str):
    group, moved, text = coin.SoSeparator(), coin.SoTranslation(), coin.SoText2()
    moved.translation.setValue(*place)
    text.string.setValue(words)
    group.addChild(moved)
    group.addChild(text)
    return group


def _look(colour):
    font = coin.SoFont()
    font.name = "Arial"
    font.size = 14.0
    return *nodes.unlit(colour, 2.0, 6.0), font

# SPDX-License-Identifier: LGPL-2.1-or-later
"""How form features moved: a line from where each was, and how far in words."""

from pivy import coin

from freecad.sheetmorph.scene import colours, nodes
from freecad.sheetmorph.scene.hanging import Hanging
from freecad.sheetmorph.tools.live_values import turn_of

NAME = "SheetMorphFeatureMarks"
LEAST = 0.005  # mm and degrees: what moved less says nothing


class FeatureMarks:
    """Marks in a 3D view, over the parts, until ``remove`` is called."""

    def __init__(self, view):
        self._coordinates = coin.SoCoordinate3()
        self._lines = coin.SoLineSet()
        self._ends = coin.SoPointSet()
        self._texts = coin.SoSeparator()
        self._root = coin.SoAnnotation()
        self._root.setName(NAME)
        for node in (*_look(), self._coordinates, self._lines, self._ends, self._texts):
            self._root.addChild(node)
        self._hanging = Hanging(view.getSceneGraph(), self._root)

    def show(self, features) -> None:
        """Shows sheetmorph.FeatureResults."""
        places = [place for f in features for place in (f.centre, f.centre + f.translation)]
        self._coordinates.point.setNum(len(places))
        self._lines.numVertices.setNum(len(features))
        for k, place in enumerate(places):
            self._coordinates.point.set1Value(k, *(float(c) for c in place))
        for k in range(len(features)):
            self._lines.numVertices.set1Value(k, 2)
        self._say([(f.centre + f.translation, described(f)) for f in features])

    def remove(self) -> None:
        """Takes them out of the view."""
        self._hanging.remove()

    def _say(self, labels) -> None:
        while self._texts.getNumChildren() < len(labels):
            self._texts.addChild(_text())
        for k, (place, words) in enumerate(labels):
            group = self._texts.getChild(k)
            group.getChild(0).translation.setValue(*(float(c) for c in place))
            group.getChild(1).string.setValue(words)


def described(feature) -> str:
    """How far a form feature moved and turned; empty if it did neither."""
    length = float((feature.translation @ feature.translation) ** 0.5)
    angle = turn_of(feature.rotation)
    return f" {length:.2f} mm, {angle:.1f}°" if max(length, angle) > LEAST else ""


def _text():
    group = coin.SoSeparator()
    group.addChild(coin.SoTranslation())
    group.addChild(coin.SoText2())
    return group


def _look():
    font = coin.SoFont()
    font.name = "Arial"
    font.size = 14.0
    return *nodes.unlit(colours.MARKS, 2.0, 6.0), font

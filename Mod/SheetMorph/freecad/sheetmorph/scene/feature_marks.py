# SPDX-License-Identifier: LGPL-2.1-or-later
"""How form features moved: a line from where each was, and how far in words."""

from pivy import coin

from freecad.sheetmorph.scene import colours
from freecad.sheetmorph.scene.place_marks import PlaceMarks
from freecad.sheetmorph.tools.live_values import turn_of

NAME = "SheetMorphFeatureMarks"
LEAST = 0.005  # mm and degrees: what moved less says nothing


class FeatureMarks:
    """Marks in a 3D view, over the parts, until ``remove`` is called."""

    def __init__(self, view):
        self._ends = PlaceMarks(view, NAME, colours.MARKS)
        self._coordinates = coin.SoCoordinate3()
        self._lines = coin.SoLineSet()
        self._ends.root.addChild(self._coordinates)
        self._ends.root.addChild(self._lines)
        self.remove = self._ends.remove

    def show(self, features) -> None:
        """Shows sheetmorph.FeatureResults."""
        places = [place for f in features for place in (f.centre, f.centre + f.translation)]
        self._coordinates.point.setNum(len(places))
        self._lines.numVertices.setNum(len(features))
        for k, place in enumerate(places):
            self._coordinates.point.set1Value(k, *(float(c) for c in place))
        for k in range(len(features)):
            self._lines.numVertices.set1Value(k, 2)
        self._ends.show([(f.centre + f.translation, described(f)) for f in features])


def described(feature) -> str:
    """How far a form feature moved and turned; empty if it did neither."""
    length = float((feature.translation @ feature.translation) ** 0.5)
    angle = turn_of(feature.rotation)
    return f" {length:.2f} mm, {angle:.1f}°" if max(length, angle) > LEAST else ""

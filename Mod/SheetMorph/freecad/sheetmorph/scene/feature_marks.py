# SPDX-License-Identifier: LGPL-2.1-or-later
"""The displacement of form features as a line and a label."""

from pivy import coin

from freecad.sheetmorph.scene import colours
from freecad.sheetmorph.scene.place_marks import PlaceMarks
from freecad.sheetmorph.tools.live_values import turn_of

NAME = "SheetMorphFeatureMarks"
LEAST = 0.005  # mm and degrees: smaller motions get no label


class FeatureMarks:
    """Marks on top of the parts in a 3D view, until `remove`."""

    def __init__(self, view):
        self._ends = PlaceMarks(view, NAME, colours.MARKS)
        self._coordinates = coin.SoCoordinate3()
        self._lines = coin.SoLineSet()
        self._ends.root.addChild(self._coordinates)
        self._ends.root.addChild(self._lines)
        self.remove = self._ends.remove

    def show(self, features) -> None:
        """Show the displacements of `sheetmorph.FeatureResults`."""
        places = [place for f in features for place in (f.centre, f.centre + f.translation)]
        self._coordinates.point.setNum(len(places))
        self._lines.numVertices.setNum(len(features))
        for k, place in enumerate(places):
            self._coordinates.point.set1Value(k, *(float(c) for c in place))
        for k in range(len(features)):
            self._lines.numVertices.set1Value(k, 2)
        self._ends.show([(f.centre + f.translation, described(f)) for f in features])


def described(feature) -> str:
    """Return displacement and rotation of a form feature as text, empty if it did not move."""
    length = float((feature.translation @ feature.translation) ** 0.5)
    angle = turn_of(feature.rotation)
    return f" {length:.2f} mm, {angle:.1f}°" if max(length, angle) > LEAST else ""

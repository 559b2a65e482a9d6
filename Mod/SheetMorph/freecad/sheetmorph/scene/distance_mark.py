# SPDX-License-Identifier: LGPL-2.1-or-later
"""A measured distance in the 3D view: two points, the line between them and its length."""

import numpy as np
from pivy import coin

from freecad.sheetmorph.scene import colours, nodes
from freecad.sheetmorph.scene.hanging import Hanging
from freecad.sheetmorph.scene.place_marks import PlaceMarks

NAME = "SheetMorphDistance"


class DistanceMark:
    """The mark on top of the parts until `remove`."""

    def __init__(self, view):
        self._ends = coin.SoCoordinate3()
        self._line = coin.SoLineSet()
        root = coin.SoAnnotation()
        for node in (*nodes.unlit(colours.MEASURE, 2.5), self._ends, self._line):
            root.addChild(node)
        self._hanging = Hanging(view.getSceneGraph(), root)
        self._marks = PlaceMarks(view, NAME, colours.MEASURE)

    def show(self, ends, text: str = "") -> None:
        """Show no, one or two ends (k, 3) mm, and a text at the middle of the line."""
        places = [(end, "") for end in ends]
        if len(ends) == 2:
            places.append((np.mean(ends, axis=0), f"  {text}"))
        self._marks.show(places)
        self._ends.point.setNum(len(ends))
        for k, end in enumerate(ends):
            self._ends.point.set1Value(k, *(float(c) for c in end))
        self._line.numVertices.setValue(len(ends) if len(ends) == 2 else 0)

    def remove(self) -> None:
        """Remove the mark."""
        self._hanging.remove()
        self._marks.remove()

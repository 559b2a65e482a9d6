# SPDX-License-Identifier: LGPL-2.1-or-later
"""A measured distance in the 3D view: two points, the line between them and its length."""

import numpy as np
from pivy import coin

from freecad.sheetmorph.scene import colours
from freecad.sheetmorph.scene.hanging import Hanging
from freecad.sheetmorph.scene.place_marks import look

NAME = "SheetMorphDistance"


class DistanceMark:
    """The mark on top of the parts until `remove`."""

    def __init__(self, view):
        self._ends, self._line = coin.SoCoordinate3(), coin.SoLineSet()
        self._points, self._place = coin.SoPointSet(), coin.SoTranslation()
        self._text = coin.SoText2()
        root = coin.SoAnnotation()
        root.setName(NAME)
        for node in (*look(colours.MEASURE, 8.0), self._ends, self._line, self._points):
            root.addChild(node)
        for node in (self._place, self._text):
            root.addChild(node)
        self.show(())
        self._hanging = Hanging(view.getSceneGraph(), root)

    def show(self, ends, text: str = "") -> None:
        """Show no, one or two ends (k, 3) mm, and a text at the middle of the line."""
        self._ends.point.setNum(len(ends))
        for k, end in enumerate(ends):
            self._ends.point.set1Value(k, *(float(c) for c in end))
        self._points.numPoints = len(ends)
        self._line.numVertices.setValue(len(ends) if len(ends) == 2 else 0)
        self._text.string.setValue(f"  {text}" if len(ends) == 2 else "")
        if len(ends):
            self._place.translation.setValue(*np.mean(ends, axis=0).tolist())

    def remove(self) -> None:
        """Remove the mark."""
        self._hanging.remove()

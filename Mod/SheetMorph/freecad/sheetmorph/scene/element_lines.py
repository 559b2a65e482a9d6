# SPDX-License-Identifier: LGPL-2.1-or-later
"""The edges of a part's elements (quads stay quads) on top of the displayed part."""

import numpy as np
from pivy import coin

from freecad.sheetmorph.scene import colours, nodes
from freecad.sheetmorph.scene.hanging import Hanging
from freecad.sheetmorph.scene.patch import NEARER
from freecad.sheetmorph.tools import wires

NAME = "SheetMorphElements"


class ElementLines:
    """Lines under a view provider until `remove`; they follow the part, also in a preview."""

    def __init__(self, view_object, faces: np.ndarray):
        """Create the lines; `faces` (e, 4) are corners, -1 in the last one of triangles."""
        self._switch = coin.SoSwitch()
        self._switch.setName(NAME)
        separator, lines, depth = (
            coin.SoSeparator(),
            coin.SoIndexedLineSet(),
            coin.SoDepthBuffer(),
        )
        depth.range.setValue(0.0, NEARER)
        nodes.set_index(lines, wires.of_faces(faces))
        look = nodes.unlit(colours.EDGES)
        for node in (*look, depth, nodes.coordinates(view_object), lines):
            separator.addChild(node)
        self._switch.addChild(separator)
        self.show(view_object.Visibility)
        self._hanging = Hanging(view_object.RootNode, self._switch)

    def show(self, is_on: bool) -> None:
        """Show or hide the lines."""
        self._switch.whichChild = coin.SO_SWITCH_ALL if is_on else coin.SO_SWITCH_NONE

    def remove(self) -> None:
        """Remove the lines."""
        self._hanging.remove()

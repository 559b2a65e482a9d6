# SPDX-License-Identifier: LGPL-2.1-or-later
"""Control meshes as wires in the 3D view, updated by every call of `show`."""

import numpy as np
from pivy import coin

from freecad.sheetmorph.scene import colours, nodes
from freecad.sheetmorph.scene.hanging import Hanging
from freecad.sheetmorph.tools import wires

NAME = "SheetMorphControlMeshes"


class Wireframe:
    """The wires of meshes, global mm, until `remove`."""

    def __init__(self, view):
        self._topology = []
        self._coordinates = coin.SoCoordinate3()
        self._lines = coin.SoIndexedLineSet()
        self._root = coin.SoSeparator()
        self._root.setName(NAME)
        for node in (*nodes.unlit(colours.WIRES), self._coordinates, self._lines):
            self._root.addChild(node)
        self._hanging = Hanging(view.getSceneGraph(), self._root)

    def show(self, meshes) -> None:
        """Show meshes, a list of vertices (m, 3) mm and triangles (t, 3); none hides the wires."""
        points = np.concatenate([np.zeros((0, 3))] + [mesh[0] for mesh in meshes])
        self._coordinates.point.setNum(len(points))
        if len(points):
            self._coordinates.point.setValues(0, len(points), points.astype(np.float32))
        topology = [mesh[1] for mesh in meshes]
        if not same(topology, self._topology):
            self._topology = topology
            self._connect(wires.of_all(meshes))

    def positions(self) -> np.ndarray:
        """Return the displayed vertices, (m, 3) mm, in single precision."""
        found = [value.getValue() for value in self._coordinates.point.getValues()]
        return np.array(found, dtype=float).reshape(-1, 3)

    def remove(self) -> None:
        """Remove the wires."""
        self._hanging.remove()

    def _connect(self, edges: np.ndarray) -> None:
        nodes.set_index(self._lines, edges)


def same(some: list, others: list) -> bool:
    """Return whether two lists of arrays are equal."""
    return len(some) == len(others) and all(map(np.array_equal, some, others))

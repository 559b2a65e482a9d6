# SPDX-License-Identifier: LGPL-2.1-or-later
"""The live preview: kernel positions drawn in place of a mesh; the document knows nothing of it.

It hangs under the root of the part's view provider and uses its coordinates node: it moves with the
part and all containers around it, and the coloured regions follow.
"""

import importlib
import math

import numpy as np
from pivy import coin

from freecad.sheetmorph import kernel
from freecad.sheetmorph.scene import nodes

CREASE = math.radians(30.0)


class Preview:
    """Draws one part at other positions until ``end`` is called."""

    def __init__(self, view_object, module, points: np.ndarray, triangles: np.ndarray):
        """``module``: sheetmorph._coin; ``points`` (n, 3) local mm, ``triangles`` (m, 3)."""
        self._view_object = view_object
        self._normals = coin.SoNormal()
        self._faces = coin.SoIndexedFaceSet()
        self._coordinates = nodes.coordinates(view_object)
        self._node = self._separator()
        self._switch = view_object.SwitchNode
        self._mode = self._switch.whichChild.getValue()
        addresses = tuple(int(n.this) for n in (self._coordinates, self._normals, self._faces))
        self._mesh = module.MeshNodes(addresses, points, triangles, CREASE)
        # Not the Visibility property: hiding the mesh is no change of the document.
        self._switch.whichChild = coin.SO_SWITCH_NONE
        view_object.RootNode.addChild(self._node)

    def show(self, points: np.ndarray) -> None:
        """Moves the drawing to (n, 3) local positions, mm, with normals of their own."""
        self._mesh.show(np.ascontiguousarray(points, dtype=float))

    def end(self) -> None:
        """Shows the mesh as the document has it."""
        root = self._view_object.RootNode
        if root.findChild(self._node) < 0:
            return
        root.removeChild(self._node)
        self._switch.whichChild = self._mode
        self._view_object.update()

    def _separator(self):
        hints = coin.SoShapeHints()
        hints.vertexOrdering = coin.SoShapeHints.COUNTERCLOCKWISE
        material = coin.SoMaterial()
        material.diffuseColor = tuple(self._view_object.ShapeColor[:3])
        material.transparency = self._view_object.Transparency / 100.0
        binding = coin.SoNormalBinding()
        binding.value = coin.SoNormalBinding.PER_VERTEX_INDEXED
        separator = coin.SoSeparator()
        for node in (hints, material, binding, self._normals, self._coordinates, self._faces):
            separator.addChild(node)
        return separator


def module():
    """The compiled module sheetmorph._coin; raises RuntimeError with what to do."""
    kernel.load()
    try:
        return importlib.import_module("sheetmorph._coin")
    except ImportError as error:
        raise RuntimeError(f"The live view cannot be loaded ({error}). {kernel.REPAIR}") from error

# SPDX-License-Identifier: LGPL-2.1-or-later
"""A part in the colours of one value per vertex, on top of the displayed part."""

import numpy as np
from pivy import coin

from freecad.sheetmorph.scene import nodes
from freecad.sheetmorph.scene.hanging import Hanging
from freecad.sheetmorph.scene.patch import NEARER

NAME = "SheetMorphValueMap"


class ValueMap:
    """The drawing in a view until `remove`; it follows the part."""

    def __init__(self, view, part, triangles: np.ndarray, colours: np.ndarray):
        """Draw `triangles` (m, 3) of the part with `colours` (n, 3), 0 to 1, of its vertices."""
        self._root = coin.SoSeparator()
        self._root.setName(NAME)
        material = coin.SoMaterial()
        material.diffuseColor.setValues(0, len(colours), colours.tolist())
        binding = coin.SoMaterialBinding()
        binding.value = coin.SoMaterialBinding.PER_VERTEX_INDEXED
        shown = part.ViewObject
        for node in (*_style(), nodes.transform(shown), nodes.coordinates(shown)):
            self._root.addChild(node)
        for node in (material, binding, _facets(triangles)):
            self._root.addChild(node)
        self._hanging = Hanging(view.getSceneGraph(), self._root)

    def remove(self) -> None:
        """Remove the map."""
        self._hanging.remove()


def _style():
    depth = coin.SoDepthBuffer()
    depth.range.setValue(0.0, NEARER)
    hints = coin.SoShapeHints()
    hints.vertexOrdering = coin.SoShapeHints.COUNTERCLOCKWISE
    hints.creaseAngle = 0.5
    normals = coin.SoNormalBinding()
    normals.value = coin.SoNormalBinding.PER_VERTEX_INDEXED
    return nodes.unpickable(), depth, hints, normals


def _facets(triangles: np.ndarray):
    facets = coin.SoIndexedFaceSet()
    nodes.set_index(facets, triangles)
    return facets

# SPDX-License-Identifier: LGPL-2.1-or-later
"""A part drawn in the colours of one value a vertex, over the part as it is shown."""

import numpy as np
from pivy import coin

from freecad.sheetmorph.scene import nodes
from freecad.sheetmorph.scene.hanging import Hanging
from freecad.sheetmorph.scene.patch import NEARER

NAME = "SheetMorphValueMap"


class ValueMap:
    """In a view until ``remove`` is called; follows the part."""

    def __init__(self, view, part, triangles: np.ndarray, colours: np.ndarray):
        """``triangles`` (m, 3) of the part; ``colours`` (n, 3), 0 to 1, of its vertices."""
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
        """Takes the map out of the view."""
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

# SPDX-License-Identifier: LGPL-2.1-or-later
"""Vertices of a part in one colour: facets between them, rims as lines, else points."""

import numpy as np
from pivy import coin

from freecad.sheetmorph.scene import drawing, nodes

# Moves depth a little nearer, so that the patch covers the surface in which it lies.
NEARER = 0.9997
BEHIND = 0.9999  # in front of the surface, behind patches with NEARER


class Patch:
    """A coloured set of vertices that follows the coordinates node of its part."""

    def __init__(self, coordinates, colour, width: float = 4.0, transform=None, *, on_top=False):
        """Create a patch from nodes of the part; `colour` is (r, g, b) 0 to 1.

        `width` is that of lines, px. A width of 0 gives a tint with thin lines, which other patches
        cover. With `on_top`, the outline is visible through other objects.
        """
        self.node = coin.SoSwitch()
        self.node.whichChild = coin.SO_SWITCH_NONE
        self._faces = coin.SoIndexedFaceSet()
        self._lines = coin.SoIndexedLineSet()
        self._points = coin.SoIndexedPointSet()
        separator = coin.SoSeparator()
        if transform is not None:
            separator.addChild(transform)
        for node in _appearance(colour, width):
            separator.addChild(node)
        flat = coin.SoLightModel()
        flat.model = coin.SoLightModel.BASE_COLOR
        self._filling = coin.SoSwitch()
        self._filling.addChild(self._faces)
        self.fill(True)
        for node in (coordinates, self._filling, flat):
            separator.addChild(node)
        outline = coin.SoAnnotation() if on_top else coin.SoGroup()
        for node in (self._lines, self._points):
            outline.addChild(node)
        separator.addChild(outline)
        self.node.addChild(separator)

    def fill(self, is_on: bool) -> None:
        """Show the facets, or only their outline."""
        self._filling.whichChild = coin.SO_SWITCH_ALL if is_on else coin.SO_SWITCH_NONE

    def show(self, triangles: np.ndarray, vertices) -> None:
        """Show `vertices` (ids) of the mesh with `triangles` (m, 3); none hides the patch.

        Triangles without any of the vertices may be left out.
        """
        drawn = self._faces, self._lines, self._points
        some = drawing.drawer().show_patch(drawn, triangles, np.asarray(vertices, np.int32))
        self.node.whichChild = coin.SO_SWITCH_ALL if some else coin.SO_SWITCH_NONE


def group():
    """Return an empty group for patches."""
    return coin.SoGroup()


def _appearance(colour, width):
    depth = coin.SoDepthBuffer()
    depth.range.setValue(0.0, NEARER if width else BEHIND)
    material = coin.SoMaterial()
    material.diffuseColor = colour
    material.specularColor = (0.1, 0.1, 0.1)
    binding = coin.SoMaterialBinding()
    binding.value = coin.SoMaterialBinding.OVERALL
    normals = coin.SoNormalBinding()
    normals.value = coin.SoNormalBinding.PER_VERTEX_INDEXED
    hints = coin.SoShapeHints()
    hints.vertexOrdering = coin.SoShapeHints.COUNTERCLOCKWISE
    hints.creaseAngle = 0.5
    draw = coin.SoDrawStyle()
    draw.pointSize = width + 2.0
    draw.lineWidth = width or 1.0
    return nodes.unpickable(), depth, material, binding, normals, hints, draw

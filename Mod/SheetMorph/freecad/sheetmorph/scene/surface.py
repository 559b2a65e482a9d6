# SPDX-License-Identifier: LGPL-2.1-or-later
"""A shaded mesh in Coin nodes that follows positions, in one colour or in those of values."""

import math

import numpy as np
from pivy import coin

from freecad.sheetmorph.scene import nodes
from freecad.sheetmorph.tools import colour_scale

CREASE = math.radians(30.0)
SHADES = 256


class Surface:
    """One mesh, with `node` for the scene."""

    def __init__(self, coordinates):
        """Create the nodes; `coordinates` is an SoCoordinate3, possibly of another shape."""
        self._coordinates = coordinates
        self._normals = coin.SoNormal()
        self._faces = coin.SoIndexedFaceSet()
        self._material = coin.SoMaterial()
        self._binding = coin.SoMaterialBinding()
        self._mesh = self._colours = None
        self.node = self._separator()

    def fill(self, drawer, points: np.ndarray, triangles: np.ndarray) -> None:
        """Set `points` (n, 3) mm and `triangles` (m, 3); see `drawing` for `drawer`."""
        drawn = self._coordinates, self._normals, self._faces
        self._mesh = drawer.mesh_nodes(drawn, points, triangles, CREASE)
        ramp = colour_scale.ramp(SHADES)
        self._colours = drawer.value_colours(self._material, ramp, colour_scale.MISSING)

    def show(self, points: np.ndarray, frame) -> None:
        """Move the mesh to global positions (n, 3), mm, with new normals."""
        self._mesh.show(points, frame.rotation, frame.base)

    def paint(self, colour, transparency: float = 0.0) -> None:
        """Show the mesh in one colour."""
        self._binding.value = coin.SoMaterialBinding.OVERALL
        self._material.diffuseColor = colour
        self._material.transparency = transparency

    def colour(self, values: np.ndarray, span) -> None:
        """Show the value of every vertex, (n,), as a colour in a span (low, high)."""
        self._colours.show(np.asarray(values, dtype=float), span)
        self._material.transparency = 0.0
        self._binding.value = coin.SoMaterialBinding.PER_VERTEX_INDEXED

    def _separator(self):
        hints = coin.SoShapeHints()
        hints.vertexOrdering = coin.SoShapeHints.COUNTERCLOCKWISE
        normals = coin.SoNormalBinding()
        normals.value = coin.SoNormalBinding.PER_VERTEX_INDEXED
        separator = coin.SoSeparator()
        look = (nodes.unpickable(), hints, self._material, self._binding, normals)
        for node in (*look, self._normals, self._coordinates, self._faces):
            separator.addChild(node)
        return separator

# SPDX-License-Identifier: LGPL-2.1-or-later
"""What the compiled module `sheetmorph._coin` does with nodes of Coin, slower and as right."""

import numpy as np

from freecad.sheetmorph.scene import nodes
from freecad.sheetmorph.tools.shading import Shading


class MeshNodes:
    """Draws one mesh through an SoCoordinate3, an SoNormal and an SoIndexedFaceSet."""

    def __init__(self, drawn, points: np.ndarray, triangles: np.ndarray, crease: float):
        """``drawn``: the three nodes; ``points`` (n, 3) mm; ``crease``: radians."""
        self._coordinates, self._normals, faces = drawn
        self._shading = Shading(points, triangles, crease)
        self.show(points)
        nodes.set_index(faces, triangles)
        nodes.set_index(faces, self._shading.of_corner, "normalIndex")

    def show(self, points: np.ndarray, rotation=None, base=None) -> None:
        """Other positions (n, 3), mm; global ones with ``rotation`` (3, 3) and ``base`` (3,)."""
        if rotation is not None:
            points = (points - base) @ rotation
        set_rows(self._coordinates.point, points)
        set_rows(self._normals.vector, self._shading.normals(points))


class ValueColours:
    """Shows one value a vertex as colours of a material that is bound PER_VERTEX_INDEXED."""

    def __init__(self, material, ramp: np.ndarray, missing):
        """``ramp`` (k, 3): colours from the low to the high end; ``missing``: of no value."""
        self._material = material
        self._colours = np.vstack([ramp, missing])

    def show(self, values: np.ndarray, span) -> None:
        """Colours (n,) values, not a number where there is none, in a span (low, high)."""
        low, high = span
        last = len(self._colours) - 2
        scale = last / (high - low) if high > low else 0.0
        is_known = np.isfinite(values)
        with np.errstate(over="ignore"):
            places = np.clip((np.where(is_known, values, low) - low) * scale, 0.0, last)
        rows = np.where(is_known, np.floor(places + 0.5).astype(int), last + 1)
        set_rows(self._material.diffuseColor, self._colours[rows])


def set_rows(field, rows: np.ndarray) -> None:
    """Writes (n, 3) values into a field of Coin with several values."""
    field.setNum(len(rows))
    if len(rows):
        field.setValues(0, len(rows), np.ascontiguousarray(rows, np.float32))

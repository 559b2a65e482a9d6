# SPDX-License-Identifier: LGPL-2.1-or-later
"""A slower replacement for the compiled module `sheetmorph._coin`, with the same results."""

import numpy as np

from freecad.sheetmorph.scene import nodes
from freecad.sheetmorph.tools.shading import Shading


class MeshNodes:
    """A mesh drawn through an SoCoordinate3, an SoNormal and an SoIndexedFaceSet."""

    def __init__(self, drawn, points: np.ndarray, triangles: np.ndarray, crease: float):
        """Fill the three nodes `drawn`; `points` (n, 3) are in mm, `crease` in radians."""
        self._coordinates, self._normals, faces = drawn
        self._shading = Shading(points, triangles, crease)
        self.show(points)
        nodes.set_index(faces, triangles)
        nodes.set_index(faces, self._shading.of_corner, "normalIndex")

    def show(self, points: np.ndarray, rotation=None, base=None) -> None:
        """Show positions (n, 3), mm; global ones need `rotation` (3, 3) and `base` (3,)."""
        if rotation is not None:
            points = (points - base) @ rotation
        set_rows(self._coordinates.point, points)
        set_rows(self._normals.vector, self._shading.normals(points))


class ValueColours:
    """Values per vertex as colours of a material that is bound PER_VERTEX_INDEXED."""

    def __init__(self, material, ramp: np.ndarray, missing):
        """Set the colours `ramp` (k, 3) from low to high, and `missing` for no value."""
        self._material = material
        self._colours = np.vstack([ramp, missing])

    def show(self, values: np.ndarray, span) -> None:
        """Colour values (n,) in a span (low, high); NaN counts as missing."""
        low, high = span
        last = len(self._colours) - 2
        scale = last / (high - low) if high > low else 0.0
        is_known = np.isfinite(values)
        with np.errstate(over="ignore"):
            places = np.clip((np.where(is_known, values, low) - low) * scale, 0.0, last)
        rows = np.where(is_known, np.floor(places + 0.5).astype(int), last + 1)
        set_rows(self._material.diffuseColor, self._colours[rows])


def show_patch(drawn, triangles: np.ndarray, vertices: np.ndarray) -> bool:
    """Draw vertices (k,) of a mesh with `triangles` (m, 3); return whether any are visible.

    `drawn` are the nodes for the facets, for the lines around them and for the other vertices.
    """
    faces, lines, points = patch_pieces(triangles, vertices)
    nodes.set_index(drawn[0], faces)
    nodes.set_index(drawn[1], lines)
    drawn[2].coordIndex.setNum(len(points))
    if len(points):
        drawn[2].coordIndex.setValues(0, len(points), [int(p) for p in points])
    return len(faces) + len(lines) + len(points) > 0


def patch_pieces(triangles: np.ndarray, vertices):
    """Return facets (f, 3), outline edges (e, 2) and isolated vertices (p,) of a set.

    A facet is drawn if all its vertices are in the set. An edge is drawn if both ends are in the
    set and at most one facet at it is drawn, so that a rim without facets is a line.
    """
    ids = np.unique(np.asarray(vertices, dtype=np.int64))
    chosen = np.zeros(1 + max(triangles.max(initial=-1), ids.max(initial=-1)), bool)
    chosen[ids] = True
    count = chosen[triangles].sum(axis=1) if len(triangles) else np.zeros(0, int)
    faces = triangles[count == 3]
    edges = _edges(triangles[count == 2], len(chosen))
    both = chosen[edges // len(chosen)] & chosen[edges % len(chosen)]
    drawn, uses = np.unique(_edges(faces, len(chosen)), return_counts=True)
    keys = np.unique(np.concatenate([drawn[uses == 1], edges[both]]))
    outline = np.stack([keys // len(chosen), keys % len(chosen)], axis=1)
    chosen[outline.ravel()] = False
    chosen[faces.ravel()] = False
    return faces, outline, ids[chosen[ids]]


def _edges(triangles: np.ndarray, count: int) -> np.ndarray:
    """Return the edges (3 m,) of triangles as numbers: smaller vertex * `count` + larger one."""
    starts = triangles.astype(np.int64)
    ends = starts[:, [1, 2, 0]]
    return (np.minimum(starts, ends) * count + np.maximum(starts, ends)).ravel()


def set_rows(field, rows: np.ndarray) -> None:
    """Write values (n, 3) into a field of Coin."""
    field.setNum(len(rows))
    if len(rows):
        field.setValues(0, len(rows), np.ascontiguousarray(rows, np.float32))

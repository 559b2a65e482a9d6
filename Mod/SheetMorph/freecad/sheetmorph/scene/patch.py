# SPDX-License-Identifier: LGPL-2.1-or-later
"""Vertices of a part drawn in one colour: facets between them, rims as lines, else points."""

import numpy as np
from pivy import coin

from freecad.sheetmorph.scene import nodes

# Maps depth a little nearer, so that what lies in the surface is drawn before it.
NEARER = 0.9997
BEHIND = 0.9999  # before the surface, behind what is NEARER


class Patch:
    """A coloured set of vertices; follows the coordinates node it is drawn with."""

    def __init__(self, coordinates, colour, width: float = 4.0, transform=None, *, on_top=False):
        """Nodes of the part; ``colour``: (r, g, b) 0..1; ``width`` of lines, px.

        Without a width it is a tint: no lines to speak of, and other patches lie over it.
        ``on_top``: its outline is seen through whatever hides it.
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
        """Facets too, or only what outlines them."""
        self._filling.whichChild = coin.SO_SWITCH_ALL if is_on else coin.SO_SWITCH_NONE

    def show(self, triangles: np.ndarray, vertices) -> None:
        """Shows ``vertices`` (ids) of the mesh with ``triangles`` (m, 3); none hides the patch.

        Triangles without any of the vertices may be left out.
        """
        faces, lines, points = pieces(triangles, vertices)
        nodes.set_index(self._faces, faces)
        nodes.set_index(self._lines, lines)
        self._points.coordIndex.setNum(len(points))
        if len(points):
            self._points.coordIndex.setValues(0, len(points), [int(p) for p in points])
        some = len(faces) + len(lines) + len(points) > 0
        self.node.whichChild = coin.SO_SWITCH_ALL if some else coin.SO_SWITCH_NONE


def group():
    """An empty group to hang patches under."""
    return coin.SoGroup()


def pieces(triangles: np.ndarray, vertices):
    """How a set of vertices is drawn: (f, 3) facets, (e, 2) edges that outline them, (p,) the rest.

    A facet is drawn if all its vertices are in the set, an edge if both are and at most one
    facet at it is drawn: so a rim without facets is a line of its own.
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
    """The edges (3m,) of triangles, each a number: smaller vertex * ``count`` + larger one."""
    starts = triangles.astype(np.int64)
    ends = starts[:, [1, 2, 0]]
    return (np.minimum(starts, ends) * count + np.maximum(starts, ends)).ravel()


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

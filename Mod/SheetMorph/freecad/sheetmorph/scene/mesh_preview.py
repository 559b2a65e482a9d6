# SPDX-License-Identifier: LGPL-2.1-or-later
"""Another mesh, facets and edges, drawn in place of a part without a change of the document."""

import numpy as np
from pivy import coin

from freecad.sheetmorph.scene import colours, nodes
from freecad.sheetmorph.scene.in_place import InPlace

NAME = "SheetMorphMeshPreview"


class MeshPreview:
    """The drawing in a view until `remove`, which hides the part."""

    def __init__(self, view, view_object, points: np.ndarray, triangles: np.ndarray):
        """Draw `points` (n, 3) global mm with `triangles` (m, 3) in place of a part.

        `view_object` is that of the part.
        """
        self._in_place = InPlace(view_object, view.getSceneGraph(), _drawn(points, triangles))

    def remove(self) -> None:
        """Show the part again."""
        self._in_place.remove()


def _drawn(points: np.ndarray, triangles: np.ndarray):
    """Return facets in the colour of a sheet and their edges as thin dark lines."""
    root = coin.SoSeparator()
    root.setName(NAME)
    coordinates = coin.SoCoordinate3()
    coordinates.point.setValues(0, len(points), points.astype(np.float32))
    root.addChild(nodes.unpickable())
    root.addChild(coordinates)
    for node in (_faces(triangles), _edges(triangles)):
        root.addChild(node)
    return root


def _faces(triangles: np.ndarray):
    group = coin.SoSeparator()
    hints = coin.SoShapeHints()
    hints.vertexOrdering = coin.SoShapeHints.COUNTERCLOCKWISE
    hints.creaseAngle = 0.5
    material = coin.SoMaterial()
    material.diffuseColor = colours.SHEET[:3]
    offset = coin.SoPolygonOffset()
    faces = coin.SoIndexedFaceSet()
    nodes.set_index(faces, triangles)
    for node in (hints, material, offset, faces):
        group.addChild(node)
    return group


def _edges(triangles: np.ndarray):
    group = coin.SoSeparator()
    edges = np.sort(np.vstack([triangles[:, [k, (k + 1) % 3]] for k in range(3)]), axis=1)
    edges = np.unique(edges, axis=0)
    lines = coin.SoIndexedLineSet()
    nodes.set_index(lines, edges)
    for node in (*nodes.unlit(colours.EDGES), lines):
        group.addChild(node)
    return group

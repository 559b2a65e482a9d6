# SPDX-License-Identifier: LGPL-2.1-or-later
"""Nodes of FreeCAD's view provider of a mesh, which all display modes share."""

import numpy as np
from pivy import coin


def coordinates(view_object):
    """Return the SoCoordinate3 with the displayed local positions."""
    return _first(view_object.RootNode, coin.SoCoordinate3)


def transform(view_object):
    """Return the SoTransform of the placement."""
    return _first(view_object.RootNode, coin.SoTransform)


def positions(view_object) -> np.ndarray:
    """Return the displayed positions, (n, 3) local mm, in single precision."""
    return rows(coordinates(view_object).point)


def rows(field) -> np.ndarray:
    """Return the values of a field of vectors or colours, (n, 3)."""
    return np.array([value.getValue() for value in field.getValues()], dtype=float).reshape(-1, 3)


def unpickable():
    """Return an SoPickStyle that the mouse ignores."""
    style = coin.SoPickStyle()
    style.style = coin.SoPickStyle.UNPICKABLE
    return style


def unlit(colour, line_width: float = 1.0, point_size: float = 1.0) -> tuple:
    """Return nodes for lines and points of one colour without light and picking."""
    flat, base, draw = coin.SoLightModel(), coin.SoBaseColor(), coin.SoDrawStyle()
    flat.model = coin.SoLightModel.BASE_COLOR
    base.rgb = colour
    draw.lineWidth, draw.pointSize = line_width, point_size
    return unpickable(), flat, base, draw


def set_index(node, faces: np.ndarray, field: str = "coordIndex") -> None:
    """Write rows (m, k) of indices into a field of a shape, each closed by -1."""
    flat = np.full((len(faces), faces.shape[1] + 1), -1, np.int32)
    flat[:, :-1] = faces
    indices = getattr(node, field)
    indices.setNum(flat.size)
    if flat.size:
        indices.setValues(0, flat.size, flat.ravel().tolist())


def _first(root, wanted):
    """Return the first node of a type below `root`, also under switches that are off."""
    search = coin.SoSearchAction()
    search.setType(wanted.getClassTypeId())
    search.setSearchingAll(True)
    search.setInterest(coin.SoSearchAction.FIRST)
    search.apply(root)
    return search.getPath().getTail()

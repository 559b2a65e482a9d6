# SPDX-License-Identifier: LGPL-2.1-or-later
"""Nodes of FreeCAD's view provider of a mesh, which all display modes share."""

import numpy as np
from pivy import coin


def coordinates(view_object):
    """The SoCoordinate3 with the local positions that are shown."""
    return _first(view_object.RootNode, coin.SoCoordinate3)


def transform(view_object):
    """The SoTransform of the placement."""
    return _first(view_object.RootNode, coin.SoTransform)


def positions(view_object) -> np.ndarray:
    """The positions that are shown: (n, 3) local mm, in single precision."""
    values = coordinates(view_object).point.getValues()
    return np.array([value.getValue() for value in values], dtype=float).reshape(-1, 3)


def _first(root, wanted):
    """The first node of a type below ``root``, also under switches that are off."""
    search = coin.SoSearchAction()
    search.setType(wanted.getClassTypeId())
    search.setSearchingAll(True)
    search.setInterest(coin.SoSearchAction.FIRST)
    search.apply(root)
    return search.getPath().getTail()

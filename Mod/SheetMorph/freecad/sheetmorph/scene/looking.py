# SPDX-License-Identifier: LGPL-2.1-or-later
"""Brings places into view."""

import numpy as np
from pivy import coin

from freecad.sheetmorph.scene.viewport import camera_node

AROUND = 1.6  # how much is seen with a place, in its sizes
LEAST = 0.02  # of what is seen now: a single vertex is no place to zoom into


def look_at(view, points: np.ndarray) -> None:
    """Lets a 3D view show places (n, 3), global mm, from where it looks now."""
    if not len(points):
        return
    camera = camera_node(view)
    low, high = points.min(axis=0), points.max(axis=0)
    middle, reach = 0.5 * (low + high), 0.5 * AROUND * (high - low).max()
    reach = max(reach, LEAST * camera.focalDistance.getValue())
    corners = [[float(c) for c in middle + sign * reach] for sign in (-1.0, 1.0)]
    width, height = view.getSize()
    box = coin.SbBox3f(coin.SbVec3f(*corners[0]), coin.SbVec3f(*corners[1]))
    camera.viewBoundingBox(box, width / max(height, 1), 1.0)

# SPDX-License-Identifier: LGPL-2.1-or-later
"""The movement of the camera to a place."""

import numpy as np
from pivy import coin

from freecad.sheetmorph.scene.viewport import camera_node

AROUND = 1.6  # visible extent, as a multiple of the place's size
LEAST = 0.02  # of the present extent: a single vertex must not fill the view


def look_at(view, points: np.ndarray) -> None:
    """Move the camera to show places (n, 3), global mm, from the present direction."""
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

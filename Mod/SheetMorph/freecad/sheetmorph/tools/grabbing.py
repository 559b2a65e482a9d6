# SPDX-License-Identifier: LGPL-2.1-or-later
"""Which vertex of which part the mouse points at."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np


@dataclass(frozen=True, eq=False)
class Grabbed:
    """A vertex of a part and where it is seen, (3,) mm, global."""

    part: str
    vertex: int
    point: np.ndarray


def grab(core, meshes: dict, ray) -> Grabbed | None:
    """The vertex next to where a ray first meets one of the meshes, None if it meets none.

    ``core``: sheetmorph._core; ``meshes``: by name of the part points (n, 3), where they are
    seen, and triangles (m, 3); ``ray``: part_mesh.Ray.
    """
    nearest, reach = None, np.inf
    for name, (points, triangles) in meshes.items():
        hit = core.first_hit(points, triangles, ray.origin, ray.direction)
        if hit is not None and hit.distance < reach:
            reach = hit.distance
            vertex = int(triangles[hit.triangle][int(np.argmax(hit.barycentric))])
            nearest = Grabbed(name, vertex, np.array(points[vertex], float))
    return nearest

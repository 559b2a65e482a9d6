# SPDX-License-Identifier: LGPL-2.1-or-later
"""The vertex of a part under the mouse."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np


@dataclass(frozen=True, eq=False)
class Grabbed:
    """A vertex of a part and its displayed position, (3,) mm, global."""

    part: str
    vertex: int
    point: np.ndarray


def grab(core, meshes: dict, ray) -> Grabbed | None:
    """Return the vertex nearest to where a ray first meets a mesh, None if it meets none.

    `core` is `sheetmorph._core`. `meshes` maps part names to displayed points (n, 3) and triangles
    (m, 3). `ray` is a `part_mesh.Ray`.
    """
    nearest, reach = None, np.inf
    for name, (points, triangles) in meshes.items():
        hit = core.first_hit(points, triangles, ray.origin, ray.direction)
        if hit is not None and hit.distance < reach:
            reach = hit.distance
            vertex = int(triangles[hit.triangle][int(np.argmax(hit.barycentric))])
            nearest = Grabbed(name, vertex, np.array(points[vertex], float))
    return nearest

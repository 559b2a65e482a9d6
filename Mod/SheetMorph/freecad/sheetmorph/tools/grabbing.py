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
    name, hit = first_hit(core, meshes, ray)
    if hit is None:
        return None
    points, triangles = meshes[name]
    vertex = int(triangles[hit.triangle][int(np.argmax(hit.barycentric))])
    return Grabbed(name, vertex, np.array(points[vertex], float))


def first_hit(core, meshes: dict, ray) -> tuple:
    """Return the name of the mesh that a ray meets first, and the kernel's hit, or ("", None)."""
    found, nearest = "", None
    for name, (points, triangles) in meshes.items():
        hit = core.first_hit(points, triangles, ray.origin, ray.direction)
        if hit is not None and (nearest is None or hit.distance < nearest.distance):
            found, nearest = name, hit
    return found, nearest

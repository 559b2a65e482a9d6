# SPDX-License-Identifier: LGPL-2.1-or-later
"""From what a user points at to vertices."""

from __future__ import annotations

from collections.abc import Iterable

import numpy as np

from freecad.sheetmorph import conversion, kernel
from freecad.sheetmorph.api.checks import indices, require_kind
from freecad.sheetmorph.objects import model
from freecad.sheetmorph.rest import read_rest


def rest_mesh(part) -> tuple[np.ndarray, np.ndarray]:
    """Return a part at rest: points (n, 3) float64, global, mm, and triangles (m, 3) int32."""
    require_kind(part, model.PART, "part")
    rest = read_rest(part)
    return rest.points, rest.triangles


def diagnose(part) -> dict:
    """Return what a part is and what is wrong with its mesh; nothing is changed.

    The keys are those of `python3 -m sheetmorph doctor`: kind, thickness, counts, findings with
    the cure each offers, and more.
    """
    points, triangles = rest_mesh(part)
    package = kernel.load()
    return package.diagnose(package.PartMesh(points, triangles))


def global_frame(part) -> tuple[np.ndarray, np.ndarray]:
    """Return rotation (3, 3) and base (3,) of a part: global = local @ rotation.T + base, mm.

    Local are the coordinates of its mesh as FreeCAD stores and draws it.
    """
    require_kind(part, model.PART, "part")
    frame = conversion.frame_of(part.Source, np.zeros(3))
    return frame.rotation, frame.base


def vertices_of_facets(part, facets: Iterable[int]) -> list[int]:
    """Return the vertices of facets (triangle indices) of a part, sorted, once each."""
    _, triangles = rest_mesh(part)
    chosen = indices(facets, len(triangles), "facet")
    return np.unique(triangles[chosen]).tolist()


def hole_rim(part, vertex: int, rings: int = 0) -> list[int]:
    """Return the vertices of the open edge that runs through `vertex`, sorted.

    `rings`: how many rings of vertices around the rim belong to it too, such as a flange.
    Raises ValueError if the vertex is on no open edge.
    """
    core, mesh = kernel_mesh(part)
    checked = indices([vertex], len(mesh.points), "vertex")
    rim = np.asarray(core.boundary_loop_at(mesh, int(checked[0])), dtype=np.int32)
    if rings > 0:
        rim = core.grow_rings(mesh, rim, int(rings))
    return np.unique(rim).tolist()


def hole_rims(part) -> list[list[int]]:
    """Return the rims of all holes of a part, each sorted.

    A hole is a closed open edge. The longest one of each connected component is its outline, if
    it goes round more than half of it: a sheet whose outline runs into others has holes alone.
    """
    core, mesh = kernel_mesh(part)
    label = np.asarray(core.components(mesh))
    points = np.asarray(mesh.points)
    loops = [np.asarray(loop) for loop in core.boundary_loops(mesh)]
    outline: dict[int, int] = {}
    for number, loop in enumerate(loops):
        component = int(label[loop[0]])
        longest = outline.get(component)
        if longest is None or length(points, loop) > length(points, loops[longest]):
            outline[component] = number
    skipped = {k for part, k in outline.items() if is_wide(points, loops[k], label == part)}
    return [np.unique(loop).tolist() for k, loop in enumerate(loops) if k not in skipped]


def is_wide(points: np.ndarray, loop: np.ndarray, component: np.ndarray) -> bool:
    """Whether a loop reaches over more than half of the vertices in `component` (n,) bool."""
    reach, whole = (float(np.linalg.norm(np.ptp(points[v], axis=0))) for v in (loop, component))
    return reach > 0.5 * whole


def length(points: np.ndarray, loop: np.ndarray) -> float:
    """Return the length, mm, of a closed loop of vertices."""
    return float(np.linalg.norm(points[loop] - points[np.roll(loop, 1)], axis=1).sum())


def kernel_mesh(part):
    """Return the compiled kernel and the rest mesh of a part in it; raises KernelError."""
    core = kernel.core()
    points, triangles = rest_mesh(part)
    return core, core.TriangleMesh(points, triangles)

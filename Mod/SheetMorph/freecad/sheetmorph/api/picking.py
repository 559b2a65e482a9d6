# SPDX-License-Identifier: LGPL-2.1-or-later
"""From items that the user points at to vertices."""

from __future__ import annotations

import math
from collections.abc import Iterable

import numpy as np

from freecad.sheetmorph.bridge import kernel, seen
from freecad.sheetmorph.bridge.snapshots import snapshot_of
from freecad.sheetmorph.api.checks import indices, number, require_kind, vertex_count
from freecad.sheetmorph.objects import model
from freecad.sheetmorph.bridge.rest import read_rest
from freecad.sheetmorph.tools.figures import Camera
from freecad.sheetmorph.tools.part_mesh import PartMesh


def rest_mesh(part) -> tuple[np.ndarray, np.ndarray]:
    """Return a part at rest: points (n, 3) float64, global, mm, and triangles (m, 3) int32."""
    require_kind(part, model.PART, "part")
    rest = read_rest(part)
    return rest.points.copy(), rest.triangles.copy()


def diagnose(part) -> dict:
    """Return the diagnosis of a part's mesh; nothing is changed.

    The keys are those of `python3 -m sheetmorph doctor`: kind, thickness, counts, findings with
    their cures, and more.
    """
    points, triangles = rest_mesh(part)
    package = kernel.load()
    return package.diagnose(package.PartMesh(points, triangles))


def global_frame(part) -> tuple[np.ndarray, np.ndarray]:
    """Return rotation (3, 3) and base (3,) of a part: global = local @ rotation.T + base, mm.

    Local coordinates are those of its mesh as FreeCAD stores and draws it.
    """
    require_kind(part, model.PART, "part")
    frame = seen.frame_of(part)
    return frame.rotation, frame.base


def vertices_of_facets(part, facets: Iterable[int]) -> list[int]:
    """Return the sorted unique vertices of facets (triangle indices) of a part."""
    _, triangles = rest_mesh(part)
    chosen = indices(facets, len(triangles), "facet")
    return np.unique(triangles[chosen]).tolist()


def face(part, facet: int, angle: float = 30.0) -> list[int]:
    """Return the sorted vertices of the face around a facet.

    The face ends at bends of at least `angle` degrees.
    """
    mesh = mesh_at_rest(part)
    chosen = indices([facet], len(mesh.triangles), "facet")
    return mesh.face(int(chosen[0]), math.radians(number(angle, "angle"))).tolist()


def piece(part, facet: int) -> list[int]:
    """Return the sorted vertices connected with a facet, often the whole part."""
    mesh = mesh_at_rest(part)
    return mesh.piece(int(indices([facet], len(mesh.triangles), "facet")[0])).tolist()


def grow(part, vertices: Iterable[int], rings: int = 1) -> list[int]:
    """Return the vertices with a number of rings of neighbours, sorted."""
    return mesh_at_rest(part).grown(checked(part, vertices), rings).tolist()


def shrink(part, vertices: Iterable[int], rings: int = 1) -> list[int]:
    """Return the vertices without a number of outermost rings, sorted.

    The region does not shrink at borders of the mesh.
    """
    return mesh_at_rest(part).shrunk(checked(part, vertices), rings).tolist()


def invert(part, vertices: Iterable[int]) -> list[int]:
    """Return the used vertices of the part that are not among the given ones, sorted."""
    return np.setdiff1d(mesh_at_rest(part).used, checked(part, vertices)).tolist()


def vertices_inside(part, outline, camera: tuple, *, through: bool = False) -> list[int]:
    """Return the sorted vertices of the displayed part inside a closed figure in the view.

    Parameters
    ----------
    part : object
        The part.
    outline : array (k, 2)
        The figure, px from the lower left corner of the view.
    camera : tuple
        Matrix (4, 4) from (x, y, z, 1), global mm, to clip coordinates of OpenGL; width and height
        of the view, px.
    through : bool
        Include vertices hidden by the part or by another part of its morph.
    """
    require_kind(part, model.PART, "part")
    to_clip, width, height = camera
    view = Camera(np.asarray(to_clip, dtype=float), float(width), float(height))
    figure = np.asarray(outline, dtype=float)
    meshes = seen.part_meshes(model.assembly_of(part))
    hiding = None if through else list(meshes.values())
    return meshes[part.Name].inside(view, figure, hiding).tolist()


def hole_rim(part, vertex: int, rings: int = 0) -> list[int]:
    """Return the sorted vertices of the open edge through `vertex`.

    `rings` is the number of rings of vertices around the rim to include, such as a flange. Raises
    ValueError if the vertex is not on an open edge.
    """
    return mesh_at_rest(part).rim_at(int(checked(part, [vertex])[0]), int(rings)).tolist()


def hole_rims(part) -> list[list[int]]:
    """Return the rims of all holes of a part, each sorted.

    A hole is a closed boundary. The longest boundary of each connected component is its outline if
    it encloses more than half of the component.
    """
    return [rim.tolist() for rim in mesh_at_rest(part).hole_rims(0)]


def checked(part, vertices: Iterable[int]) -> np.ndarray:
    """Return vertices of a part as an array of ids, or raise ValueError."""
    return indices(vertices, vertex_count(part), "vertex")


def mesh_at_rest(part) -> PartMesh:
    """Return the pickable mesh of a part at rest. Raises KernelError."""
    require_kind(part, model.PART, "part")
    rest = read_rest(part)

    def mesh() -> PartMesh:
        return PartMesh(kernel.core(), (rest.points, rest.triangles), rest.points)

    return snapshot_of(part.Source).derived(f"picking at rest {part.Name}", rest, mesh)

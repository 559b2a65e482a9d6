# SPDX-License-Identifier: LGPL-2.1-or-later
"""Parts as displayed, deformed and placed, for picking."""

import numpy as np

from freecad.sheetmorph.bridge import conversion, kernel
from freecad.sheetmorph.bridge.rest import read_rest
from freecad.sheetmorph.bridge.snapshots import snapshot_of
from freecad.sheetmorph.objects import model
from freecad.sheetmorph.tools.part_mesh import PartMesh


def frame_of(part) -> conversion.Frame:
    """Return the mapping from the coordinates of a part's mesh to global ones."""
    return conversion.frame_of(part.Source, np.zeros(3))


def mesh_of(part) -> PartMesh:
    """Return the pickable mesh of a part."""
    rest, frame, snapshot = read_rest(part), frame_of(part), snapshot_of(part)

    def mesh() -> PartMesh:
        seen = snapshot.points.astype(float) @ frame.rotation.T + frame.base
        return PartMesh(kernel.core(), (rest.points, rest.triangles), seen)

    return snapshot.derived("picking", (rest, frame.key), mesh)


def part_meshes(assembly) -> dict[str, PartMesh]:
    """Return the pickable meshes of all parts of a morph by object name."""
    return {part.Name: mesh_of(part) for part in model.parts(assembly)}


def visible_meshes(assembly, part) -> dict[str, PartMesh]:
    """Return the pickable meshes of the visible parts of a morph, and of one part in any case."""
    shown = [p for p in model.parts(assembly) if p == part or p.ViewObject.Visibility]
    return {each.Name: mesh_of(each) for each in shown}


def triangles(part):
    """Return the displayed triangles (m, 3) of a part."""
    return snapshot_of(part).triangles


def corners(part) -> np.ndarray:
    """Return the displayed positions (k, 3), global mm, of the used vertices of a part."""
    return positions([(part, np.unique(triangles(part)))])


def positions(places) -> np.ndarray:
    """Return the displayed positions (k, 3), global mm, of parts with vertices (k,)."""
    found = [np.zeros((0, 3))]
    for part, vertices in places:
        local = snapshot_of(part).points[np.asarray(vertices, dtype=int)].astype(float)
        found.append(frame_of(part).to_global(local))
    return np.concatenate(found)


def places_of(obj) -> list:
    """Return the existing parts of a region or contact with their displayed vertices (k,)."""
    if model.kind(obj) == model.REGION:
        found = [(obj.Part, model.vertices(obj))]
    else:
        sides = (("a", obj.PartA), ("b", obj.PartB))
        found = [(part, model.contact_vertices(obj, side)) for side, part in sides]
    there = [(p, v) for p, v in found if p is not None and p.Source is not None]
    return [(part, as_drawn(part, vertices)) for part, vertices in there]


def as_drawn(part, vertices: np.ndarray) -> np.ndarray:
    """Return the vertices (k,) that exist in the displayed mesh, which may be outdated."""
    return vertices[vertices < len(snapshot_of(part).points)]

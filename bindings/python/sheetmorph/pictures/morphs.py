# SPDX-License-Identifier: LGPL-2.1-or-later
"""Scenes of recipes and of their results."""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import replace

import numpy as np

from ..base.arrays import Ints
from ..base.part_mesh import PartMesh
from ..recipe.model import Model, RegionEntry
from ..recipe.pose import Moved, pose_of
from ..solving.answer import Answer
from .scene import ROLES, SHEET, SHIFT, TURN, Arrow, Scene, Sheet

_ROLE_OF = {
    "fixed": "fixed",
    "handle": "handle",
    "feature": "form feature",
    "point": "handle",
    "follower": "follower",
}
# Shifts below this share of the size get no arrow.
_SHORTEST = 0.02


def scene_of_recipe(
    model: Model, meshes: Mapping[str, PartMesh], title: str = "", pose: str = ""
) -> Scene:
    """Return a scene of a recipe: regions in the colours of their roles, arrows at moved handles.

    pose is the name of one of its poses; the default is its own pose.
    """
    regions = _regions(model, meshes)
    sheets = [sheet for name, mesh in meshes.items() for sheet in _painted(mesh, regions[name])]
    names = {role for of_part in regions.values() for role, _ in of_part}
    motions = model.poses[pose] if pose else model.pose
    arrows = _arrows(model, meshes, motions)
    legend = {role: colour for role, colour in ROLES.items() if role in names}
    for name, colour in (("shift", SHIFT), ("axis of a turn", TURN)):
        if any(arrow.colour == colour for arrow in arrows):
            legend[name] = colour
    return Scene(sheets, arrows=arrows, title=title, legend=legend)


def scene_of_answer(result: Answer, title: str = "") -> Scene:
    """Return a scene of all parts in a pose, coloured by displacement."""
    session = result.session
    sheets, largest = [], 0.0
    for name, positions in result.positions.items():
        mesh = session.meshes[name]
        moved = np.linalg.norm(np.asarray(positions) - mesh.points, axis=1)
        largest = max(largest, float(moved.max(initial=0.0)))
        sheets.append(Sheet(np.array(positions), mesh.triangles, values=moved))
    return Scene(sheets, title=title, values="moved, mm", span=(0.0, largest or 1.0))


def before_and_after(result: Answer) -> tuple[Scene, Scene]:
    """Return scenes of the recipe and of the pose, with the same view and scale."""
    session = result.session
    model = replace(session.model, pose=pose_of(result.pose))
    before = scene_of_recipe(model, session.meshes, "before")
    after = scene_of_answer(result, "after")
    return with_room(before, after), with_room(after, before)


def with_room(scene: Scene, other: Scene) -> Scene:
    """Add invisible points to a scene, so that it has room for the content of another."""
    ends = [point for arrow in other.arrows for point in (arrow.start, arrow.end)]
    places = [*(sheet.points for sheet in other.sheets), np.array(ends, float).reshape(-1, 3)]
    room = Sheet(np.concatenate(places), np.zeros((0, 3), int))
    return replace(scene, sheets=[*scene.sheets, room])


def _regions(model: Model, meshes: Mapping[str, PartMesh]) -> dict[str, list[tuple[str, Ints]]]:
    """Return role and vertices of every region, by part."""
    found: dict[str, list[tuple[str, Ints]]] = {name: [] for name in meshes}
    marked = [(_ROLE_OF[region.kind], region) for region in model.regions]
    for contact in model.contacts:
        marked += [("contact, side a", contact.a), ("contact, side b", contact.b)]
    for role, region in marked:
        if region.part in meshes:
            found[region.part].append((role, _vertices(meshes[region.part], region)))
    return found


def _painted(mesh: PartMesh, regions: list[tuple[str, Ints]]) -> list[Sheet]:
    """Return a part with each triangle in the colour of its last region.

    Lines show region edges without a triangle, such as rims.
    """
    roles = list(ROLES)
    owner = np.full(len(mesh.triangles), -1)
    lines = []
    for role, vertices in regions:
        is_in = np.zeros(len(mesh.points), dtype=bool)
        is_in[vertices] = True
        inside = is_in[mesh.triangles].all(axis=1)
        owner[inside] = roles.index(role)
        lone = _edges(mesh.triangles[~inside])
        lone = lone[is_in[lone].all(axis=1)]
        lines.append(Sheet(mesh.points, mesh.triangles[:0], ROLES[role], lines=lone))
    colours = [SHEET, *(ROLES[role] for role in roles)]
    faces = [
        Sheet(mesh.points, mesh.triangles[owner == k - 1], colour)
        for k, colour in enumerate(colours)
        if (owner == k - 1).any()
    ]
    return faces + lines


def _edges(triangles: Ints) -> Ints:
    """Return the edges (3 m, 2) of triangles (m, 3); a shared edge appears twice."""
    return triangles[:, [[0, 1], [1, 2], [2, 0]]].reshape(-1, 2)


def _vertices(mesh: PartMesh, region: RegionEntry) -> Ints:
    if region.is_point:
        found: Ints = mesh.triangles[region.on_triangle[0]]
        return found
    return mesh.find(region.vertices or [], region.is_prepared)[0]


def _arrows(
    model: Model, meshes: Mapping[str, PartMesh], motions: Mapping[str, Moved]
) -> list[Arrow]:
    """Return an arrow for the motion of every handle, and one for its rotation axis."""
    points = np.concatenate([mesh.points for mesh in meshes.values()])
    size = float(np.linalg.norm(np.ptp(points, axis=0))) or 1.0
    found = []
    for region in model.of_kind("handle"):
        motion = motions.get(region.name)
        if motion is None or region.part not in meshes:
            continue
        mesh = meshes[region.part]
        start = mesh.points[_vertices(mesh, region)].mean(axis=0)
        shift = np.asarray(motion.translation or (0.0, 0.0, 0.0))
        if np.linalg.norm(shift) >= _SHORTEST * size:
            found.append(Arrow(start.tolist(), (start + shift).tolist()))
        turn = motion.rotation
        if turn is not None and abs(turn.radians) > 1e-9:
            axis = np.asarray(turn.axis) / np.linalg.norm(turn.axis)
            pivot = np.asarray(motion.pivot or region.pivot or start)
            length = 0.12 * size * math.copysign(1.0, turn.radians)
            found.append(Arrow(pivot.tolist(), (pivot + length * axis).tolist(), TURN))
    return found

# SPDX-License-Identifier: LGPL-2.1-or-later
"""Scenes of recipes and of their results."""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import replace

import numpy as np

from ..answer import Answer
from ..part_mesh import PartMesh
from ..recipe.model import Model, Motion, RegionEntry, motions_of
from .scene import ROLES, Arrow, Colour, Scene, Sheet

_ROLE_OF = {
    "fixed": "fixed",
    "handle": "handle",
    "feature": "form feature",
    "point": "handle",
    "follower": "follower",
}
# An arrow for a handle that is told no shift, as a share of the size.
_SHORTEST = 0.02


def scene_of_recipe(
    model: Model, meshes: Mapping[str, PartMesh], title: str = "", pose: str = ""
) -> Scene:
    """What a recipe means: regions in the colours of their roles, arrows where handles go.

    pose: name of one of its poses instead of its own.
    """
    sheets = [Sheet(mesh.points, mesh.triangles) for mesh in meshes.values()]
    marked = _marked(model, meshes)
    sheets += [sheet for _, sheet in marked]
    names = dict.fromkeys(role for role, _ in marked)
    motions = model.poses[pose] if pose else model.pose
    return Scene(
        sheets,
        arrows=_arrows(model, meshes, motions),
        title=title,
        legend={role: ROLES[role] for role in ROLES if role in names},
    )


def scene_of_answer(result: Answer, title: str = "") -> Scene:
    """All parts in a pose, coloured by how far each place has moved."""
    session = result.session
    sheets, largest = [], 0.0
    for name, positions in result.positions.items():
        mesh = session.meshes[name]
        moved = np.linalg.norm(np.asarray(positions) - mesh.points, axis=1)
        largest = max(largest, float(moved.max(initial=0.0)))
        sheets.append(Sheet(np.array(positions), mesh.triangles, values=moved))
    return Scene(sheets, title=title, values="moved, mm", span=(0.0, largest or 1.0))


def before_and_after(result: Answer) -> tuple[Scene, Scene]:
    """What the recipe means, and the parts in the pose, seen from one place at one scale."""
    session = result.session
    model = replace(session.model, pose=motions_of(result.pose))
    before = scene_of_recipe(model, session.meshes, "before")
    after = scene_of_answer(result, "after")
    seen = [_corners(scene) for scene in (before, after)]
    return _with_room(before, seen[1]), _with_room(after, seen[0])


def _with_room(scene: Scene, corners: np.ndarray) -> Scene:
    """The scene with room for points (k, 3) that are not drawn."""
    return replace(scene, sheets=[*scene.sheets, Sheet(corners, np.zeros((0, 3), int))])


def _corners(scene: Scene) -> np.ndarray:
    """The points (6, 3) that reach farthest."""
    whole = np.concatenate([sheet.points for sheet in scene.sheets])
    return np.concatenate([whole[whole.argmin(axis=0)], whole[whole.argmax(axis=0)]])


def _marked(model: Model, meshes: Mapping[str, PartMesh]) -> list[tuple[str, Sheet]]:
    """Every region with its role."""
    regions = [(_ROLE_OF[region.kind], region) for region in model.regions]
    for contact in model.contacts:
        regions += [("contact, side a", contact.a), ("contact, side b", contact.b)]
    return [
        (role, _patch(meshes[region.part], region, ROLES[role]))
        for role, region in regions
        if region.part in meshes
    ]


def _patch(mesh: PartMesh, region: RegionEntry, colour: Colour) -> Sheet:
    """Triangles whose corners all belong to it, and the edges between its vertices."""
    is_in = np.zeros(len(mesh.points), dtype=bool)
    is_in[_vertices(mesh, region)] = True
    inside = is_in[mesh.triangles]
    corners = mesh.triangles
    edges = np.concatenate([corners[:, [0, 1]], corners[:, [1, 2]], corners[:, [2, 0]]])
    edges = edges[is_in[edges].all(axis=1)]
    lines = np.unique(np.sort(edges), axis=0) if len(edges) else None
    return Sheet(mesh.points, corners[inside.all(axis=1)], colour, lines=lines, is_mark=True)


def _vertices(mesh: PartMesh, region: RegionEntry) -> np.ndarray:
    if region.is_point:
        return mesh.triangles[region.triangle] if region.triangle is not None else []
    return mesh.find(region.vertices)[0]


def _arrows(
    model: Model, meshes: Mapping[str, PartMesh], motions: Mapping[str, Motion]
) -> list[Arrow]:
    """Where every handle goes; an axis where it turns."""
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
            found.append(Arrow(pivot.tolist(), (pivot + length * axis).tolist(), (0.75, 0.2, 0.6)))
    return found

# SPDX-License-Identifier: LGPL-2.1-or-later
"""Selectors for the item nearest to a point: face, rim, border, piece, CAD face, CAD edge."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import replace
from typing import TYPE_CHECKING, Any

import numpy as np

from ..base.arrays import Floats, Ints
from ..base.labels import CadFace
from ..finding.options import HOLES
from .chosen import Chosen, SelectorError
from .part_shape import CREASE, PartShape

if TYPE_CHECKING:
    from .. import _core

CREASE_ANGLE = 20.0
# Share of the part size; a match farther from its point gives a remark.
FAR = 0.02
# Smaller barycentric coordinates count as zero: the point is on an edge or a corner.
_ON_EDGE = 1e-9
# Largest area of a wall relative to the face on the other side of its rim.
_WALL = 0.3
RIMMED = (*HOLES, "round edge")
"""The kinds of features with rims."""

Told = Mapping[str, Any]


def face_at(shape: PartShape, told: Told) -> Chosen:
    """Return the face nearest to a point, up to a crease angle."""
    angle = math.radians(told.get("crease_angle", CREASE_ANGLE))
    hit = _nearest(shape, told["face_at"])
    rows = _largest(shape, (shape.near.face(t, angle) for t in _touching(shape, hit)))
    return _matched(shape, shape.of_triangles(rows), "face_at", hit.distance)


def piece_at(shape: PartShape, told: Told) -> Chosen:
    """Return the connected component nearest to a point."""
    hit = _nearest(shape, told["piece_at"])
    chosen = shape.of_triangles(np.asarray(shape.near.piece(hit.triangle)))
    return _matched(shape, chosen, "piece_at", hit.distance)


def border_at(shape: PartShape, told: Told) -> Chosen:
    """Return the border loop nearest to a point."""
    if not shape.border_loops:
        todo = "use rim_at or face_at, or check that it is an open sheet"
        raise SelectorError(f'"{shape.name}" is closed and has no border', todo, ("border_at",))
    loop, distance = nearest_loop(shape, shape.border_loops, told["border_at"])
    return _matched(shape, shape.of_vertices(loop), "border_at", distance)


def borders_longer(shape: PartShape, told: Told) -> Chosen:
    """Return all border loops longer than a length."""
    loops = [
        loop for loop in shape.border_loops if loop_length(shape, loop) > told["borders_longer"]
    ]
    vertices = np.concatenate([np.zeros(0, dtype=np.int32), *loops])
    chosen = shape.of_vertices(vertices)
    return replace(chosen, matches=[{"selector": "borders_longer", "count": len(loops)}])


def rim_at(shape: PartShape, told: Told) -> Chosen:
    """Return the rim nearest to a point, with rings around it.

    In a thin solid it includes both rims and the wall. With the option alone it is only the loop.
    """
    loops, rows = rim_loops(shape, told)
    if not loops:
        todo = "use face_at, or a box around the place"
        raise SelectorError(f'"{shape.name}" has no rim', todo, ("rim_at",))
    loop, distance = nearest_loop(shape, loops, told["rim_at"], len(rows))
    number = next(k for k, other in enumerate(loops) if other is loop)
    vertices = rim_vertices(shape, told, loop, rows[number] if number < len(rows) else None)
    rings = int(told.get("rings", 0))
    if rings:
        vertices = np.asarray(shape.near.grown(np.unique(vertices).astype(np.int32), rings))
    return _matched(shape, shape.of_vertices(vertices), "rim_at", distance)


def cad_face_at(shape: PartShape, told: Told) -> Chosen:
    """Return the CAD face nearest to a point; kind, name and number restrict the candidates."""
    face, faces = shape.labels.face, shape.labels.faces
    if face is None or not faces:
        what = f'the file of "{shape.name}" has no CAD faces'
        raise SelectorError(what, "use face_at, or a STEP, IGES or BREP file", ("cad_face_at",))
    present = np.unique(face[face >= 0]).tolist()
    allowed, remarks = _narrowed(shape, told, present)
    number, distance = _nearest_face(shape, told["cad_face_at"], allowed)
    chosen = shape.of_triangles(np.flatnonzero(face == number))
    found = _matched(shape, chosen, "cad_face_at", distance)
    match = {**found.matches[0], "number": faces[number].number, "kind": faces[number].kind}
    remarks = [*found.remarks, *remarks, *_renumbered(faces[number], told)]
    return replace(found, matches=[match], remarks=remarks)


def cad_edge_at(shape: PartShape, told: Told) -> Chosen:
    """Return the CAD edge nearest to a point: where two faces meet, or where one ends."""
    point = told["cad_edge_at"]
    if shape.labels.face is None or not shape.labels.faces:
        what = f'the file of "{shape.name}" has no CAD edges'
        raise SelectorError(what, "use rim_at, or a STEP, IGES or BREP file", ("cad_edge_at",))
    edges = shape.cad_edges
    if not edges:
        raise SelectorError(f'"{shape.name}" is one face', "use face_at", ("cad_edge_at",))
    place = np.array(point, dtype=float)
    gaps = [segments_distance(shape.points[edge.segments], place) for edge in edges]
    least = min(gaps) + shape.slack
    near = [k for k, gap in enumerate(gaps) if gap <= least]
    best = max(near, key=lambda k: (len(edges[k].segments), -k))
    found = _matched(shape, shape.of_vertices(edges[best].segments.ravel()), "cad_edge_at", least)
    numbers = [shape.labels.faces[k].number for k in edges[best].faces]
    return replace(found, matches=[{**found.matches[0], "distance": gaps[best], "faces": numbers}])


def segments_distance(segments: Floats, place: Floats) -> float:
    """Return the distance from a point to the nearest of segments (k, 2, 3), mm."""
    start, along = segments[:, 0], segments[:, 1] - segments[:, 0]
    length = np.maximum((along**2).sum(axis=1), 1e-300)
    share = np.clip(((place - start) * along).sum(axis=1) / length, 0.0, 1.0)
    return float(np.linalg.norm(start + share[:, None] * along - place, axis=1).min())


LOOKED_UP: dict[str, Callable[[PartShape, Told], Chosen]] = {
    "face_at": face_at,
    "rim_at": rim_at,
    "border_at": border_at,
    "borders_longer": borders_longer,
    "piece_at": piece_at,
    "cad_face_at": cad_face_at,
    "cad_edge_at": cad_edge_at,
}


def _nearest(shape: PartShape, point: Sequence[float]) -> _core.Hit:
    hit = shape.tree.nearest_point(np.array(point, dtype=float))
    if hit is None:
        raise SelectorError(f'"{shape.name}" has no triangle', "give it a mesh")
    return hit


def _touching(shape: PartShape, hit: _core.Hit) -> list[int]:
    """Return the triangles at a hit: several on an edge or at a corner."""
    corners = shape.triangles[hit.triangle][np.asarray(hit.barycentric) > _ON_EDGE]
    if len(corners) == 3:
        return [hit.triangle]
    has_all = np.ones(len(shape.triangles), dtype=bool)
    for corner in corners:
        has_all &= (shape.triangles == corner).any(axis=1)
    found: list[int] = np.flatnonzero(has_all).tolist()
    return found


def _largest(shape: PartShape, patches: Iterator[Ints]) -> Ints:
    """Return the patch with the largest area, so that between two faces ids do not decide."""
    return max(
        map(np.asarray, patches), key=lambda rows: (float(shape.areas[rows].sum()), -int(rows[0]))
    )


def nearest_loop(
    shape: PartShape, loops: Sequence[Ints], point: Sequence[float], holes: int = 0
) -> tuple[Ints, float]:
    """Return the loop nearest to a point, the shortest of several, and its distance, mm.

    For the first `holes` loops the distance to the centre counts if it is smaller.
    """
    place = np.array(point, dtype=float)
    gaps = [_line_distance(shape.points[loop], place) for loop in loops]
    for k, loop in enumerate(loops[:holes]):
        centre = shape.points[loop].mean(axis=0)
        gaps[k] = min(gaps[k], float(np.linalg.norm(centre - place)))
    least = min(gaps) + shape.slack
    near = [k for k, gap in enumerate(gaps) if gap <= least]
    best = min(near, key=lambda k: loop_length(shape, loops[k]))
    return loops[best], gaps[best]


def loop_length(shape: PartShape, loop: Ints) -> float:
    """Return the length of a closed loop, mm."""
    points = shape.points[loop]
    return float(np.linalg.norm(points - np.roll(points, 1, axis=0), axis=1).sum())


def _line_distance(points: Floats, place: Floats) -> float:
    """Return the distance from a point to the closed polyline through points (k, 3)."""
    return segments_distance(np.stack([points, np.roll(points, -1, axis=0)], axis=1), place)


def rim_loops(shape: PartShape, told: Told) -> tuple[list[Ints], list[int]]:
    """Return the candidate loops of rim_at, and the feature rows of the first ones."""
    if told.get("alone"):
        return [*shape.border_loops, *shape.loops_at(told.get("crease_angle", CREASE))], []
    loops: list[Ints] = []
    rows: list[int] = []
    for row, entry in enumerate(shape.features):
        for rim in entry.get("rims", ()) if entry["kind"] in RIMMED else ():
            loops.append(np.array(rim))
            rows.append(row)
    known = {frozenset(loop.tolist()) for loop in loops}
    others = [
        loop
        for loop in (*shape.border_loops, *shape.loops_at(CREASE))
        if frozenset(loop.tolist()) not in known
    ]
    return [*loops, *others], rows


def rim_vertices(shape: PartShape, told: Told, loop: Ints, row: int | None) -> Ints:
    """Return the vertices that rim_at selects with a loop, before any ring."""
    if row is not None:
        return np.array(shape.features[row]["vertices"])
    return loop if told.get("alone") else _with_wall(shape, loop)


def _with_wall(shape: PartShape, loop: Ints) -> Ints:
    """Return a sharp rim with its wall; a rim at a border has none."""
    inside = np.zeros(len(shape.points), dtype=bool)
    inside[loop] = True
    beside = np.flatnonzero(inside[shape.triangles].sum(axis=1) == 2)
    patches: list[Ints] = []
    for triangle in beside.tolist():
        if not any(triangle in patch for patch in patches) and len(patches) < 2:
            patches.append(np.asarray(shape.near.face(triangle, math.radians(35.0))))
    if len(patches) < 2:
        return loop
    narrow, wide = sorted(patches, key=lambda rows: float(shape.areas[rows].sum()))
    is_wall = shape.areas[narrow].sum() < _WALL * shape.areas[wide].sum()
    found: Ints = np.unique(shape.triangles[narrow]) if is_wall else loop
    return found


def _narrowed(shape: PartShape, told: Told, present: list[int]) -> tuple[list[int], list[str]]:
    """Return the CAD faces that kind and name allow, and remarks."""
    faces = shape.labels.faces
    allowed, remarks = present, []
    if "kind" in told:
        allowed = [k for k in allowed if faces[k].kind == told["kind"]]
        if not allowed:
            kinds = ", ".join(sorted({faces[k].kind for k in present}))
            what = f'"{shape.name}" has no face that is a {told["kind"]}'
            raise SelectorError(what, f"its faces are: {kinds}", ("kind",))
    if "name" in told:
        named = [k for k in allowed if faces[k].name == told["name"]]
        if not named:
            remarks.append(f'no face is called "{told["name"]}" now; the nearest one is used')
        allowed = named or allowed
    return allowed, remarks


def _nearest_face(
    shape: PartShape, point: Sequence[float], allowed: list[int]
) -> tuple[int, float]:
    face = shape.labels.face
    assert face is not None  # the caller checked for CAD faces
    rows = np.flatnonzero(np.isin(face, allowed))
    place = np.array(point, dtype=float)
    hit = shape.core.PickingTree(shape.points, shape.triangles[rows]).nearest_point(place)
    here = np.asarray(hit.point)
    corners = shape.triangles[rows[hit.triangle]][np.asarray(hit.barycentric) > _ON_EDGE]
    touching = rows[np.isin(shape.triangles[rows], corners).sum(axis=1) >= len(corners)]
    numbers = np.unique(face[touching]).tolist()
    best = max(numbers, key=lambda k: (float(shape.areas[face == k].sum()), -k))
    return best, float(np.linalg.norm(here - place))


def _renumbered(face: CadFace, told: Told) -> list[str]:
    if told.get("number", face.number) == face.number:
        return []
    return [f"face {told['number']} of the file has moved: face {face.number} is now at its point"]


def _matched(shape: PartShape, chosen: Chosen, key: str, distance: float) -> Chosen:
    entry = {"selector": key, "distance": float(distance)}
    return replace(chosen, matches=[entry], remarks=far_remarks(shape, key, distance))


def far_remarks(shape: PartShape, key: str, distance: float) -> list[str]:
    """Return a remark if the match is far from the given point."""
    if not distance > FAR * shape.size:
        return []
    return [f"{key}: the nearest match is {distance:.4g} mm from the point"]

# SPDX-License-Identifier: LGPL-2.1-or-later
"""A sheet bent along an arc and twisted about its length: the motion of its far end."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np

from sheetmorph import PartMesh, Session, _core


def turned(axis: int, degrees: float) -> np.ndarray:
    """The rotation (3, 3) about a coordinate axis."""
    one, other = (axis + 1) % 3, (axis + 2) % 3
    angle = np.radians(degrees)
    matrix = np.eye(3)
    matrix[[one, other], [one, other]] = np.cos(angle)
    matrix[other, one], matrix[one, other] = np.sin(angle), -np.sin(angle)
    return matrix


def bent_and_twisted(length: float, bend: float, twist: float) -> dict[str, Any]:
    """The pose of the far end of a sheet in the xy plane, `length` mm away in y; degrees.

    The end goes where an arc of the same length ends, and turns about the sheet's own length.
    """
    matrix = turned(0, bend) @ turned(1, twist)
    angle = np.arccos(np.clip(0.5 * (np.trace(matrix) - 1.0), -1.0, 1.0))
    skew = np.array([matrix[2, 1] - matrix[1, 2], matrix[0, 2] - matrix[2, 0], 0.0])
    skew[2] = matrix[1, 0] - matrix[0, 1]
    shift = np.zeros(3)
    if bend:
        radius = length / np.radians(bend)
        shift = radius * np.array([0.0, np.sin(np.radians(bend)), 1.0 - np.cos(np.radians(bend))])
        shift[1] -= length
    rotation = {"axis": skew.tolist(), "degrees": float(np.degrees(angle))}
    return {"translation": shift.tolist(), "rotation": rotation}


@dataclass(frozen=True)
class Ends:
    """Shares of the length along an axis that are held at the low end and moved at the high end."""

    axis: int = 1
    share: float = 0.03


def bent(mesh: PartMesh, holes: list[np.ndarray], ends: Ends, **keys: Any) -> Session:
    """A session of one part with a handle "end"; keys: of the recipe, `part`: those of the part.

    Holes are features; those at the ends go with the ends.
    """
    along = mesh.points[:, ends.axis]
    beyond = ends.share * np.ptp(along) + 1e-6
    held, moved = along < along.min() + beyond, along > along.max() - beyond
    inner = []
    for vertices in holes:
        for end in (held, moved):
            end[vertices] |= end[vertices].any()
        if not (held[vertices].any() or moved[vertices].any()):
            inner.append(vertices)
    recipe = {
        "sheetmorph": 1,
        "parts": [{"name": "part", **keys.pop("part", {})}],
        "fixed": [{"part": "part", "vertices": np.flatnonzero(held).tolist()}],
        "handles": [{"name": "end", "part": "part", "vertices": np.flatnonzero(moved).tolist()}],
        "features": [
            {"name": f"hole{k}", "part": "part", "vertices": vertices.tolist()}
            for k, vertices in enumerate(inner)
        ],
        **keys,
    }
    return Session(recipe, {"part": PartMesh(mesh.points, mesh.triangles)})


def thin_holes(mesh: PartMesh) -> tuple[Any, list[np.ndarray]]:
    """The thin solid that a mesh is, and its holes through both skins."""
    solid, reason = _core.find_thin_solid(_core.TriangleMesh(mesh.points, mesh.triangles), 0.0)
    assert reason == ""
    return solid, [np.asarray(hole.vertices) for hole in solid.holes]


@dataclass(frozen=True)
class Shape:
    """A mesh and how far each of its vertices (n, 3) has moved, mm."""

    mesh: PartMesh
    moved: np.ndarray

    def at(self, places: np.ndarray) -> np.ndarray:
        """How far the nearest places of the mesh at rest have moved (k, 3), mm."""
        tree = _core.PickingTree(self.mesh.points, self.mesh.triangles)
        hits = [tree.nearest_point(place) for place in places]
        corners = self.mesh.triangles[[hit.triangle for hit in hits]]
        weights = np.array([hit.barycentric for hit in hits])
        return np.einsum("kj,kjc->kc", weights, self.moved[corners])


@dataclass(frozen=True)
class Bend:
    """How a plate along y is bent, degrees; its outermost vertices are held and moved, so that its
    ends are the same on every mesh."""

    bend: float = 30.0
    twist: float = 0.0
    energy: str = "neumann"

    def of(self, mesh: PartMesh, holes: list[np.ndarray], **part: Any) -> Shape:
        """A mesh bent so; part: keys of it in the recipe."""
        session = bent(mesh, holes, Ends(1, 0.0), energy=self.energy, part=part)
        pose = {"end": bent_and_twisted(np.ptp(mesh.points[:, 1]), self.bend, self.twist)}
        return Shape(mesh, session.deform(pose).positions["part"] - mesh.points)


def open_middle(mesh: PartMesh) -> tuple[PartMesh, list[np.ndarray]]:
    """A flat thin solid in a plane of equal z as the open sheet in its middle, and its holes."""
    solid, holes = thin_holes(mesh)
    triangles = mesh.triangles[np.asarray(solid.facets) == 0]
    used, corners = np.unique(triangles, return_inverse=True)
    number = np.full(len(mesh.points), -1)
    number[used] = np.arange(len(used))
    points = mesh.points[used].copy()
    points[:, 2] = 0.5 * (mesh.points[:, 2].min() + mesh.points[:, 2].max())
    rims = [number[hole][number[hole] >= 0] for hole in holes]
    return PartMesh(points, corners.reshape(-1, 3).astype(np.int32)), rims


def halving_changes(coarse: PartMesh, fine: PartMesh, bend: Bend) -> dict[str, float]:
    """What a thin plate in a plane of equal z does when its mesh is made finer, as shares of the
    largest displacement: "halved" everywhere on it, "open" its middle against an open sheet there,
    with the coarse mesh.
    """
    rough, smooth = (bend.of(mesh, thin_holes(mesh)[1], thin="auto") for mesh in (coarse, fine))
    sheet = bend.of(*open_middle(coarse))
    step = max(1, len(fine.points) // 2000)
    places = fine.points[::step]
    size = np.linalg.norm(smooth.moved, axis=1).max()
    low, high = fine.points[:, 2].min(), fine.points[:, 2].max()

    def on(z: float) -> np.ndarray:
        return np.column_stack([places[:, :2], np.full(len(places), z)])

    middle = 0.5 * (smooth.at(on(low)) + smooth.at(on(high)))
    halved = smooth.moved[::step] - rough.at(places)
    apart = middle - sheet.at(on(0.5 * (low + high)))
    return {
        "halved": np.linalg.norm(halved, axis=1).max() / size,
        "open": np.linalg.norm(apart, axis=1).max() / size,
    }

# SPDX-License-Identifier: LGPL-2.1-or-later
"""Meshes and placements: the only module that builds FreeCAD meshes and knows coordinates.

Three coordinate systems, all in mm:

- *global*: what the user sees; regions, handles, sessions and recipes speak it;
- *local*: what a `Mesh::Feature` stores, seen under its global placement (its own one and those
  of all containers around it); single precision;
- *file*: the numbers in an imported file, in double; local = file - origin, where the origin is
  near the part, so that single precision shows a hole at vehicle coordinates round.
"""

from __future__ import annotations

import io
import os
import tempfile
from dataclasses import dataclass
from pathlib import Path

import FreeCAD
import Mesh
import numpy as np

# FreeCAD's binary mesh kernel (.bms): the only route that is fast, keeps every vertex and facet
# (also unused, doubled and non-manifold ones) and their order. Reading from a stream works;
# writing to a stream loses bytes in FreeCAD 0.20, therefore the temporary file.
BMS_HEADER = np.array([0xA0B0C0D0, 0x00010000], "<u4").tobytes() + b"SheetMorph".ljust(256)
BMS_FACET = np.dtype([("points", "<u4", 3), ("neighbours", "<u4", 3)])
NO_NEIGHBOUR = 0xFFFFFFFF


@dataclass(frozen=True)
class Frame:
    """How the file coordinates of one part become global ones."""

    rotation: np.ndarray  # (3, 3)
    base: np.ndarray  # (3,) mm, global position of the local origin
    origin: np.ndarray  # (3,) mm, file position of the local origin

    @property
    def key(self) -> tuple[bytes, bytes, bytes]:
        """What differs where the frame does."""
        return self.rotation.tobytes(), self.base.tobytes(), self.origin.tobytes()

    def to_global(self, points: np.ndarray) -> np.ndarray:
        """Return the global positions, (n, 3) mm, of file positions (n, 3).

        A part that lies where its file says keeps every bit of its coordinates.
        """
        if self.is_unmoved():
            return points.copy()
        return (points - self.origin) @ self.rotation.T + self.base

    def to_local(self, points: np.ndarray) -> np.ndarray:
        """Return the local positions, (n, 3) mm, of global positions (n, 3)."""
        return (points - self.base) @ self.rotation

    def is_unmoved(self) -> bool:
        """Whether global and file coordinates are the same numbers."""
        return bool(np.all(self.rotation == np.eye(3)) and np.all(self.base == self.origin))


def frame_of(feature, origin: np.ndarray) -> Frame:
    """Return the frame of a `Mesh::Feature` whose local origin is `origin` in its file."""
    placement = feature.getGlobalPlacement()
    matrix = np.array(placement.toMatrix().A, dtype=float).reshape(4, 4)
    return Frame(matrix[:3, :3], matrix[:3, 3], np.asarray(origin, dtype=float))


def scaled_placement(frame: Frame, scale: float, origin: np.ndarray) -> FreeCAD.Placement:
    """Return where a mesh is whose file coordinates are `scale` times those of another.

    `frame`: of the other; `origin` (3,): the local origin of the mesh, in its file coordinates.
    """
    base = scale * frame.base + frame.rotation @ (origin - scale * frame.origin)
    matrix = np.eye(4)
    matrix[:3, :3], matrix[:3, 3] = frame.rotation, base
    return FreeCAD.Placement(FreeCAD.Matrix(*matrix.ravel().tolist()))


def standing(rotation: np.ndarray, translation: np.ndarray, origin: np.ndarray):
    """Return where a mesh with the local origin `origin` is, of which the file is turned, then
    shifted."""
    matrix = np.eye(4)
    matrix[:3, :3], matrix[:3, 3] = rotation, rotation @ origin + translation
    return FreeCAD.Placement(FreeCAD.Matrix(*matrix.ravel().tolist()))


def placement_entry(frame: Frame) -> dict:
    """Return what a recipe says of a part that stands elsewhere than its file says."""
    matrix = np.eye(4)
    matrix[:3, :3] = frame.rotation
    turn = FreeCAD.Placement(FreeCAD.Matrix(*matrix.ravel().tolist())).Rotation
    entry: dict = {"translation": (frame.base - frame.rotation @ frame.origin).tolist()}
    if turn.Angle != 0.0:
        entry["rotation"] = {"axis": list(turn.Axis), "degrees": float(np.degrees(turn.Angle))}
    return entry


def container_placement(obj) -> FreeCAD.Placement:
    """Return the global placement of the container that `obj` lives in."""
    return obj.getGlobalPlacement().multiply(obj.getPropertyByName("Placement").inverse())


def result_placement(part) -> FreeCAD.Placement:
    """Return the placement that shows `part` exactly over its source, whatever contains them."""
    outside = container_placement(part)
    return outside.inverse().multiply(part.Source.getGlobalPlacement())


def copy_at(mesh, placement: FreeCAD.Placement) -> Mesh.Mesh:
    """Return a copy of a FreeCAD mesh, with the same local points, seen under `placement`."""
    copied = mesh.copy()
    copied.Placement = placement
    return copied


def near_origin(points: np.ndarray) -> np.ndarray:
    """Return a point (3,) of whole mm near `points` (n, 3), zero if they are near zero already.

    Subtracting it leaves numbers small enough for single precision.
    """
    low, high = points.min(axis=0), points.max(axis=0)
    size = float(np.linalg.norm(high - low))
    if float(np.max(np.abs(points))) <= 4.0 * size:
        return np.zeros(3)
    return np.round(0.5 * (low + high))


def read_mesh(mesh) -> tuple[np.ndarray, np.ndarray]:
    """Return the local points (n, 3) float32 and the triangles (m, 3) int32 of a FreeCAD mesh.

    The placement of the mesh plays no role. Order, unused vertices and bad triangles are kept.
    """
    with temporary_folder() as folder:
        path = os.path.join(folder, "mesh.bms")
        mesh.write(path)
        data = Path(path).read_bytes()
    counts = np.frombuffer(data, "<u4", 2, len(BMS_HEADER))
    n_points, n_facets = int(counts[0]), int(counts[1])
    start = len(BMS_HEADER) + counts.nbytes
    points = np.frombuffer(data, "<f4", 3 * n_points, start).reshape(-1, 3)
    facets = np.frombuffer(data, BMS_FACET, n_facets, start + points.nbytes)
    return points.copy(), facets["points"].astype(np.int32)  # a view would keep all of the file


def temporary_folder() -> tempfile.TemporaryDirectory:
    """Return a folder that vanishes with its context, in memory where the system has such."""
    in_memory = "/dev/shm" if os.access("/dev/shm", os.W_OK) else None
    return tempfile.TemporaryDirectory(dir=in_memory)


def shift(origin: np.ndarray) -> FreeCAD.Placement:
    """Return the placement that moves by `origin` (3,) mm."""
    return FreeCAD.Placement(FreeCAD.Vector(*origin.tolist()), FreeCAD.Rotation())


class MeshWriter:
    """Makes FreeCAD meshes of one topology; the constructor does what the points do not need."""

    def __init__(self, triangles: np.ndarray):
        """`triangles`: (m, 3) indices of points; they are kept, not copied."""
        self.triangles = np.asarray(triangles)
        self._neighbours = neighbours(self.triangles)

    def mesh(self, points: np.ndarray, placement: FreeCAD.Placement | None = None) -> Mesh.Mesh:
        """Return a mesh of local `points` (n, 3) mm, seen under `placement`."""
        local = np.ascontiguousarray(points, "<f4")
        corners = np.stack([local.min(axis=0), local.max(axis=0)], axis=1)
        facets = np.empty(len(self.triangles), BMS_FACET)
        facets["points"], facets["neighbours"] = self.triangles, self._neighbours
        data = b"".join(
            [
                BMS_HEADER,
                np.array([len(local), len(facets)], "<u4").tobytes(),
                local.tobytes(),
                facets.tobytes(),
                corners.astype("<f4").tobytes(),
            ]
        )
        mesh = Mesh.Mesh()
        mesh.read(Stream=io.BytesIO(data), Format="BMS")
        if placement is not None:
            mesh.Placement = placement
        return mesh


def neighbours(triangles: np.ndarray) -> np.ndarray:
    """Return per triangle (m, 3) the one across its edges 01, 12 and 20, or NO_NEIGHBOUR.

    An edge of one triangle is a boundary, one of three and more has no definite neighbour.
    """
    ends = np.stack([triangles, np.roll(triangles, -1, axis=1)], axis=2).reshape(-1, 2)
    ends = np.sort(ends.astype(np.int64), axis=1)
    key = ends[:, 0] * (int(triangles.max(initial=0)) + 1) + ends[:, 1]
    order = np.argsort(key, kind="stable")
    _, first, count = np.unique(key[order], return_index=True, return_counts=True)
    one, other = order[first[count == 2]], order[first[count == 2] + 1]
    across = np.full(len(key), NO_NEIGHBOUR, np.uint32)
    across[one], across[other] = other // 3, one // 3
    return across.reshape(-1, 3)

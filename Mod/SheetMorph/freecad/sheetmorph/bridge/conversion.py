# SPDX-License-Identifier: LGPL-2.1-or-later
"""Meshes and placements; only this module builds FreeCAD meshes and converts coordinates.

Three coordinate systems, all in mm:
- *global*: what the user sees; regions, handles, sessions and recipes use it.
- *local*: stored in a `Mesh::Feature`, in single precision, and displayed under its global
  placement (its own and those of all containers).
- *file*: the numbers in an imported file, in double precision; local = file - origin. The origin is
  near the part, so that single precision shows a hole at vehicle coordinates as round.
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

# FreeCAD's binary mesh format (.bms) is the only fast route that keeps every vertex and facet,
# including unused, duplicate and non-manifold ones, and their order. Reading from a stream works.
# Writing to a stream loses bytes in FreeCAD 0.20, hence the temporary file.
BMS_HEADER = np.array([0xA0B0C0D0, 0x00010000], "<u4").tobytes() + b"SheetMorph".ljust(256)
BMS_FACET = np.dtype([("points", "<u4", 3), ("neighbours", "<u4", 3)])
NO_NEIGHBOUR = 0xFFFFFFFF


@dataclass(frozen=True)
class Frame:
    """The mapping from file coordinates of one part to global coordinates."""

    rotation: np.ndarray  # (3, 3)
    base: np.ndarray  # (3,) mm, global position of the local origin
    origin: np.ndarray  # (3,) mm, file position of the local origin

    @property
    def key(self) -> tuple[bytes, bytes, bytes]:
        """Key for comparison of frames."""
        return self.rotation.tobytes(), self.base.tobytes(), self.origin.tobytes()

    def to_global(self, points: np.ndarray) -> np.ndarray:
        """Return the global positions (n, 3), mm, of file positions (n, 3).

        A part at its file position keeps every bit of its coordinates.
        """
        if self.is_unmoved():
            return points.copy()
        return (points - self.origin) @ self.rotation.T + self.base

    def to_local(self, points: np.ndarray) -> np.ndarray:
        """Return the local positions (n, 3), mm, of global positions (n, 3)."""
        return (points - self.base) @ self.rotation

    def is_unmoved(self) -> bool:
        """Return whether global and file coordinates are equal."""
        return bool(np.all(self.rotation == np.eye(3)) and np.all(self.base == self.origin))


def frame_of(feature, origin: np.ndarray) -> Frame:
    """Return the frame of a `Mesh::Feature` with its local origin at `origin` in its file."""
    placement = feature.getGlobalPlacement()
    matrix = np.array(placement.toMatrix().A, dtype=float).reshape(4, 4)
    return Frame(matrix[:3, :3], matrix[:3, 3], np.asarray(origin, dtype=float))


def scaled_placement(frame: Frame, scale: float, origin: np.ndarray) -> FreeCAD.Placement:
    """Return the placement of a mesh whose file coordinates are `scale` times those of another.

    `frame` is that of the other mesh. `origin` (3,) is the local origin in the new file
    coordinates.
    """
    base = scale * frame.base + frame.rotation @ (origin - scale * frame.origin)
    matrix = np.eye(4)
    matrix[:3, :3], matrix[:3, 3] = frame.rotation, base
    return FreeCAD.Placement(FreeCAD.Matrix(*matrix.ravel().tolist()))


def standing(rotation: np.ndarray, translation: np.ndarray, origin: np.ndarray):
    """Return the placement of a mesh whose file is rotated, then shifted.

    `origin` is its local origin in file coordinates.
    """
    matrix = np.eye(4)
    matrix[:3, :3], matrix[:3, 3] = rotation, rotation @ origin + translation
    return FreeCAD.Placement(FreeCAD.Matrix(*matrix.ravel().tolist()))


def placement_entry(frame: Frame) -> dict:
    """Return the recipe key `placement` of a part that was moved from its file position."""
    matrix = np.eye(4)
    matrix[:3, :3] = frame.rotation
    turn = FreeCAD.Placement(FreeCAD.Matrix(*matrix.ravel().tolist())).Rotation
    entry: dict = {"translation": (frame.base - frame.rotation @ frame.origin).tolist()}
    if turn.Angle != 0.0:
        entry["rotation"] = {"axis": list(turn.Axis), "degrees": float(np.degrees(turn.Angle))}
    return entry


def container_placement(obj) -> FreeCAD.Placement:
    """Return the global placement of the container of `obj`."""
    return obj.getGlobalPlacement().multiply(obj.getPropertyByName("Placement").inverse())


def result_placement(part) -> FreeCAD.Placement:
    """Return the placement that shows `part` exactly over its source, whatever contains them."""
    outside = container_placement(part)
    return outside.inverse().multiply(part.Source.getGlobalPlacement())


def copy_at(mesh, placement: FreeCAD.Placement) -> Mesh.Mesh:
    """Return a copy of a FreeCAD mesh with the same local points under `placement`."""
    copied = mesh.copy()
    copied.Placement = placement
    return copied


def near_origin(points: np.ndarray) -> np.ndarray:
    """Return a point (3,) of whole mm near `points` (n, 3), or zero if they are near zero.

    Its subtraction gives numbers small enough for single precision.
    """
    low, high = points.min(axis=0), points.max(axis=0)
    size = float(np.linalg.norm(high - low))
    if float(np.max(np.abs(points))) <= 4.0 * size:
        return np.zeros(3)
    return np.round(0.5 * (low + high))


def read_mesh(mesh) -> tuple[np.ndarray, np.ndarray]:
    """Return the local points (n, 3) float32 and the triangles (m, 3) int32 of a FreeCAD mesh.

    The placement is ignored. Order, unused vertices and degenerate triangles are kept.
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
    # a view would keep the whole file in memory
    return points.copy(), facets["points"].astype(np.int32)


def temporary_folder() -> tempfile.TemporaryDirectory:
    """Return a temporary folder, in memory if the system supports it."""
    in_memory = "/dev/shm" if os.access("/dev/shm", os.W_OK) else None
    return tempfile.TemporaryDirectory(dir=in_memory)


def shift(origin: np.ndarray) -> FreeCAD.Placement:
    """Return the placement that moves by `origin` (3,), mm."""
    return FreeCAD.Placement(FreeCAD.Vector(*origin.tolist()), FreeCAD.Rotation())


class MeshWriter:
    """Builder of FreeCAD meshes of one topology, which is prepared once."""

    def __init__(self, triangles: np.ndarray):
        """Store `triangles` (m, 3), indices of points, without a copy."""
        self.triangles = np.asarray(triangles)
        self._neighbours = neighbours(self.triangles)

    def mesh(self, points: np.ndarray, placement: FreeCAD.Placement | None = None) -> Mesh.Mesh:
        """Return a mesh of local `points` (n, 3), mm, under `placement`."""
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
    """Return for each triangle (m, 3) the neighbours at its edges 01, 12 and 20, or NO_NEIGHBOUR.

    Border edges have no neighbour. Edges of three or more triangles have no unique neighbour.
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

# SPDX-License-Identifier: LGPL-2.1-or-later
"""The triangle mesh of one part in double precision, with the vertex ids of its file."""

from __future__ import annotations

from collections.abc import Sequence, Sized
from dataclasses import dataclass, replace
from types import ModuleType
from typing import Any

import numpy as np

from .arrays import Array, Floats, Ids, Ints
from .errors import InputError
from .foreign_meshes import faces_of_meshio, in_space, of_vtk, to_meshio, to_pyvista, to_vtk
from .labels import Labels
from .polygons import triangulate


def _of_kind(values: object, kinds: str, name: str) -> Array:
    """Return the values as an array of the allowed numpy kinds. Raises InputError."""
    array = np.asarray(values)
    if array.size and array.dtype.kind not in kinds:
        wanted = "numbers" if "f" in kinds else "whole numbers"
        what = f"{name} of a part must be {wanted}, not {array.dtype}"
        raise InputError(what, "convert the array")
    return array if array.size else array.astype(np.int64)


def _faces_of(values: object) -> Array | list[Array]:
    """Return faces as an array (m, k), or as a list of arrays if their sizes differ."""
    if isinstance(values, Sequence) and all(isinstance(one, Sized) for one in values):
        if len({len(one) for one in values}) > 1:
            return [_of_kind(one, "iu", "triangles") for one in values]
    return _of_kind(values, "iu", "triangles")


def _as_int64(ids: Ids) -> Ints:
    """Return the ids (k,); ids beyond int64 become the nearest int64, which no file uses."""
    try:
        return np.asarray(ids, dtype=np.int64)
    except OverflowError:
        limits = np.iinfo(np.int64)
        return np.array([min(max(int(i), limits.min), limits.max) for i in ids], dtype=np.int64)


@dataclass(frozen=True, eq=False, repr=False)
class PartMesh:
    """The mesh of one part at rest.

    Parameters
    ----------
    points : array (n, 3), float64
        Vertices, mm.
    triangles : array (m, 3), int32
        Vertex indices, from 0. Quads (m, 4), or a list of faces with three and more corners, are
        cut into triangles; a quad that repeats its last corner is a triangle.
    ids : array (n,), int64, optional
        Vertex ids of the file, such as node ids of a deck; by default 0 to n-1.
    name : str
        Name for messages.
    labels : Labels, optional
        Names in the file for regions of the mesh.
    thickness : float
        Thickness of the shells of a deck, mm; 0 if the file does not give it.

    Raises
    ------
    InputError
        For wrong shapes, non-finite numbers, indices out of range or duplicate ids.
    """

    points: Floats
    triangles: Ints
    ids: Ints | None = None
    name: str = ""
    labels: Labels | None = None
    thickness: float = 0.0

    def __post_init__(self) -> None:
        points = np.ascontiguousarray(_of_kind(self.points, "fiu", "points"), dtype=np.float64)
        object.__setattr__(self, "points", points)
        self._check_points()
        object.__setattr__(self, "triangles", self._cut(_faces_of(self.triangles)))
        if self.ids is not None:
            ids = np.ascontiguousarray(_of_kind(self.ids, "iu", "ids"), dtype=np.int64)
            object.__setattr__(self, "ids", ids)
            self._check_ids(ids)

    def __repr__(self) -> str:
        kind, name = type(self).__name__, f' "{self.name}"' if self.name else ""
        return f"<{kind}{name}: {len(self.points)} vertices, {len(self.triangles)} triangles>"

    def _check_points(self) -> None:
        points = self.points
        if points.ndim != 2 or points.shape[1] != 3:
            what = f"points of a part must be (n, 3), not {points.shape}"
            raise InputError(what, "give three coordinates for each vertex")
        if not np.isfinite(points).all():
            bad = int(np.flatnonzero(~np.isfinite(points).all(axis=1))[0])
            what = f"vertex {bad} has a coordinate that is not a finite number"
            raise InputError(what, "correct it, or leave the vertex out")

    def _cut(self, faces: Array | list[Array]) -> Ints:
        """Return the triangles (m, 3) int32 of faces. Raises InputError."""
        if isinstance(faces, np.ndarray):
            if faces.ndim != 2 or faces.shape[1] not in (3, 4):
                what = f"triangles of a part must be (m, 3), not {faces.shape}"
                raise InputError(what, "give triangles, quads (m, 4), or a list of faces")
            numbers = faces.ravel()
        else:
            if any(face.ndim != 1 or len(face) < 3 for face in faces):
                raise InputError("a face has fewer than three vertices", "leave it out")
            numbers = np.concatenate(faces)
        if numbers.size and (numbers.min() < 0 or numbers.max() >= len(self.points)):
            what = f"a triangle names a vertex outside 0 .. {len(self.points) - 1}"
            raise InputError(what, "count vertices from 0")
        if isinstance(faces, np.ndarray) and faces.shape[1] == 3:
            return np.ascontiguousarray(faces, dtype=np.int32)
        corners: list[Any] = [
            face[:3] if len(face) == 4 and face[2] == face[3] else face for face in faces
        ]
        return triangulate(self.points, corners)

    def _check_ids(self, ids: Ints) -> None:
        if ids.shape != (len(self.points),):
            what = f"ids must be one per vertex ({len(self.points)}), not {ids.shape}"
            raise InputError(what, "give an id for each vertex")
        if len(np.unique(ids)) != len(ids):
            raise InputError("two vertices have the same id", "give each its own")

    @classmethod
    def from_meshio(cls, mesh: Any, name: str = "") -> PartMesh:
        """Return the surface of a meshio mesh.

        Parameters
        ----------
        mesh : meshio.Mesh
            Points (n, 2) or (n, 3), mm; triangles, quads and polygons, other cells are left out.
        name : str
            Name for messages.

        Returns
        -------
        PartMesh
            The mesh; quads and polygons are cut into triangles.

        Raises
        ------
        InputError
            If it has no surface, or cells with mid-side nodes.
        """
        faces: Any = faces_of_meshio(mesh.cells)
        return cls(in_space(mesh.points), faces, name=name)

    @classmethod
    def from_pyvista(cls, surface: Any, name: str = "") -> PartMesh:
        """Return a surface of pyvista or VTK.

        Parameters
        ----------
        surface : pyvista.PolyData or vtkPolyData
            Points (n, 3), mm; triangles, quads and polygons.
        name : str
            Name for messages.

        Returns
        -------
        PartMesh
            The mesh; quads and polygons are cut into triangles.

        Raises
        ------
        InputError
            If it is not a surface.
        """
        points, faces = of_vtk(surface)
        return cls(points, faces, name=name)

    from_vtk = from_pyvista

    def to_meshio(self, points: Floats | None = None, **point_data: Array) -> Any:
        """Return the mesh for meshio; it needs meshio.

        Parameters
        ----------
        points : array (n, 3), optional
            Positions, mm, such as those of a Result; by default at rest.
        **point_data : array (n,) or (n, k)
            Values at the vertices.

        Returns
        -------
        meshio.Mesh
            The triangles.
        """
        return to_meshio(self.points if points is None else points, self.triangles, point_data)

    def to_pyvista(self, points: Floats | None = None, **point_data: Array) -> Any:
        """Return the mesh for pyvista, as to_meshio(); it needs pyvista.

        Returns
        -------
        pyvista.PolyData
            The triangles.
        """
        return to_pyvista(self.points if points is None else points, self.triangles, point_data)

    def to_vtk(self, points: Floats | None = None, **point_data: Array) -> Any:
        """Return the mesh for VTK, as to_meshio(); it needs VTK.

        Returns
        -------
        vtkPolyData
            The triangles.
        """
        return to_vtk(self.points if points is None else points, self.triangles, point_data)

    def find(self, ids: Ids, prepared: bool = False) -> tuple[Ints, list[int]]:
        """Find vertices by their file ids.

        Parameters
        ----------
        ids : sequence of int
            File ids.
        prepared : bool
            The ids count the vertices of the deformed mesh from 0.

        Returns
        -------
        indices : array (k,), int32
            Indices of the vertices found.
        missing : list of int
            Ids that do not exist.
        """
        wanted = _as_int64(ids)
        if self.ids is None or prepared:
            indices = wanted
            found = (wanted >= 0) & (wanted < len(self.points))
        else:
            order, ordered = self._ordered_ids(self.ids)
            places = np.searchsorted(ordered, wanted)
            found = places < len(ordered)
            found[found] = ordered[places[found]] == wanted[found]
            indices = order[np.where(found, places, 0)] if len(order) else places
        missing = [int(ids[k]) for k in np.flatnonzero(~found)]
        return indices[found].astype(np.int32), missing

    def _ordered_ids(self, ids: Ints) -> tuple[Ints, Ints]:
        """Return the indices (n,) sorted by id, and the sorted ids; both are cached."""
        cached = self.__dict__.get("_order")
        if cached is None:
            order = np.argsort(ids, kind="stable")
            cached = order, ids[order]
            object.__setattr__(self, "_order", cached)
        return cached

    def file_ids(self, indices: Ids) -> list[int]:
        """Return the file ids of vertices.

        Parameters
        ----------
        indices : sequence of int
            Vertex indices.

        Returns
        -------
        list of int
            Their file ids.
        """
        rows = np.asarray(indices, dtype=np.int64)
        found: list[int] = (rows if self.ids is None else self.ids[rows]).tolist()
        return found

    @property
    def preparation(self) -> dict[str, Any] | None:
        """What merging and remeshing changed in the file's mesh; None if nothing."""
        return None

    @property
    def file_triangle_count(self) -> int:
        """Number of triangles of the file, which a recipe counts from 0."""
        return len(self.triangles)

    def place_on(
        self, _core: ModuleType, triangle: int, barycentric: Sequence[float]
    ) -> tuple[int, Sequence[float]]:
        """Map a point on a triangle of the file to this mesh.

        Parameters
        ----------
        triangle : int
            Triangle of the file.
        barycentric : sequence of float
            Barycentric coordinates (3,).

        Returns
        -------
        triangle : int
            Triangle of this mesh.
        barycentric : sequence of float
            Barycentric coordinates (3,).
        """
        return triangle, barycentric

    def restricted(self, vertices: Ints, corners: Ints, name: str) -> PartMesh:
        """Return a part of the mesh, with the same file ids.

        Parameters
        ----------
        vertices : array (k,), int
            Vertices to keep.
        corners : array (m, 3), int
            Triangles over these vertices, indices from 0.
        name : str
            Name of the new mesh.

        Returns
        -------
        PartMesh
            The restricted mesh.
        """
        ids = np.array(self.file_ids(vertices), dtype=np.int64)
        return PartMesh(self.points[vertices], corners, ids, name)

    def with_indices(self) -> PartMesh:
        """Return the mesh with vertex indices in place of file ids, also in its labels.

        Returns
        -------
        PartMesh
            The renumbered mesh.
        """
        labels = self.labels
        if labels is not None:
            named = {name: self.find(ids)[0].tolist() for name, ids in labels.nodes.items()}
            labels = replace(labels, nodes={name: ids for name, ids in named.items() if ids})
        return PartMesh(self.points, self.triangles, name=self.name, labels=labels)

    def describe_ids(self, prepared: bool = False) -> str:
        """Describe the ids that a recipe can use, such as "0 .. 41", for messages.

        Parameters
        ----------
        prepared : bool
            Describe the vertices of the deformed mesh.

        Returns
        -------
        str
            The description.
        """
        if not len(self.points):
            return "it has none"
        if self.ids is None or prepared:
            return f"0 .. {len(self.points) - 1}"
        return f"node ids of its deck, {self.ids.min()} .. {self.ids.max()}"

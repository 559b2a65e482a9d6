# SPDX-License-Identifier: LGPL-2.1-or-later
"""Meshes of meshio, VTK and pyvista as points and faces, and back; imported when first used."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from typing import Any

import numpy as np

from .arrays import Array, Floats, Ints
from .errors import InputError

_CURVED = frozenset({"triangle6", "triangle7", "quad8", "quad9"})


def faces_of_meshio(blocks: Iterable[Any]) -> list[list[int]]:
    """Return the triangles, quads and polygons of the cell blocks of meshio. Raises InputError."""
    faces: list[list[int]] = []
    for block in blocks:
        if block.type in _CURVED:
            what = f"cells of type {block.type} have mid-side nodes, which are not read"
            raise InputError(what, "use three- and four-node cells")
        if block.type in ("triangle", "quad") or block.type.startswith("polygon"):
            faces += [list(map(int, cell)) for cell in block.data]
    if not faces:
        raise InputError("no triangles, quads or polygons were found", "export a surface mesh")
    return faces


def in_space(points: Any) -> Floats:
    """Return points (n, 2) or (n, 3) as (n, 3), with z = 0 if they are flat. Raises InputError."""
    given = np.asarray(points)
    if given.ndim != 2 or given.shape[1] not in (2, 3):
        raise InputError("it has no points in space", "export it as VTU or PLY")
    space = np.zeros((len(given), 3))
    space[:, : given.shape[1]] = given
    return space


def to_meshio(points: Floats, triangles: Ints, data: Mapping[str, Array]) -> Any:
    """Return a meshio.Mesh; data has arrays (n, ...) by name."""
    import meshio

    return meshio.Mesh(points, [("triangle", triangles)], point_data=dict(data))


def of_vtk(data: Any) -> tuple[Floats, Any]:
    """Return the points (n, 3) and faces of a vtkPolyData, such as pyvista's. Raises InputError."""
    from vtkmodules.util.numpy_support import vtk_to_numpy

    if not hasattr(data, "GetPolys"):
        what = f"a {type(data).__name__} is not a surface"
        raise InputError(what, "pass PolyData, in pyvista mesh.extract_surface()")
    polys, points = data.GetPolys(), data.GetPoints()
    if points is None or not polys.GetNumberOfCells():
        raise InputError("the surface has no polygons", "pass triangles, quads or polygons")
    corners = vtk_to_numpy(polys.GetConnectivityArray()).tolist()
    ends = vtk_to_numpy(polys.GetOffsetsArray()).tolist()
    faces = [corners[begin:end] for begin, end in zip(ends, ends[1:])]
    return vtk_to_numpy(points.GetData()).astype(np.float64), faces


def to_vtk(points: Floats, triangles: Ints, data: Mapping[str, Array]) -> Any:
    """Return a vtkPolyData; data has arrays (n,) or (n, k) by name."""
    from vtkmodules.util.numpy_support import numpy_to_vtk, numpy_to_vtkIdTypeArray
    from vtkmodules.vtkCommonCore import vtkPoints
    from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData

    places, cells, surface = vtkPoints(), vtkCellArray(), vtkPolyData()
    places.SetData(numpy_to_vtk(points, deep=True))
    ends = np.arange(0, triangles.size + 1, 3, dtype=np.int64)
    corners = triangles.ravel().astype(np.int64)
    cells.SetData(*(numpy_to_vtkIdTypeArray(one, deep=True) for one in (ends, corners)))
    surface.SetPoints(places)
    surface.SetPolys(cells)
    for name, values in data.items():
        array = numpy_to_vtk(np.ascontiguousarray(values), deep=True)
        array.SetName(name)
        surface.GetPointData().AddArray(array)
    return surface


def to_pyvista(points: Floats, triangles: Ints, data: Mapping[str, Array]) -> Any:
    """Return a pyvista.PolyData; data has arrays (n,) or (n, k) by name."""
    import pyvista

    return pyvista.wrap(to_vtk(points, triangles, data))

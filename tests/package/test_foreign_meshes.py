# SPDX-License-Identifier: LGPL-2.1-or-later
"""Meshes of numpy, meshio, VTK and pyvista become parts, and parts become such meshes."""

from __future__ import annotations

import subprocess
import sys

import meshio
import numpy as np
import pytest
from plates import plate

import sheetmorph as sm
from sheetmorph import InputError, PartMesh, RecipeError

vtk = pytest.importorskip("vtk", reason="needs VTK, for example python3-vtk9")
STRIP = plate(holes=2)
MESH = PartMesh(np.array(STRIP.points, dtype=float), np.array(STRIP.triangles), name="strip")
# Two unit squares beside each other.
POINTS = np.array([[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0], [2, 0, 0], [2, 1, 0]], dtype=float)
QUADS = [[0, 1, 2, 3], [1, 4, 5, 2]]


def area(mesh: PartMesh) -> float:
    a, b, c = (mesh.points[mesh.triangles[:, k]] for k in range(3))
    return float(np.cross(b - a, c - a)[:, 2].sum() / 2.0)


@pytest.mark.parametrize("faces", [QUADS, np.array(QUADS, dtype=np.uint64), tuple(QUADS)])
def test_quads_are_cut_into_triangles(faces):
    mesh = PartMesh(POINTS, faces)
    assert mesh.triangles.shape == (4, 3) and mesh.triangles.dtype == np.int32
    assert area(mesh) == pytest.approx(2.0)


@pytest.mark.parametrize(
    ("faces", "count"),
    [
        ([[0, 1, 2, 3], [1, 4, 5]], 3),
        ([[0, 1, 2, 2], [1, 4, 5, 2]], 3),
        ([[0, 1, 4, 5, 2, 3], [5, 2, 1]], 5),
    ],
)
def test_faces_of_any_size_are_cut(faces, count):
    assert len(PartMesh(POINTS, faces).triangles) == count


@pytest.mark.parametrize(
    ("faces", "said"),
    [
        ([[0, 1], [0, 1, 2]], "fewer than three vertices"),
        ([[0, 1, 2, 6]], "outside 0 .. 5"),
        ([[0, 1, 2], [0, 1, 2, -1]], "outside 0 .. 5"),
        ([[0, 1, 2, 3, 4]], r"must be \(m, 3\)"),
        ([[0, 1, 2.5], [0, 1, 2, 3]], "whole numbers"),
    ],
)
def test_wrong_faces_are_refused(faces, said: str):
    with pytest.raises(ValueError, match=said):
        PartMesh(POINTS, faces)


def test_meshio_and_back():
    made = MESH.to_meshio(height=MESH.points[:, 2])
    assert isinstance(made, meshio.Mesh) and made.point_data["height"].shape == (len(MESH.points),)
    back = PartMesh.from_meshio(made, "strip")
    assert np.array_equal(back.points, MESH.points)
    assert np.array_equal(back.triangles, MESH.triangles) and back.name == "strip"


def test_meshio_with_quads_in_the_plane_and_other_cells():
    cells = [("line", [[0, 1]]), ("quad", QUADS)]
    assert area(PartMesh.from_meshio(meshio.Mesh(POINTS[:, :2], cells))) == pytest.approx(2.0)


@pytest.mark.parametrize(
    ("cells", "said"),
    [([("line", [[0, 1]])], "no triangles"), ([("triangle6", [range(6)])], "mid-side")],
)
def test_meshio_without_a_surface_is_refused(cells, said: str):
    with pytest.raises(InputError, match=said):
        PartMesh.from_meshio(meshio.Mesh(POINTS, cells))


def test_vtk_and_back():
    made = MESH.to_vtk(MESH.points + [0, 0, 1], shift=MESH.points)
    assert made.GetPointData().GetArray("shift").GetNumberOfComponents() == 3
    back = PartMesh.from_vtk(made)
    assert np.array_equal(back.points, MESH.points + [0, 0, 1])
    assert np.array_equal(back.triangles, MESH.triangles)


def test_a_plane_of_vtk_has_quads():
    source = vtk.vtkPlaneSource()
    source.SetXResolution(4)
    source.Update()
    mesh = PartMesh.from_pyvista(source.GetOutput())
    assert len(mesh.triangles) == 8 and area(mesh) == pytest.approx(1.0)


@pytest.mark.parametrize(
    ("data", "said"),
    [(vtk.vtkUnstructuredGrid(), "not a surface"), (vtk.vtkPolyData(), "no polygons")],
)
def test_vtk_without_a_surface_is_refused(data, said: str):
    with pytest.raises(InputError, match=said):
        PartMesh.from_vtk(data)


def test_pyvista_and_back():
    pyvista = pytest.importorskip("pyvista", reason="pyvista is not installed")
    made = MESH.to_pyvista(shift=MESH.points)
    assert isinstance(made, pyvista.PolyData) and made["shift"].shape == MESH.points.shape
    assert np.array_equal(PartMesh.from_pyvista(made).triangles, MESH.triangles)


def test_none_of_them_is_imported_before_it_is_used():
    lines = "import sys, numpy, sheetmorph as sm\nsm.PartMesh(numpy.eye(3), [[0, 1, 2]])"
    ask = "print([n for n in ('meshio', 'vtk', 'vtkmodules', 'pyvista') if n in sys.modules])"
    done = subprocess.run([sys.executable, "-c", f"{lines}\n{ask}"], capture_output=True, text=True)
    assert (done.stdout, done.stderr) == ("[]\n", "")


# -- a morph of meshes in memory


@pytest.fixture
def morph() -> sm.Morph:
    x = MESH.points[:, 0]
    morph = sm.Morph([MESH])
    return morph.fix(x < x.min() + 1.0).handle(x > x.max() - 1.0, "tip").move("tip", [0, 0, 5])


def test_a_morph_starts_from_arrays(morph: sm.Morph):
    result = morph.deform()
    shift = result.displacements["strip"]
    assert np.array_equal(shift, result.positions["strip"] - MESH.points)
    assert shift[:, 2].max() == pytest.approx(5.0)
    assert repr(morph) == "<Morph of strip: 1 fixed region, 1 handle>"
    assert repr(result) == "<Result of strip: moved by up to 5 mm>"


def test_meshes_and_files_are_mixed_and_get_names():
    two = sm.open_files(PartMesh(POINTS, QUADS), MESH)
    assert two.parts == ["part1", "strip"] and two.recipe["primary"] == "part1"


def test_a_morph_in_memory_is_not_written(morph: sm.Morph, tmp_path):
    for write in (morph.save, morph.write):
        with pytest.raises(RecipeError, match="strip are in memory; take the positions"):
            write(tmp_path / "out")
    assert list(tmp_path.iterdir()) == []


def test_features_and_contacts_are_checked_at_once(morph: sm.Morph):
    with pytest.raises(RecipeError, match="normal has no length"):
        morph.feature(sm.half_space([0, 0, 0], [0, 0, 0]))
    with pytest.raises(RecipeError, match=r"contacts\[0\]"):
        morph.contact(("strip", [1]), ("strip", [9999]))
    assert {"features", "contacts"}.isdisjoint(morph.recipe)


def test_a_morph_has_the_verbs_of_the_workbench(morph: sm.Morph):
    other = sm.Morph([MESH]).add_fixed([0]).add_handle([5], "tip").add_feature([9, 10])
    other.set_motion("tip", [0, 0, 1], axis=[0, 1, 0], angle=3)
    assert other.recipe["pose"]["tip"]["rotation"] == {"axis": [0, 1, 0], "degrees": 3}
    assert other.recipe["fixed"][0]["vertices"] == [0] and len(other.recipe["features"]) == 1


def test_a_repr_names_three_parts():
    many = sm.Morph([PartMesh(POINTS, QUADS, name=name) for name in "abcde"])
    assert repr(many) == "<Morph of a, b, c, ...: nothing marked>"

# SPDX-License-Identifier: LGPL-2.1-or-later
"""What single formats have of their own: indices, polygons, welding, types."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

from part_samples import COFF, OBJ, OFF, PLY, STL, binary_ply, binary_stl, moved, vtk
from sheetmorph import FileError, PartMesh, read_part
from sheetmorph.base.polygons import triangulate


def part_of(folder: Path, name: str, data: bytes):
    """The part of a file with this content."""
    path = folder / name
    path.write_bytes(data)
    return read_part(path)


def test_obj_takes_negative_indices_and_joined_lines(tmp_path: Path):
    mesh = part_of(tmp_path, "a.obj", OBJ).mesh
    assert mesh.triangles.tolist() == [[0, 1, 3], [1, 2, 3], [0, 3, 4], [0, 3, 4]]
    assert mesh.points.tolist() == [[0, 0, 0], [1.5, 0, 0], [1.5, 1, 0.25], [0, 1, 0], [-1, 0, 0]]


def test_obj_negative_indices_count_from_where_they_stand(tmp_path: Path):
    text = b"v 0 0 0\nv 1 0 0\nv 0 1 0\nf -3 -2 -1\nv 5 0 0\nv 6 0 0\nv 5 1 0\nf -3 -2 -1\n"
    assert part_of(tmp_path, "a.obj", text).mesh.triangles.tolist() == [[0, 1, 2], [3, 4, 5]]


def test_obj_keeps_what_stands_behind_the_coordinates(tmp_path: Path):
    part = part_of(tmp_path, "a.obj", OBJ)
    positions = part.mesh.points + 0.125
    part.write(tmp_path / "b.obj", positions)
    lines = (tmp_path / "b.obj").read_bytes().split(b"\n")
    assert lines[4] == b"v 1.625 0.125 0.125 # behind a vertex"
    assert lines[5] == b"v  1.625   1.125   0.375   1.0"
    assert lines[6] == b"v 0.125 1.125 0.125 0.5 0.5 0.5"
    assert lines[8:] == OBJ.split(b"\n")[8:]


def test_a_comment_with_a_backslash_does_not_swallow_the_next_line(tmp_path: Path):
    text = b"# C:\\parts\\\nv 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n"
    assert len(part_of(tmp_path, "a.obj", text).mesh.points) == 3


def test_off_takes_counts_on_the_header_line_and_colours(tmp_path: Path):
    part = part_of(tmp_path, "a.off", COFF)
    assert part.mesh.points.tolist() == [[0, 0, 0], [2, 0, 0], [0, 2, 0.5]]
    part.write(tmp_path / "b.off", part.mesh.points + 1.0)
    assert b"3.0 1.0 1.0 0 1 0 1\n" in (tmp_path / "b.off").read_bytes()


def test_off_keeps_colours_behind_the_coordinates(tmp_path: Path):
    part = part_of(tmp_path, "a.off", OFF)
    part.write(tmp_path / "b.off", part.mesh.points + 1.0)
    assert b"2.5 1.0 1.0   255 0 0\n" in (tmp_path / "b.off").read_bytes()


def test_ply_finds_the_vertex_list_behind_other_properties(tmp_path: Path):
    mesh = part_of(tmp_path, "a.ply", PLY).mesh
    assert mesh.triangles.tolist() == [[0, 1, 2], [0, 2, 3]]


@pytest.mark.parametrize(("order", "kind"), [("<", "f4"), (">", "f4"), ("<", "f8"), (">", "f8")])
def test_binary_ply_keeps_its_types_and_all_other_bytes(order: str, kind: str, tmp_path: Path):
    data = binary_ply(order, kind)
    part = part_of(tmp_path, "a.ply", data)
    part.write(tmp_path / "b.ply", moved(part.mesh.points))
    after = (tmp_path / "b.ply").read_bytes()
    assert len(after) == len(data)
    assert after[: data.index(b"end_header")] == data[: data.index(b"end_header")]
    assert after[-26:] == data[-26:]
    assert part.precision == {"f4": "float32", "f8": "double"}[kind]


@pytest.mark.parametrize("data", [STL, binary_stl()])
def test_stl_is_welded_in_order_of_first_appearance(data: bytes, tmp_path: Path):
    mesh = part_of(tmp_path, "a.stl", data).mesh
    assert mesh.triangles[:2].tolist() == [[0, 1, 2], [0, 2, 3]]
    assert mesh.points[:2].tolist() == [[0, 0, 0], [1.5, 0, 0]]


def test_stl_gets_new_normals_for_the_facets_that_moved(tmp_path: Path):
    part = part_of(tmp_path, "a.stl", STL)
    positions = part.mesh.points.copy()
    positions[3, 2] = 1.0
    part.write(tmp_path / "b.stl", positions)
    lines = (tmp_path / "b.stl").read_text().split("\n")
    assert lines[1] == "  facet normal 0 0 1"
    normal = np.array(lines[8].split()[2:], dtype=float)
    corners = positions[part.mesh.triangles[1]]
    expected = np.cross(corners[1] - corners[0], corners[2] - corners[0])
    assert normal == pytest.approx(expected / np.linalg.norm(expected), abs=1e-15)


def test_binary_stl_keeps_header_and_attributes(tmp_path: Path):
    part = part_of(tmp_path, "a.stl", binary_stl())
    part.write(tmp_path / "b.stl", part.mesh.points @ np.diag([1.0, 1.0, -1.0]) + [0, 0, 2])
    after = (tmp_path / "b.stl").read_bytes()
    assert after[:84] == binary_stl()[:84]
    assert after[84 + 48 : 84 + 50] == b"M\0"


def test_vertices_that_rounding_brings_together_are_read_back(tmp_path: Path):
    part = part_of(tmp_path, "a.stl", binary_stl())
    positions = part.mesh.points.copy()
    positions[1] = positions[0] + [1e-300, 0, 0]
    part.write(tmp_path / "b.stl", positions)
    assert part.read_back_error(tmp_path / "b.stl", positions) < 1e-7


@pytest.mark.parametrize("is_binary", [False, True])
def test_vtk_stays_text_or_binary(is_binary: bool, tmp_path: Path):
    part = part_of(tmp_path, "a.vtk", vtk(is_binary))
    positions = moved(part.mesh.points)
    part.write(tmp_path / "b.vtk", positions)
    kind = b"\nBINARY\n" if is_binary else b"\nASCII\n"
    assert kind in (tmp_path / "b.vtk").read_bytes()
    assert np.array_equal(part.stored_positions(tmp_path / "b.vtk"), positions)
    assert any("meshio" in note for note in part.notes)


@pytest.mark.parametrize("kind", [np.float32, np.float64])
@pytest.mark.parametrize("is_binary", [False, True])
def test_vtu_goes_through_meshio_and_keeps_its_type(kind, is_binary: bool, tmp_path: Path):
    import meshio

    points = np.array([[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0]], dtype=kind)
    cells = [("quad", np.array([[0, 1, 2, 3]])), ("line", np.array([[0, 1]]))]
    data = {"thickness": np.arange(4.0)}
    path = tmp_path / "a.vtu"
    meshio.Mesh(points, cells, point_data=data).write(path, binary=is_binary)
    part = read_part(path)
    positions = moved(part.mesh.points)
    part.write(tmp_path / "b.vtu", positions)
    assert part.precision == {np.float32: "float32", np.float64: "double"}[kind]
    assert part.read_back_error(tmp_path / "b.vtu", positions) <= np.finfo(kind).eps * 2
    again = meshio.read(tmp_path / "b.vtu")
    assert np.array_equal(again.point_data["thickness"], data["thickness"])
    assert [block.type for block in again.cells] == ["quad", "line"]


def test_cells_with_mid_side_nodes_are_refused(tmp_path: Path):
    import meshio

    cells = [("triangle6", np.array([[0, 1, 2, 3, 4, 5]]))]
    meshio.Mesh(np.random.default_rng(0).random((6, 3)), cells).write(tmp_path / "a.vtu")
    with pytest.raises(FileError, match="triangle6 have mid-side nodes"):
        read_part(tmp_path / "a.vtu")


def test_a_quad_is_cut_along_its_shorter_diagonal_also_far_away():
    square = np.array([[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0]], dtype=float)
    slanted = square + [[0, 0, 0], [1, 0, 0], [1, 0, 0], [0, 0, 0]] * np.array([1, 1, 1])
    slanted[2, 0] += 1.0
    assert triangulate(square, [[0, 1, 2, 3]]).tolist() == [[0, 1, 2], [0, 2, 3]]
    assert triangulate(square + 3e5, [[0, 1, 2, 3]]).tolist() == [[0, 1, 2], [0, 2, 3]]
    assert triangulate(slanted, [[0, 1, 2, 3]]).tolist() == [[0, 1, 3], [1, 2, 3]]


def test_polygons_of_all_sizes_stay_in_order():
    points = np.random.default_rng(0).random((8, 3))
    faces = [[0, 1, 2, 3, 4], [5, 6, 7], [0, 1, 2]]
    expected = [[0, 1, 2], [0, 2, 3], [0, 3, 4], [5, 6, 7], [0, 1, 2]]
    assert triangulate(points, faces).tolist() == expected


@pytest.mark.parametrize(
    ("points", "triangles", "ids", "what"),
    [
        (np.zeros((3, 2)), [[0, 1, 2]], None, r"must be \(n, 3\)"),
        (np.zeros((3, 3)), [[0, 1]], None, r"must be \(m, 3\)"),
        (np.zeros((3, 3)), [[0, 1, 1.5]], None, "must be whole numbers"),
        (np.zeros((3, 3), dtype=complex), [[0, 1, 2]], None, "must be numbers"),
        (np.zeros((3, 3)), [[0, 1, 2**32]], None, r"outside 0 \.\. 2"),
        (np.zeros((3, 3)), [[0, 1, 3]], None, r"outside 0 \.\. 2"),
        (np.full((3, 3), np.nan), [[0, 1, 2]], None, "not a finite number"),
        (np.zeros((3, 3)), [[0, 1, 2]], [1, 2], "one per vertex"),
        (np.zeros((3, 3)), [[0, 1, 2]], [1, 2, 2], "same id"),
    ],
)
def test_a_part_mesh_refuses_arrays_that_make_no_mesh(points, triangles, ids, what: str):
    with pytest.raises(ValueError, match=what):
        PartMesh(points, np.array(triangles), ids)

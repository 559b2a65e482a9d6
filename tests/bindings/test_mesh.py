# SPDX-License-Identifier: LGPL-2.1-or-later
"""The mesh layer of sheetmorph._core: shapes, types and errors at the door."""

import threading

import numpy as np
import pytest

from sheetmorph import _core


def grid(columns, rows):
    """A flat grid of unit cells: points ((columns+1)(rows+1), 3), triangles (2 columns rows, 3)."""
    x, y = np.meshgrid(np.arange(columns + 1.0), np.arange(rows + 1.0))
    points = np.column_stack([x.ravel(), y.ravel(), np.zeros(x.size)])
    first = (np.arange(rows)[:, None] * (columns + 1) + np.arange(columns)).ravel()
    a, b, c, d = first, first + 1, first + columns + 2, first + columns + 1
    triangles = np.concatenate([np.column_stack([a, b, c]), np.column_stack([a, c, d])])
    return points, triangles.astype(np.int32)


def ring(count, inner, outer):
    """A flat ring whose first `count` vertices are its inner rim."""
    angles = 2 * np.pi * np.arange(count) / count
    circle = np.column_stack([np.cos(angles), np.sin(angles), np.zeros(count)])
    points = np.concatenate([inner * circle, outer * circle])
    i = np.arange(count)
    j = (i + 1) % count
    triangles = np.concatenate(
        [np.column_stack([i, i + count, j + count]), np.column_stack([i, j + count, j])]
    )
    return points, triangles.astype(np.int32)


@pytest.fixture
def sheet():
    return _core.TriangleMesh(*grid(4, 4))


def test_components_are_numbered_and_lone_vertices_are_minus_one():
    points, triangles = grid(1, 1)
    both = np.concatenate([points, [[9.0, 9.0, 9.0]], points + 20.0])
    mesh = _core.TriangleMesh(both, np.concatenate([triangles, triangles + 5]))
    labels = _core.components(mesh)
    assert labels.dtype == np.int32
    assert labels.tolist() == [0, 0, 0, 0, -1, 1, 1, 1, 1]


def test_boundary_loops_are_the_rims():
    mesh = _core.TriangleMesh(*ring(12, 5.0, 8.0))
    loops = _core.boundary_loops(mesh)
    assert [sorted(loop.tolist()) for loop in loops] == [list(range(12)), list(range(12, 24))]
    assert loops[0].dtype == np.int32
    assert _core.boundary_loop_at(mesh, 15).tolist() == loops[1].tolist()


def test_a_vertex_on_no_rim_is_refused_by_name(sheet):
    with pytest.raises(_core.InvalidInput, match="vertex 12"):
        _core.boundary_loop_at(sheet, 12)
    with pytest.raises(ValueError, match="vertex 25"):
        _core.boundary_loop_at(sheet, 25)


def test_rings_grow_and_shrink(sheet):
    grown = _core.grow_rings(sheet, [12], 1)
    assert set(grown) == {6, 7, 11, 12, 13, 17, 18}
    assert _core.shrink_rings(sheet, grown, 1).tolist() == [12]
    ids = np.array([12, 12], dtype=np.int64)
    assert _core.grow_rings(sheet, ids, 0).tolist() == [12]
    with pytest.raises(ValueError, match="77"):
        _core.grow_rings(sheet, [77], 1)
    with pytest.raises(TypeError):
        _core.grow_rings(sheet, np.array([1.0]), 1)


def test_growing_stops_at_a_crease():
    points, triangles = grid(4, 4)
    beyond = np.maximum(points[:, 0] - 2.0, 0.0)
    points[:, 0] -= beyond
    points[:, 2] = beyond
    mesh = _core.TriangleMesh(points, triangles)
    found = _core.grow_to_creases(mesh, 0, np.radians(30))
    assert found.size == 16
    assert set(_core.vertices_of_triangles(mesh, found)) == set(np.flatnonzero(points[:, 2] == 0))
    assert _core.grow_to_creases(mesh, 0, np.radians(91)).size == 32
    assert _core.connected_triangles(mesh, 3).size == 32


def test_triangles_with_all_vertices(sheet):
    assert _core.triangles_with_all_vertices(sheet, [0, 1, 6]).tolist() == [0]


def test_a_circle_is_found_exactly():
    points, _ = ring(12, 5.0, 8.0)
    fit = _core.fit_circle(points[:12] + [1e5, 0.0, 2e5])
    assert fit.radius == pytest.approx(5.0, abs=1e-10)
    assert np.allclose(fit.centre, [1e5, 0.0, 2e5], rtol=0, atol=1e-10)
    assert np.allclose(fit.axis, [0, 0, 1], rtol=0, atol=1e-11)
    assert fit.residual < 1e-10
    with pytest.raises(_core.InvalidInput, match="one line"):
        _core.fit_circle(np.outer(np.arange(5.0), [1.0, 2.0, 3.0]))
    with pytest.raises(_core.InvalidInput, match="at least 3"):
        _core.fit_circle(points[:2])


def test_round_holes_give_rim_and_circle():
    holes = _core.round_holes(_core.TriangleMesh(*ring(12, 5.0, 8.0)))
    assert [round(hole.circle.radius, 9) for hole in holes] == [5.0, 8.0]
    assert sorted(holes[0].rim) == list(range(12))
    assert _core.round_holes(_core.TriangleMesh(*grid(3, 3)), tolerance=0.01) == []


def test_quality_counts_degenerate_triangles():
    points, triangles = grid(2, 2)
    found = _core.quality(points, np.concatenate([triangles, [[0, 1, 2]]]).astype(np.int32))
    assert found.degenerate == 1
    assert found.worst_angle_degrees == pytest.approx(45.0)
    assert found.worst_aspect == pytest.approx(np.sqrt(3.0))


def test_quality_by_vertex_is_its_smallest_corner():
    points, triangles = grid(2, 2)
    found = _core.vertex_quality(points, triangles)
    assert found.shape == (len(points),)
    assert found == pytest.approx(np.full(len(points), 45.0))


def test_quality_compares_with_the_mesh_at_rest():
    points, triangles = grid(4, 4)
    upside_down = points * [1.0, -1.0, -1.0]
    assert _core.compare_quality(points, upside_down, triangles).flipped == 0
    folded = points.copy()
    folded[:, 0] = 2.0 - np.abs(points[:, 0] - 2.0)
    change = _core.compare_quality(points, 2.0 * folded, triangles)
    assert change.flipped == change.flipped_triangles.size == 8
    assert change.largest_stretch == pytest.approx(2.0)
    assert change.smallest_stretch == pytest.approx(2.0)
    assert change.degenerate == 0
    with pytest.raises(ValueError, match="points"):
        _core.compare_quality(points, points[:3], triangles)


def test_normals_are_of_length_one():
    points, triangles = grid(4, 4)
    normals = _core.vertex_normals(points, triangles)
    assert normals.shape == (25, 3)
    assert np.array_equal(normals, np.tile([0.0, 0.0, 1.0], (25, 1)))


def test_quads_and_polygons_are_split():
    points = np.array([[0, 0, 0], [4, 0, 0], [1, 1, 0], [0, 4, 0]], dtype=float)
    quads = np.array([[1, 2, 3, 0]], dtype=np.int32)
    split = _core.split_quads(points, quads)
    assert split.tolist() == [[2, 3, 0], [2, 0, 1]]
    assert _core.split_polygon(points, [0, 1, 2]).tolist() == [[0, 1, 2]]
    with pytest.raises(ValueError, match=r"\(q, 4\)"):
        _core.split_quads(points, quads[:, :3])
    with pytest.raises(_core.InvalidInput, match="outside"):
        _core.split_quads(points, quads + 1)


def test_picking_finds_the_first_triangle_and_follows_a_refit():
    points, triangles = grid(4, 4)
    tree = _core.PickingTree(points, triangles)
    hit = tree.nearest_hit([1.25, 1.5, 3.0], (0, 0, -2))
    assert hit.distance == pytest.approx(3.0)
    assert np.allclose(hit.point, [1.25, 1.5, 0.0])
    assert np.allclose(hit.barycentric @ points[triangles[hit.triangle]], hit.point)
    assert tree.nearest_hit([1.25, 1.5, 3.0], [0, 0, 1]) is None
    tree.refit(points + [0.0, 0.0, 1.0])
    assert tree.nearest_hit([1.25, 1.5, 3.0], [0, 0, -2]).distance == pytest.approx(2.0)
    assert tree.nearest_point([-3.0, 0.0, 1.0]).distance == pytest.approx(3.0)
    with pytest.raises(_core.InvalidInput, match="direction"):
        tree.nearest_hit([0, 0, 0], [0, 0, 0])


def test_an_empty_mesh_is_no_error():
    empty = np.zeros((0, 3)), np.zeros((0, 3), dtype=np.int32)
    mesh = _core.TriangleMesh(*empty)
    assert _core.boundary_loops(mesh) == []
    assert _core.components(mesh).size == 0
    assert _core.vertex_normals(*empty).shape == (0, 3)
    assert _core.PickingTree(*empty).nearest_point([0, 0, 0]) is None


@pytest.mark.parametrize("points", [np.zeros((3, 3), dtype=np.float32), [[0.0, 0.0, 0.0]]])
def test_points_of_another_type_are_refused(points):
    with pytest.raises(TypeError, match="points"):
        _core.fit_circle(points)


def test_points_of_another_shape_are_refused():
    with pytest.raises(ValueError, match=r"\(n, 3\)"):
        _core.fit_circle(np.zeros((4, 2)))


def test_trees_are_built_while_other_threads_run():
    points, triangles = grid(100, 100)
    trees = []
    threads = [
        threading.Thread(target=lambda: trees.append(_core.PickingTree(points, triangles)))
        for _ in range(4)
    ]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    hits = {tree.nearest_hit([50.3, 50.6, 5.0], [0, 0, -1]).triangle for tree in trees}
    assert len(trees) == 4
    assert len(hits) == 1

# SPDX-License-Identifier: LGPL-2.1-or-later
"""Meshes keep every bit, and coordinates are what a user sees."""

import unittest

import FreeCAD
import Mesh
import numpy as np

from freecad.sheetmorph.bridge import conversion
from freecad.sheetmorph.tests import support

AWKWARD = np.array([[0, 1, 2], [0, 1, 2], [1, 1, 3], [1, 0, 3], [0, 1, 4]], np.int32)
"""Double, degenerate, and three triangles on one edge; vertices 5 and 6 are unused."""


def awkward_points() -> np.ndarray:
    return np.random.default_rng(1).uniform(-1e3, 1e3, (7, 3)).astype(np.float32)


class TestMeshes(support.DocumentTest):
    def test_points_and_triangles_come_back_bit_for_bit(self):
        points, triangles = support.strip()
        mesh = conversion.MeshWriter(triangles).mesh(points)
        read_points, read_triangles = conversion.read_mesh(mesh)
        np.testing.assert_array_equal(read_points, points.astype(np.float32))
        np.testing.assert_array_equal(read_triangles, triangles)

    def test_bad_triangles_and_unused_vertices_are_kept_in_order(self):
        mesh = conversion.MeshWriter(AWKWARD).mesh(awkward_points())
        read_points, read_triangles = conversion.read_mesh(mesh)
        np.testing.assert_array_equal(read_points, awkward_points())
        np.testing.assert_array_equal(read_triangles, AWKWARD)

    def test_bad_triangles_survive_saving_and_opening(self):
        self.add_source(mesh=(awkward_points(), AWKWARD))
        opened = self.reopen(self.document)
        read_points, read_triangles = conversion.read_mesh(opened.Objects[0].Mesh)
        np.testing.assert_array_equal(read_points, awkward_points())
        np.testing.assert_array_equal(read_triangles, AWKWARD)

    def test_neighbours_are_those_that_freecad_finds(self):
        points, triangles = support.strip()
        vectors = [FreeCAD.Vector(*p) for p in points]
        expected = Mesh.Mesh()
        for corners in triangles:
            expected.addFacet(*(vectors[k] for k in corners))
        ours = conversion.MeshWriter(triangles).mesh(points)
        for mine, theirs in zip(ours.Facets, expected.Facets):
            self.assertEqual(sorted(mine.NeighbourIndices), sorted(theirs.NeighbourIndices))

    def test_a_mesh_is_read_without_its_placement(self):
        points, triangles = support.strip()
        moved = support.placement((5, 6, 7), (1, 2, 3), 40)
        mesh = conversion.MeshWriter(triangles).mesh(points, moved)
        found = support.matrix(mesh.Placement)
        self.assertLess(support.largest(found - support.matrix(moved)), 1e-12)
        np.testing.assert_array_equal(conversion.read_mesh(mesh)[0], points.astype(np.float32))

    def test_an_empty_mesh_has_no_triangles(self):
        points, triangles = conversion.read_mesh(Mesh.Mesh())
        self.assertEqual((points.shape, triangles.shape), ((0, 3), (0, 3)))


class TestFrames(support.DocumentTest):
    def test_global_coordinates_are_those_freecad_shows(self):
        source = self.add_source()
        source.Placement = support.placement((10, -20, 30), (1, 1, 0), 50)
        shown = np.array([tuple(p.Vector) for p in source.Mesh.Points])
        self.assertLess(support.largest(support.seen_points(source) - shown), 1e-4)

    def test_local_undoes_global(self):
        source = self.add_source()
        source.Placement = support.placement((1e4, -2e4, 3e4), (1, -1, 2), 123)
        frame = conversion.frame_of(source, support.ORIGIN)
        points = np.random.default_rng(2).normal(size=(50, 3)) * 100.0
        self.assertLess(support.largest(frame.to_local(frame.to_global(points)) - points), 1e-10)

    def test_an_unmoved_part_far_away_keeps_every_bit(self):
        points = np.random.default_rng(3).normal(size=(50, 3)) + (1e5, 2e5, -3e5)
        origin = conversion.near_origin(points)
        source = self.add_source()
        source.Placement = conversion.shift(origin)
        frame = conversion.frame_of(source, origin)
        np.testing.assert_array_equal(frame.to_global(points), points)
        self.assertLess(support.largest(frame.to_local(points)), 10.0)

    def test_a_part_near_zero_stays_where_it_is(self):
        points, _ = support.strip()
        np.testing.assert_array_equal(conversion.near_origin(points), np.zeros(3))

    def test_containers_are_counted_in(self):
        source = self.add_source()
        outer = self.document.addObject("App::Part", "Outer")
        inner = self.document.addObject("App::Part", "Inner")
        outer.addObject(inner)
        inner.addObject(source)
        outer.Placement = support.placement((0, 0, 100))
        inner.Placement = support.placement((0, 0, 0), (0, 0, 1), 90)
        source.Placement = support.placement((1, 0, 0))
        frame = conversion.frame_of(source, support.ORIGIN)
        found = frame.to_global(np.zeros((1, 3)))
        self.assertLess(support.largest(found - (0.0, 1.0, 100.0)), 1e-12)
        found = support.matrix(conversion.container_placement(source))
        expected = support.matrix(outer.Placement) @ support.matrix(inner.Placement)
        self.assertLess(support.largest(found - expected), 1e-12)


if __name__ == "__main__":
    unittest.main()

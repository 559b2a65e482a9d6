# SPDX-License-Identifier: LGPL-2.1-or-later
"""What cannot be computed is said once, in one sentence, and the last mesh stays."""

import unittest
from unittest import mock

import numpy as np

from freecad.sheetmorph import api
from freecad.sheetmorph.bridge import conversion, kernel
from freecad.sheetmorph.objects import deformation_of, model
from freecad.sheetmorph.tests import support


class TestFailures(support.DocumentTest):
    def setUp(self):
        super().setUp()
        self.assembly, self.part, self.handle = self.add_morph()
        api.set_motion(self.handle, (0, 0, 10))
        self.document.recompute()
        self.before = support.local_points(self.part)

    def assert_fails(self, *words: str) -> None:
        """Recompute; the morph names the reason, its part keeps its mesh and stays due."""
        self.document.recompute()
        self.assertIn("Touched", self.part.State)
        message = model.failure_of(self.assembly)
        for word in words:
            self.assertIn(word, message)
        self.assertNotIn("\n", message)
        self.assertNotIn("Traceback", message)
        self.assertEqual(self.assembly.Status, message)
        np.testing.assert_array_equal(support.local_points(self.part), self.before)

    def assert_recovers(self) -> None:
        self.document.recompute()
        self.assert_up_to_date(self.document)
        np.testing.assert_array_equal(support.local_points(self.part), self.before)

    def test_a_zero_axis(self):
        self.handle.Axis = (0, 0, 0)
        self.handle.Angle = 10
        self.assert_fails("Tip", "axis")
        api.set_motion(self.handle, axis=(0, 0, 1), angle=0)
        self.assert_recovers()

    def test_a_region_without_vertices(self):
        kept = api.vertices(self.handle)
        self.handle.Vertices = []
        self.assert_fails("Tip")
        api.set_vertices(self.handle, kept)
        self.assert_recovers()

    def test_a_source_that_lost_vertices(self):
        source, mesh = self.part.Source, self.part.Source.Mesh.copy()
        points, triangles = support.strip(11, 6)
        source.Mesh = conversion.MeshWriter(triangles).mesh(points)
        self.assert_fails("vertex", "no longer in part 'Strip'", "pick")
        source.Mesh = mesh
        self.assert_recovers()

    def test_an_emptied_source(self):
        source, mesh = self.part.Source, self.part.Source.Mesh.copy()
        source.Mesh = conversion.Mesh.Mesh()
        self.assert_fails("'Sheet'", "'Strip'", "no triangles")
        source.Mesh = mesh
        self.assert_recovers()

    def test_regions_that_contradict_each_other(self):
        clamp = self.document.getObjectsByLabel("Clamp")[0]
        both = api.vertices(self.handle)[:4] + api.vertices(clamp)[:4]
        other = api.add_feature(self.assembly, self.part, both, "Rigid bar")
        self.assert_fails("Rigid bar")
        api.remove(other)
        self.assert_recovers()

    def test_what_is_wrong_is_worked_out_once_until_something_changes(self):
        clamp = self.document.getObjectsByLabel("Clamp")[0]
        both = api.vertices(self.handle)[:4] + api.vertices(clamp)[:4]
        other = api.add_feature(self.assembly, self.part, both, "Rigid bar")
        package = kernel.load()
        with mock.patch.object(package, "Session", wraps=package.Session) as built:
            self.assert_fails("Rigid bar")
            api.set_motion(self.handle, (0, 0, 12))
            self.assert_fails("Rigid bar")
            self.assertEqual(built.call_count, 1)
            api.set_vertices(other, both[1:])
            self.assert_fails("Rigid bar")
            self.assertEqual(built.call_count, 2)

    def test_a_component_that_nothing_holds(self):
        api.set_unheld(self.assembly, "refuse")
        points, triangles = support.strip()
        double = np.concatenate([points, points + (0, 0, 50)])
        source = self.part.Source
        mesh = source.Mesh.copy()
        source.Mesh = conversion.MeshWriter(
            np.concatenate([triangles, triangles + len(points)])
        ).mesh(double)
        self.assert_fails("Strip")
        source.Mesh = mesh
        self.assert_recovers()

    def test_a_lost_deformation_is_named(self):
        self.document.removeObject(deformation_of(self.assembly).Name)
        self.document.recompute()
        self.assertIn("not in a morph", self.part.getStatusString())
        with self.assertRaisesRegex(ValueError, "'Deformation'"):
            api.add_fixed(self.assembly, self.part, [1])
        self.assertEqual(model.kind(self.assembly), model.ASSEMBLY)

    def test_a_mesh_edited_by_the_user_is_taken_as_it_is_now(self):
        source = self.part.Source
        edited = source.Mesh.copy()
        edited.translate(0, 0, 5)
        source.Mesh = edited
        self.document.recompute()
        self.assert_up_to_date(self.document)
        difference = support.local_points(self.part) - self.before
        self.assertLess(support.largest(difference - (0, 0, 5)), 1e-4)


if __name__ == "__main__":
    unittest.main()

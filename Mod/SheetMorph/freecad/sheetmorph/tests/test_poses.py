# SPDX-License-Identifier: LGPL-2.1-or-later
"""Poses are kept by name, come back exactly, are blended, compared and copied as meshes."""

import json
import os
import unittest

import FreeCAD
import numpy as np

from freecad.sheetmorph import api
from freecad.sheetmorph.objects import model
from freecad.sheetmorph.tests import support


class TestPoses(support.DocumentTest):
    def setUp(self):
        super().setUp()
        self.source = self.add_source()
        self.source.Placement = support.placement((500, -40, 70), (1, 2, 3), 75)
        self.assembly, self.part, self.handle = self.add_morph(self.source)
        api.set_motion(self.handle, (0, 0, 40), (0, 1, 0), -30)
        self.high = api.save_pose(self.assembly, "High")
        api.set_motion(self.handle, (10, 0, 0), (0, 1, 0), 90, pivot=(300, 50, 0))
        self.turned = api.save_pose(self.assembly, "Turned")
        self.document.recompute()

    def mesh(self) -> np.ndarray:
        self.document.recompute()
        return support.local_points(self.part)

    def test_a_pose_comes_back_to_the_bit(self):
        seen = self.mesh()
        api.reset_motion(self.handle)
        self.assertGreater(support.largest(self.mesh() - seen), 10.0)
        api.apply_pose(self.turned)
        np.testing.assert_array_equal(self.mesh(), seen)
        api.apply_pose(self.high)
        self.assertTrue(self.handle.PivotAtCentroid)
        self.assertEqual(self.handle.Angle.Value, -30.0)

    def test_they_are_saved_with_the_document(self):
        seen = self.mesh()
        document = self.reopen(self.document)
        assembly = next(o for o in document.Objects if model.kind(o) == model.ASSEMBLY)
        high, turned = api.poses(assembly)
        self.assertEqual((high.Label, turned.Label), ("High", "Turned"))
        api.apply_pose(high)
        api.apply_pose(turned)
        document.recompute()
        again = support.local_points(model.parts(assembly)[0])
        np.testing.assert_allclose(again, seen, atol=1e-4)  # the placement is saved as text

    def test_a_blend_is_between_and_its_ends_are_the_poses(self):
        api.blend_poses(None, self.high, 0.25)
        self.assertAlmostEqual(self.handle.TranslationZ.Value, 10.0)
        self.assertAlmostEqual(self.handle.Angle.Value, -7.5)
        api.blend_poses(self.high, self.turned, 1.0)
        self.assertEqual(self.handle.Angle.Value, 90.0)
        self.assertEqual(tuple(self.handle.Pivot), (300, 50, 0))
        api.blend_poses(self.high, self.turned, 0.5)
        self.assertAlmostEqual(self.handle.Angle.Value, 30.0)
        self.assertFalse(self.handle.PivotAtCentroid)

    def test_comparing_changes_nothing(self):
        before = self.mesh()
        largest, mean = api.compare_poses(None, self.high)[self.part.Name]
        self.assertEqual(self.handle.Angle.Value, 90.0)
        np.testing.assert_array_equal(self.mesh(), before)
        api.apply_pose(self.high)
        found = api.deform(self.assembly)[self.part.Name]
        gap = np.linalg.norm(found - api.rest_mesh(self.part)[0], axis=1)
        self.assertAlmostEqual(largest, gap.max(), places=9)
        self.assertAlmostEqual(mean, gap.mean(), places=9)
        self.assertEqual(api.compare_poses(self.high, self.high)[self.part.Name], (0.0, 0.0))

    def test_a_copy_is_ordinary_meshes_that_stay(self):
        group = api.copy_as_meshes(self.assembly, self.high)
        api.apply_pose(self.high)
        self.mesh()
        (copy,) = group.Group
        self.assertEqual(copy.TypeId, "Mesh::Feature")
        gap = support.seen_points(copy) - support.seen_points(self.part)
        self.assertLess(support.largest(gap), 1e-3)
        kept = support.seen_points(copy)
        api.reset_motion(self.handle)
        self.mesh()
        np.testing.assert_array_equal(support.seen_points(copy), kept)
        present = api.copy_as_meshes(self.assembly).Group[0]
        self.assertGreater(support.largest(support.seen_points(present) - kept), 10.0)

    def test_prescribed_rotations_belong_to_a_pose(self):
        feature = api.add_feature(self.assembly, self.part, api.hole_rims(self.part)[0])
        api.set_rotation(feature, ((0, 0, 1), 20))
        twisted = api.save_pose(self.assembly, "Twisted")
        api.set_rotation(feature, ((0, 0, 1), 0))
        api.blend_poses(self.turned, twisted, 0.5)
        self.assertAlmostEqual(feature.RotationAngle.Value, 10.0)

    def test_a_region_that_is_gone_is_left_out_and_a_new_one_is_at_rest(self):
        new = api.add_handle(self.assembly, self.part, [150], "New")
        api.set_motion(new, (1, 2, 3))
        api.remove(self.handle)
        api.apply_pose(self.high)
        self.assertEqual(new.TranslationX.Value, 0.0)

    def test_what_is_no_pose_is_refused_in_words(self):
        for wrong, text in (((None, None), "None"), ((self.part, None), "not a SheetMorph pose")):
            with self.assertRaisesRegex(ValueError, text):
                api.blend_poses(*wrong, 0.5)
        other = api.create_assembly(self.document)
        with self.assertRaisesRegex(ValueError, "not a pose of"):
            api.copy_as_meshes(other, self.high)
        with self.assertRaisesRegex(ValueError, "one assembly"):
            api.blend_poses(self.high, api.save_pose(other), 0.5)

    def test_they_undo_and_go_with_their_assembly(self):
        self.document.openTransaction("Save Pose")
        api.save_pose(self.assembly, "Third")
        self.document.commitTransaction()
        self.document.undo()
        self.assertEqual(api.poses(self.assembly), [self.high, self.turned])
        api.remove(self.assembly)
        left = [o.Label for o in self.document.Objects if model.kind(o)]
        self.assertEqual(left, [])
        self.assertIsNotNone(FreeCAD.getDocument(self.document.Name))

    def test_a_copy_has_poses_of_its_own(self):
        seen = self.mesh()
        twin = api.copy_in_pose(self.high, "Twin")
        self.document.recompute()
        self.assert_up_to_date(self.document)
        self.assertEqual(twin.Label, "Twin")
        (grip,) = [r for r in model.regions(twin) if r.Role == "handle"]
        self.assertEqual((grip.TranslationZ.Value, grip.Angle.Value), (40.0, -30.0))
        np.testing.assert_array_equal(self.mesh(), seen)
        api.apply_pose(api.poses(twin)[1])
        self.assertEqual(grip.Angle.Value, 90.0)
        self.assertEqual(self.handle.Angle.Value, 90.0)

    def test_a_deleted_region_leaves_the_others_their_motions(self):
        other = api.add_handle(self.assembly, self.part, api.hole_rims(self.part)[1], "Aaa")
        api.set_motion(other, (0, 7, 0))
        pose = api.save_pose(self.assembly, "Both")
        api.remove(other)
        api.reset_motion(self.handle)
        api.apply_pose(pose)
        self.assertEqual(self.handle.Angle.Value, 90.0)

    def test_poses_go_with_a_recipe_and_come_back(self):
        path = api.export_recipe(self.assembly, os.path.join(self.folder, "posed.json"))
        with open(path, encoding="utf-8") as file:
            written = json.load(file)["poses"]
        self.assertEqual(written["High"]["Tip"]["translation"], [0.0, 0.0, 40.0])
        assembly = api.import_recipe(self.new_document(), path)
        high, turned = api.poses(assembly)
        self.assertEqual((high.Label, turned.Label), ("High", "Turned"))
        api.apply_pose(turned)
        found = list(api.deform(assembly).values())[0]
        api.apply_pose(self.turned)
        np.testing.assert_allclose(found, list(api.deform(self.assembly).values())[0], atol=1e-9)


if __name__ == "__main__":
    unittest.main()

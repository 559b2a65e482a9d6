# SPDX-License-Identifier: LGPL-2.1-or-later
"""Morphs in documents: saved, opened, copied, renamed, several of them."""

import os
import shutil
import unittest

import FreeCAD
import numpy as np

from freecad.sheetmorph import api, objects
from freecad.sheetmorph.bridge import recipes, solving
from freecad.sheetmorph.objects import model
from freecad.sheetmorph.tests import support


class TestSaving(support.DocumentTest):
    def test_everything_is_there_after_opening(self):
        assembly, part, handle = self.add_morph()
        rim = api.hole_rims(part)[0]
        hole = api.add_feature(assembly, part, rim, "Hole", rotation=((0, 1, 0), 5))
        api.set_motion(handle, (1, 2, 30), (0, 1, 0), 400, pivot=(300, 50, 0))
        api.set_energy(assembly, "paper")
        self.document.recompute()
        before, pose = support.local_points(part), recipes.pose_of(assembly)
        names = [assembly.Name, part.Name, hole.Name]
        opened = self.reopen(self.document)
        assembly, part, hole = (opened.getObject(name) for name in names)
        self.assertEqual(assembly.Energy, "paper")
        self.assertEqual(recipes.pose_of(assembly), pose)
        self.assertEqual(api.vertices(hole), rim)
        np.testing.assert_array_equal(support.local_points(part), before)
        self.assertEqual([model.kind(o) != "" for o in assembly.Group], [True] * 5)

    def test_a_saved_document_opens_up_to_date_and_recomputes_to_the_same(self):
        _, part, handle = self.add_morph()
        api.set_motion(handle, (1, 2, 30))
        self.document.recompute()
        before = support.local_points(part)
        opened = self.reopen(self.document)
        self.assert_up_to_date(opened)
        part = opened.getObject("Part")
        part.touch()
        opened.recompute()
        np.testing.assert_array_equal(support.local_points(part), before)

    def test_work_goes_on_after_opening(self):
        self.add_morph()
        opened = self.reopen(self.document)
        assembly, part = opened.getObject("Morph"), opened.getObject("Part")
        handle = opened.getObjectsByLabel("Tip")[0]
        api.set_motion(handle, (0, 0, 30))
        api.add_fixed(assembly, part, api.hole_rims(part)[1], "Rim")
        opened.recompute()
        self.assert_up_to_date(opened)
        self.assertGreater(support.largest(support.seen_points(part)[:, 2]), 29.9)
        api.remove(handle)
        opened.recompute()
        self.assertEqual(support.largest(support.seen_points(part)[:, 2]), 0.0)

    def test_a_document_moved_elsewhere_still_has_the_doubles_of_its_files(self):
        points, triangles = support.strip()
        path = os.path.join(self.folder, "strip.obj")
        support.write_obj(path, points + (1e5 + 1 / 3, 0.1, 0.7), triangles)
        assembly = api.create_assembly(self.document)
        api.import_part(assembly, path)
        expected, _ = api.rest_mesh(assembly.Primary)
        first = os.path.join(self.folder, "first.FCStd")
        self.document.saveAs(first)
        FreeCAD.closeDocument(self.document.Name)
        second = os.path.join(self.folder, "elsewhere")
        os.mkdir(second)
        shutil.move(first, second)
        os.remove(path)
        opened = self.open(os.path.join(second, "first.FCStd"))
        found, _ = api.rest_mesh(opened.getObject("Part"))
        np.testing.assert_array_equal(found, expected)
        np.testing.assert_array_equal(found, points + (1e5 + 1 / 3, 0.1, 0.7))


class TestSeveral(support.DocumentTest):
    def test_two_assemblies_in_one_document_do_not_disturb_each_other(self):
        first, part, handle = self.add_morph()
        second, other, grip = self.add_morph()
        api.set_motion(handle, (0, 0, 30))
        self.document.recompute()
        self.assert_up_to_date(self.document)
        self.assertGreater(support.largest(support.seen_points(part)[:, 2]), 29.9)
        self.assertEqual(support.largest(support.seen_points(other)[:, 2]), 0.0)
        api.remove(first)
        api.set_motion(grip, (0, 0, 10))
        self.document.recompute()
        self.assert_up_to_date(self.document)
        self.assertEqual(objects.assembly_of(other), second)

    def test_one_source_may_be_in_two_assemblies(self):
        _, part, handle = self.add_morph()
        _, other, grip = self.add_morph(part.Source)
        api.set_motion(handle, (0, 0, 30))
        api.set_motion(grip, (0, 0, -30))
        self.document.recompute()
        self.assert_up_to_date(self.document)
        self.assertGreater(
            support.largest(support.seen_points(part) - support.seen_points(other)), 59
        )

    def test_a_morphed_part_may_be_the_source_of_another_morph(self):
        _, part, handle = self.add_morph()
        api.set_motion(handle, (0, 0, 30))
        self.document.recompute()
        _, further, grip = self.add_morph(part)
        api.set_motion(grip, (0, 0, 12))
        self.document.recompute()
        self.assert_up_to_date(self.document)
        self.assertAlmostEqual(support.largest(support.seen_points(further)[:, 2]), 42.0, 4)

    def test_two_documents(self):
        other = self.new_document()
        _, part, handle = self.add_morph()
        _, twin, grip = self.add_morph(self.add_source(document=other))
        api.set_motion(handle, (0, 0, 30))
        api.set_motion(grip, (0, 0, 10))
        for document in (self.document, other):
            document.recompute()
            self.assert_up_to_date(document)
        self.assertAlmostEqual(support.largest(support.seen_points(part)[:, 2]), 30.0, 4)
        self.assertAlmostEqual(support.largest(support.seen_points(twin)[:, 2]), 10.0, 4)
        with self.assertRaisesRegex(ValueError, "not in the morph"):
            api.add_fixed(objects.assembly_of(part), twin, [1])

    def test_two_parts_in_one_assembly_have_regions_of_their_own(self):
        assembly, part, handle = self.add_morph()
        other = api.add_part(assembly, self.add_source("Plate"), "Second")
        api.add_fixed(assembly, other, [0, 1, 2])
        self.assertEqual(len(objects.regions(assembly, part)), 2)
        self.assertEqual(len(objects.regions(assembly, other)), 1)
        self.assertEqual(assembly.Primary, part)
        api.set_primary(assembly, other)
        self.assertEqual(solving.read_morph(assembly).recipe["primary"], "Second")

    def test_a_part_that_nothing_reaches_stays_at_rest_and_is_named(self):
        assembly, part, handle = self.add_morph()
        lonely = api.add_part(assembly, self.add_source("Plate"), "Lonely")
        api.set_motion(handle, (0, 0, 30))
        self.document.recompute()
        self.assert_up_to_date(self.document)
        self.assertIn("Lonely", assembly.Status)
        self.assertEqual(support.largest(support.seen_points(lonely)[:, 2]), 0.0)
        self.assertAlmostEqual(support.largest(support.seen_points(part)[:, 2]), 30.0, 4)


class TestCopyingAndNames(support.DocumentTest):
    def test_a_copied_assembly_lives_on_its_own(self):
        assembly, part, handle = self.add_morph()
        api.set_motion(handle, (0, 0, 30))
        self.document.recompute()
        copied = self.document.copyObject(assembly, True)
        self.document.recompute()
        self.assert_up_to_date(self.document)
        twin = objects.parts(copied)[0]
        self.assertNotEqual(twin, part)
        self.assertEqual([r.Part for r in objects.regions(copied)], [twin, twin])
        np.testing.assert_array_equal(support.seen_points(twin), support.seen_points(part))
        grip = [r for r in objects.regions(copied) if r.Role == "handle"][0]
        api.set_motion(grip, (0, 0, -5))
        self.document.recompute()
        self.assertAlmostEqual(support.largest(support.seen_points(part)[:, 2]), 30.0, 4)
        self.assertAlmostEqual(support.largest(support.seen_points(twin)[:, 2]), 5.0, 4)

    def test_a_copy_into_another_document_lives_on_its_own(self):
        assembly, _, handle = self.add_morph()
        api.set_motion(handle, (0, 0, 30))
        self.document.recompute()
        other = self.new_document()
        copied = other.copyObject(assembly, True)
        other.recompute()
        self.assert_up_to_date(other)
        found = support.seen_points(objects.parts(copied)[0])
        self.assertAlmostEqual(support.largest(found[:, 2]), 30.0, 4)

    def test_what_is_pasted_without_its_morph_says_so(self):
        """Regions, contacts, relations, poses and studies: each alone, or all of them."""
        assembly, _, handle = self.add_morph()
        pose = api.save_pose(assembly, "High")
        parameters = [("lift", handle, "TranslationZ", 0.0, 20.0)]
        study = api.add_study(assembly, parameters=parameters, count=5)
        region = objects.regions(assembly)[0]
        for alone in (region, handle, pose, study):
            other = self.new_document()
            copied = other.copyObject(alone, False)
            other.recompute()
            self.assertIn("Invalid", copied.State, copied.Label)
            said = copied.getStatusString()
            self.assertIn(f"'{copied.Label}'", said)
            self.assertIn("delete it", said)
        came = other.copyObject(assembly, True)
        other.removeObject(copied.Name)
        other.recompute()
        self.assert_up_to_date(other)
        outside = objects.regions(came)[0]
        came.removeObject(outside)
        outside.touch()
        other.recompute()
        self.assertIn("drag it onto its morph", outside.getStatusString())
        came.addObject(outside)
        outside.touch()
        other.recompute()
        self.assertNotIn("Invalid", outside.State)

    def test_renamed_parts_and_regions_go_on_working(self):
        _, part, handle = self.add_morph()
        part.Label, handle.Label = "Tür außen", "Griff (links)"
        api.set_motion(handle, (0, 0, 30))
        self.document.recompute()
        self.assert_up_to_date(self.document)
        self.assertAlmostEqual(support.largest(support.seen_points(part)[:, 2]), 30.0, 4)

    def test_equal_labels_become_different_names_in_a_recipe(self):
        preferences = FreeCAD.ParamGet("User parameter:BaseApp/Preferences/Document")
        allowed = preferences.GetBool("DuplicateLabels", False)
        self.addCleanup(preferences.SetBool, "DuplicateLabels", allowed)
        preferences.SetBool("DuplicateLabels", True)
        assembly, _, handle = self.add_morph()
        for region in objects.regions(assembly):
            region.Label = "Edge"
        names = recipes.names_of(assembly)
        self.assertEqual(len(set(names.values())), len(names))
        api.set_motion(handle, (0, 0, 30))
        self.document.recompute()
        self.assert_up_to_date(self.document)


if __name__ == "__main__":
    unittest.main()

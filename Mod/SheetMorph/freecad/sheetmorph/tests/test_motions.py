# SPDX-License-Identifier: LGPL-2.1-or-later
"""Handles and form features move the parts; expressions and cells move the handles."""

import unittest

import FreeCAD
import numpy as np

from freecad.sheetmorph import api
from freecad.sheetmorph.bridge import conversion
from freecad.sheetmorph.tests import support


class MotionTest(support.DocumentTest):
    def setUp(self):
        super().setUp()
        self.assembly, self.part, self.handle = self.add_morph()
        self.rest, _ = api.rest_mesh(self.part)
        self.tip = support.right_edge(self.rest)

    def recomputed(self) -> np.ndarray:
        self.document.recompute()
        self.assert_up_to_date(self.document)
        return support.seen_points(self.part)


class TestHandles(MotionTest):
    def test_a_translation_moves_the_handle_and_bends_the_sheet(self):
        api.set_motion(self.handle, translation=(1, 2, 30))
        seen = self.recomputed()
        np.testing.assert_allclose(
            seen[self.tip] - self.rest[self.tip], [[1, 2, 30]] * len(self.tip), atol=1e-4
        )
        middle = np.abs(self.rest[:, 0] - 150.0) < 40.0
        self.assertTrue(np.all(seen[middle, 2] > 0.5) and np.all(seen[middle, 2] < 29.5))
        clamp = support.left_edge(self.rest)
        np.testing.assert_array_equal(seen[clamp], self.rest[clamp])

    def test_a_rotation_turns_about_the_centroid_or_the_pivot(self):
        for pivot in (None, (300.0, 0.0, 0.0)):
            with self.subTest(pivot=pivot):
                api.set_motion(self.handle, axis=(0, 0, 2), angle=90, pivot=pivot)
                seen = self.recomputed()
                centre = self.rest[self.tip].mean(axis=0) if pivot is None else np.array(pivot)
                arm = self.rest[self.tip] - centre
                turned = np.stack([-arm[:, 1], arm[:, 0], arm[:, 2]], axis=1) + centre
                np.testing.assert_allclose(seen[self.tip], turned, atol=1e-4)

    def test_what_is_left_out_stays(self):
        api.set_motion(self.handle, (1, 2, 3), (0, 1, 0), 400, pivot=(5, 6, 7))
        api.set_motion(self.handle, angle=-20)
        self.assertEqual(self.handle.TranslationY.Value, 2.0)
        self.assertEqual(tuple(self.handle.Axis), (0.0, 1.0, 0.0))
        self.assertEqual(self.handle.Angle.Value, -20.0)
        self.assertEqual(tuple(api.pivot(self.handle)), (5.0, 6.0, 7.0))

    def test_reset_brings_back_the_rest_bit_for_bit(self):
        rest = self.recomputed()
        api.set_motion(self.handle, (1, 2, 30), (1, 1, 0), 25, pivot=(0, 0, 9))
        self.recomputed()
        api.reset_motion(self.handle)
        np.testing.assert_array_equal(self.recomputed(), rest)
        np.testing.assert_array_equal(rest, support.seen_points(self.part.Source))

    def test_results_depend_on_the_pose_not_on_the_way_to_it(self):
        api.set_motion(self.handle, (0, 0, 30))
        straight = self.recomputed()
        for height in (5, 80, -20, 30):
            api.set_motion(self.handle, (0, 0, height))
            seen = self.recomputed()
        np.testing.assert_array_equal(seen, straight)

    def test_the_source_is_never_changed(self):
        before = conversion.read_mesh(self.part.Source.Mesh)[0].copy()
        api.set_motion(self.handle, (0, 0, 30))
        self.recomputed()
        np.testing.assert_array_equal(conversion.read_mesh(self.part.Source.Mesh)[0], before)
        self.assertEqual(self.part.Source.State, ["Up-to-date"])

    def test_bad_motions_are_refused_and_change_nothing(self):
        api.set_motion(self.handle, (1, 2, 3))
        for arguments, words in (
            ({"translation": (1, 2)}, "three finite numbers"),
            ({"translation": (1, 2, float("nan"))}, "three finite numbers"),
            ({"translation": (9, 9, 9), "axis": (0, 0, 0)}, "axis is zero"),
            ({"translation": (9, 9, 9), "angle": float("inf")}, "finite"),
            ({"translation": (9, 9, 9), "pivot": "corner"}, "pivot 'corner' is unknown"),
        ):
            with self.subTest(words), self.assertRaisesRegex(ValueError, words):
                api.set_motion(self.handle, **arguments)
        self.assertEqual(self.handle.TranslationX.Value, 1.0)
        with self.assertRaisesRegex(ValueError, "not .handle"):
            api.set_motion(self.document.getObjectsByLabel("Clamp")[0], (0, 0, 1))


class TestFeatures(MotionTest):
    def setUp(self):
        super().setUp()
        self.rim = api.hole_rims(self.part)[1]
        self.hole = api.add_feature(self.assembly, self.part, self.rim, "Hole")

    def assert_rigid(self, seen: np.ndarray, tolerance: float = 1e-4) -> None:
        def distances(points):
            return np.linalg.norm(points[self.rim][:, None] - points[self.rim][None], axis=2)

        self.assertLess(support.largest(distances(seen) - distances(self.rest)), tolerance)

    def test_a_feature_keeps_its_shape(self):
        api.set_motion(self.handle, (0, 0, 60), (0, 1, 0), -30)
        seen = self.recomputed()
        self.assert_rigid(seen)
        self.assertGreater(seen[self.rim][:, 2].mean(), 5.0)

    def test_a_feature_keeps_its_shape_in_double(self):
        api.set_motion(self.handle, (0, 0, 60), (0, 1, 0), -30)
        self.assert_rigid(api.deform(self.assembly)[self.part.Name], 1e-11)

    def test_a_prescribed_rotation_turns_it(self):
        api.set_rotation(self.hole, ((0, 0, 1), 30))
        seen = self.recomputed()
        self.assert_rigid(seen)
        arm = self.rest[self.rim] - self.rest[self.rim].mean(axis=0)
        cos, sin = np.cos(np.pi / 6), np.sin(np.pi / 6)
        turned = arm @ np.array([[cos, sin, 0], [-sin, cos, 0], [0, 0, 1]])
        np.testing.assert_allclose(seen[self.rim] - seen[self.rim].mean(axis=0), turned, atol=1e-4)
        api.set_rotation(self.hole, "interpolated")
        np.testing.assert_array_equal(self.recomputed(), self.rest.astype(np.float32))


class TestDriven(MotionTest):
    def test_an_expression_drives_the_handle(self):
        self.handle.setExpression("TranslationZ", "2 * 10 mm")
        self.assertLess(support.largest(self.recomputed()[self.tip, 2] - 20.0), 1e-5)

    def test_one_handle_follows_another(self):
        rim = api.hole_rims(self.part)[0]
        follower = api.add_handle(self.assembly, self.part, rim, "Follower")
        follower.setExpression("TranslationZ", f"{self.handle.Name}.TranslationZ / 2")
        api.set_motion(self.handle, (0, 0, 10))
        self.assertLess(support.largest(self.recomputed()[rim, 2] - 5.0), 1e-5)

    def test_a_spreadsheet_cell_drives_the_handle(self):
        sheet = self.document.addObject("Spreadsheet::Sheet", "Inputs")
        sheet.set("B2", "12 mm")
        sheet.set("B3", "90 deg")
        self.handle.setExpression("TranslationZ", "Inputs.B2")
        self.handle.setExpression("Angle", "Inputs.B3")
        seen = self.recomputed()
        self.assertLess(abs(seen[self.tip, 2].mean() - 12.0), 1e-4)
        self.assertEqual(self.handle.Angle.Value, 90.0)
        sheet.set("B2", "=-3 mm")
        sheet.set("B3", "=0 deg")
        self.assertLess(support.largest(self.recomputed()[self.tip, 2] + 3.0), 1e-5)

    def test_a_driven_handle_still_is_driven_after_opening(self):
        sheet = self.document.addObject("Spreadsheet::Sheet", "Inputs")
        sheet.set("B2", "12 mm")
        self.handle.setExpression("TranslationZ", "Inputs.B2")
        self.recomputed()
        self.document = self.reopen(self.document)
        self.part = self.document.getObject(self.part_name())
        self.document.getObject("Inputs").set("B2", "7 mm")
        self.assertLess(support.largest(self.recomputed()[self.tip, 2] - 7.0), 1e-5)

    def part_name(self) -> str:
        return "Part"


class TestDeform(MotionTest):
    def test_positions_are_those_the_recompute_shows(self):
        api.set_motion(self.handle, (0, 5, 30), (1, 0, 0), 10)
        found = api.deform(self.assembly)[self.part.Name]
        self.assertEqual((found.dtype, found.shape), (np.float64, self.rest.shape))
        np.testing.assert_allclose(found, self.recomputed(), atol=1e-4)

    def test_the_fast_answer_is_close(self):
        api.set_motion(self.handle, (0, 5, 30), (1, 0, 0), 10)
        exact = api.deform(self.assembly)[self.part.Name]
        fast = api.deform(self.assembly, exact=False)[self.part.Name]
        self.assertLess(support.largest(fast - exact), 1e-6 * support.LENGTH)

    def test_the_document_is_not_changed(self):
        self.document.recompute()
        api.deform(self.assembly)
        self.assert_up_to_date(self.document)
        self.assertEqual(FreeCAD.getDocument(self.document.Name).RecomputesFrozen, False)


if __name__ == "__main__":
    unittest.main()

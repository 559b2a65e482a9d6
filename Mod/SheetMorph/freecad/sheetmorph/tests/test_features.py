# SPDX-License-Identifier: LGPL-2.1-or-later
"""What form features may do: rotations, motions, sizes, relations, and the plane of symmetry."""

import os

import numpy as np

from freecad.sheetmorph import api, objects
from freecad.sheetmorph.bridge import kernel, recipes, solving
from freecad.sheetmorph.objects.region import ROTATIONS
from freecad.sheetmorph.tests import support

AROUND, RADIUS, CELL = 24, 8.0, 40.0


def round_plate(cells: int = 3) -> tuple[np.ndarray, np.ndarray, list[list[int]]]:
    """Return a flat row of square cells with a round hole each: points, triangles, rims."""
    angles = 2.0 * np.pi * (np.arange(AROUND) + 0.5) / AROUND
    circle = np.stack([np.cos(angles), np.sin(angles)], axis=1)
    square = 0.5 * CELL * circle / np.abs(circle).max(axis=1)[:, None]
    places: dict[tuple, int] = {}
    triangles, rims = [], []
    for cell in range(cells):
        rings = []
        for share in (0.0, 0.3, 0.6, 1.0):
            ring = (1.0 - share) * RADIUS * circle + share * square + (CELL * cell, 0.0)
            keys = [tuple(np.round(place, 9) + 0.0) for place in ring]
            rings.append([places.setdefault(key, len(places)) for key in keys])
        rims.append(sorted(rings[0]))
        for inner, outer in zip(rings, rings[1:]):
            for k in range(AROUND):
                j = (k + 1) % AROUND
                triangles += [[inner[k], outer[k], outer[j]], [inner[k], outer[j], inner[j]]]
    points = np.column_stack([np.array(list(places)), np.zeros(len(places))])
    return points, np.array(triangles, dtype=np.int32), rims


class FeatureTest(support.DocumentTest):
    def setUp(self):
        super().setUp()
        self.points, triangles, self.rims = round_plate()
        self.assembly = api.create_assembly(self.document)
        support.write_obj(os.path.join(self.folder, "plate.obj"), self.points, triangles)
        self.part = api.import_part(self.assembly, os.path.join(self.folder, "plate.obj"))
        left = np.flatnonzero(self.points[:, 0] < -19.9)
        right = np.flatnonzero(self.points[:, 0] > 99.9)
        api.add_fixed(self.assembly, self.part, left, "Clamp")
        self.handle = api.add_handle(self.assembly, self.part, right, "Tip")
        self.holes = [
            api.add_feature(self.assembly, self.part, rim, f"Hole {k}")
            for k, rim in enumerate(self.rims)
        ]
        api.set_motion(self.handle, (0, 0, 20))

    def positions(self) -> np.ndarray:
        return api.deform(self.assembly)[self.part.Name]

    def circle(self, hole: int) -> tuple[float, float]:
        """Return radius and largest deviation of a hole's rim about its centroid."""
        rim = self.positions()[self.rims[hole]]
        radii = np.linalg.norm(rim - rim.mean(axis=0), axis=1)
        return float(radii.mean()), float(np.ptp(radii))

    def normal(self, hole: int) -> np.ndarray:
        """Return the unit normal of a hole in the deformed part."""
        rim = self.positions()[self.rims[hole]]
        return np.linalg.svd(rim - rim.mean(axis=0))[2][2]

    def shift(self, hole: int) -> np.ndarray:
        """Return how far the centre of a hole has moved."""
        rim = self.rims[hole]
        return self.positions()[rim].mean(axis=0) - self.points[rim].mean(axis=0)


class TestRotation(FeatureTest):
    def test_holes_tilt_with_the_sheet_unless_they_are_interpolated(self):
        self.assertLess(abs(self.normal(1)[2]), 0.995)
        for hole in self.holes:
            api.set_rotation(hole, "interpolated")
        self.assertGreater(abs(self.normal(1)[2]), 1.0 - 1e-9)

    def test_a_free_handle_is_turned_by_the_sheet(self):
        right = api.vertices(self.handle)
        api.set_motion(self.handle, axis=(1, 0, 0), angle=30)
        api.set_free_rotation(self.handle, True)
        edge = self.positions()[right]
        self.assertLess(
            support.largest(edge.mean(axis=0) - self.points[right].mean(axis=0) - (0, 0, 20)), 1e-9
        )
        self.assertLess(np.ptp(edge[:, 2]), 1.0)  # turned by 30 degrees it would be 20
        self.assertEqual(self.handle.getEditorMode("Angle"), ["Hidden"])


class TestMotion(FeatureTest):
    def test_each_motion_is_met(self):
        api.set_feature_motion(self.holes[1], "line", direction=(0, 1, 1))
        self.assertLess(support.largest(np.cross(self.shift(1), (0, 1, 1))), 1e-9)
        api.set_feature_motion(self.holes[1], "plane", direction=(0, 0, 1))
        self.assertLess(abs(self.shift(1)[2]), 1e-9)
        self.assertGreater(abs(self.normal(1)[2]), 1.0 - 1e-12)
        api.set_feature_motion(self.holes[1], "fixed")
        moved = self.positions()[self.rims[1]]
        self.assertLess(support.largest(moved - self.points[self.rims[1]]), 1e-9)
        api.set_feature_motion(self.holes[1], "axis", direction=(0, 1, 0), point=(40, 0, 5))
        pivot = self.points[self.rims[1]].mean(axis=0) + self.shift(1) - (40, 0, 5)
        self.assertAlmostEqual(np.linalg.norm(pivot), 5.0, 9)
        api.set_feature_motion(self.holes[1])
        self.assertGreater(self.shift(1)[2], 1.0)

    def test_only_fields_with_a_meaning_are_shown(self):
        hole = self.holes[0]
        self.assertEqual(hole.getEditorMode("MotionDirection"), ["Hidden"])
        hole.Motion = "axis"
        self.assertEqual(hole.getEditorMode("MotionDirection"), [])
        self.assertEqual(hole.getEditorMode("MotionPoint"), [])

    def test_what_makes_no_sense_is_refused(self):
        for arguments, words in (
            ((self.holes[0], "sideways"), "does not exist"),
            ((self.handle, "fixed"), "not .form feature"),
        ):
            with self.subTest(words), self.assertRaisesRegex(ValueError, words):
                api.set_feature_motion(*arguments)
        with self.assertRaisesRegex(ValueError, "has no direction"):
            api.set_feature_motion(self.holes[0], "fixed", direction=(0, 0, 1))


class TestSize(FeatureTest):
    def test_a_diameter_is_set_exactly_and_undone(self):
        self.assertEqual(api.shape_of(self.holes[0])[:2], ("hole", "diameter"))
        api.set_size(self.holes[0], 20.0)
        radius, deviation = self.circle(0)
        self.assertAlmostEqual(radius, 10.0, 9)
        self.assertLess(deviation, 1e-9)
        api.set_size(self.holes[0], None)
        self.assertAlmostEqual(self.circle(0)[0], RADIUS, 9)

    def test_poses_keep_blend_and_compare_sizes(self):
        plain = api.save_pose(self.assembly, "Plain")
        api.set_size(self.holes[0], 20.0)
        wide = api.save_pose(self.assembly, "Wide")
        largest, _ = api.compare_poses(plain, wide)[self.part.Name]
        self.assertAlmostEqual(largest, 10.0 - RADIUS, 6)
        api.blend_poses(plain, wide, 0.5)
        self.assertAlmostEqual(self.circle(0)[0], 0.5 * (10.0 + RADIUS), 9)
        api.apply_pose(plain)
        self.assertEqual(self.holes[0].Size.Value, 0.0)
        twin = api.copy_in_pose(wide)
        sizes = [r.Size.Value for r in objects.model.regions(twin) if r.Role == "form feature"]
        self.assertEqual(sizes[0], 20.0)
        api.apply_pose(wide)
        self.assertAlmostEqual(self.circle(0)[0], 10.0, 9)

    def test_a_size_can_be_driven_by_an_expression(self):
        sheet = self.document.addObject("Spreadsheet::Sheet", "Inputs")
        sheet.set("A1", "18 mm")
        self.holes[2].setExpression("Size", "Inputs.A1")
        self.document.recompute()
        self.assertAlmostEqual(self.circle(2)[0], 9.0, 9)

    def test_too_large_a_size_is_told_with_the_limit(self):
        api.set_size(self.holes[1], 300.0)
        self.document.recompute()
        self.assertRegex(self.assembly.Status, "Hole 1")
        self.assertRegex(self.assembly.Status, "mm")

    def test_what_has_no_size_is_refused(self):
        brace = api.add_feature(self.assembly, self.part, self.rims[0][:5], "Brace")
        self.assertIsNone(api.shape_of(brace))
        with self.assertRaisesRegex(ValueError, "not a hole, slot or cylinder"):
            api.set_size(brace, 4.0)
        with self.assertRaisesRegex(ValueError, "more than 0"):
            api.set_size(self.holes[0], -4.0)


class TestRelations(FeatureTest):
    def test_a_group_moves_as_one_body(self):
        api.group(self.assembly, self.holes[:2])
        one, other = self.normal(0), self.normal(1)
        self.assertLess(np.linalg.norm(np.cross(one, other)), 1e-9)

    def test_a_distance_is_kept(self):
        api.keep_distance(self.assembly, self.holes[0], self.holes[2])
        centres = [self.positions()[rim].mean(axis=0) for rim in self.rims]
        self.assertAlmostEqual(np.linalg.norm(centres[2] - centres[0]), 2 * CELL, 8)

    def test_holes_that_share_no_axis_are_told(self):
        api.coaxial(self.assembly, self.holes[0], self.holes[1])
        self.document.recompute()
        self.assertRegex(self.assembly.Status, "do not share an axis .* 40 mm")

    def test_a_relation_goes_with_the_last_of_its_features(self):
        pair = api.keep_distance(self.assembly, self.holes[0], self.holes[1]).Name
        group = api.group(self.assembly, self.holes)
        api.remove(self.holes[1])
        self.assertIsNone(self.document.getObject(pair))
        self.assertEqual(len(group.Features), 2)

    def test_one_feature_is_not_enough(self):
        with self.assertRaisesRegex(ValueError, "two different form features"):
            api.group(self.assembly, [self.holes[0]])
        with self.assertRaisesRegex(ValueError, "two different form features"):
            api.coaxial(self.assembly, self.holes[0], self.holes[0])


class TestSymmetry(FeatureTest):
    def test_what_one_side_does_the_other_does_mirrored(self):
        fixed = next(r for r in objects.regions(self.assembly) if r.Role == "fixed")
        api.set_vertices(fixed, np.flatnonzero(np.abs(self.points[:, 1]) > 19.9))
        fixed.Vertices = (
            np.flatnonzero((self.points[:, 1] < -19.9) & (np.abs(self.points[:, 0] - 40.0) < 10.0))
            .astype(float)
            .tolist()
        )
        api.set_symmetry(self.assembly, (2, 0, 0), (40, 0, 0))
        found = self.positions()
        left = np.flatnonzero(self.points[:, 0] < -19.9)
        self.assertLess(support.largest(found[left] - self.points[left] - (0, 0, 20)), 1e-9)
        api.set_symmetry(self.assembly, None)
        self.assertGreater(support.largest(self.positions()[left] - found[left]), 1.0)


class TestDocument(FeatureTest):
    def rich(self) -> None:
        """Use everything form features can have."""
        api.set_size(self.holes[0], 18.0)
        api.set_rotation(self.holes[0], "interpolated")
        api.set_feature_motion(self.holes[1], "line", direction=(0, 0, 1))
        api.set_free_rotation(self.handle, True)
        api.group(self.assembly, self.holes[:2], "Row")
        api.keep_distance(self.assembly, self.holes[1], self.holes[2], "Pitch")
        self.assembly.SymmetryNormal = (0, 1, 0)
        self.assembly.Symmetry = True

    def test_a_document_keeps_everything(self):
        self.rich()
        self.document.recompute()
        expected = self.positions()
        recipe = solving.read_morph(self.assembly).recipe
        name = self.assembly.Name
        again = self.reopen(self.document).getObject(name)
        self.assertEqual(solving.read_morph(again).recipe, recipe)
        np.testing.assert_array_equal(api.deform(again)[objects.parts(again)[0].Name], expected)

    def test_a_recipe_keeps_everything(self):
        self.rich()
        os.makedirs(os.path.join(self.folder, "recipe"))
        path = api.export_recipe(self.assembly, os.path.join(self.folder, "recipe", "all.json"))
        kernel.load().checking.validate(kernel.load().recipe.read_json(path), path.parent)
        again = api.import_recipe(self.new_document(), path)
        self.assertEqual(solving.read_morph(again).recipe, solving.read_morph(self.assembly).recipe)
        self.assertEqual(recipes.pose_of(again), recipes.pose_of(self.assembly))

    def test_a_document_of_an_earlier_version_keeps_its_rotations(self):
        for region, rotation in zip(self.holes, ("interpolated", "prescribed")):
            for added in ("Motion", "MotionDirection", "MotionPoint", "Size", "FreeRotation"):
                region.removeProperty(added)
            region.Rotation = ["interpolated", "prescribed"]
            region.Rotation = rotation
        names = [hole.Name for hole in self.holes]
        again = self.reopen(self.document)
        holes = [again.getObject(name) for name in names]
        self.assertEqual([h.Rotation for h in holes], ["interpolated", "prescribed", "free"])
        self.assertEqual(holes[0].getEnumerationsOfProperty("Rotation"), ROTATIONS)
        self.assertEqual([h.Motion for h in holes], ["free"] * 3)
        holes[0].Rotation = "free"
        again.recompute()

    def test_a_change_of_a_relation_asks_for_a_recompute(self):
        self.document.recompute()
        pair = api.keep_distance(self.assembly, self.holes[0], self.holes[2])
        self.document.recompute()
        before = support.local_points(self.part)
        pair.Type = "group"
        self.document.recompute()
        self.assertGreater(support.largest(support.local_points(self.part) - before), 1e-3)

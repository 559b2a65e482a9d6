# SPDX-License-Identifier: LGPL-2.1-or-later
"""Regions: making them, picking their vertices, refusing what cannot be meant."""

import unittest
import zipfile

import numpy as np

from freecad.sheetmorph import api
from freecad.sheetmorph.bridge import conversion, faults
from freecad.sheetmorph.objects import model
from freecad.sheetmorph.tests import support


class RegionTest(support.DocumentTest):
    def setUp(self):
        super().setUp()
        self.assembly = api.create_assembly(self.document)
        self.part = api.add_part(self.assembly, self.add_source(), "Strip")
        self.points, self.triangles = api.rest_mesh(self.part)


class TestAdding(RegionTest):
    def test_each_role_has_its_call(self):
        fixed = api.add_fixed(self.assembly, self.part, [3, 1, 2, 1])
        handle = api.add_handle(self.assembly, self.part, np.array([5, 6]), "Tip")
        feature = api.add_feature(self.assembly, self.part, {8, 9})
        self.assertEqual(
            [r.Role for r in (fixed, handle, feature)], ["fixed", "handle", "form feature"]
        )
        self.assertEqual([r.Label for r in (fixed, handle, feature)], ["Fixed", "Tip", "Feature"])
        self.assertEqual(api.vertices(fixed), [1, 2, 3])
        self.assertEqual(api.vertices(handle), [5, 6])
        self.assertEqual(feature.Rotation, "free")
        for region in (fixed, handle, feature):
            self.assertEqual(region.Part, self.part)
            self.assertIn(region, self.assembly.Group)

    def test_a_prescribed_feature_is_made_in_one_call(self):
        feature = api.add_feature(
            self.assembly, self.part, [8, 9], "Hole", rotation=((0, 1, 0), 12.5)
        )
        self.assertEqual(feature.Rotation, "prescribed")
        self.assertEqual(tuple(feature.RotationAxis), (0.0, 1.0, 0.0))
        self.assertEqual(feature.RotationAngle.Value, 12.5)

    def test_a_handle_turns_about_its_centroid_until_told_otherwise(self):
        vertices = support.right_edge(self.points)
        handle = api.add_handle(self.assembly, self.part, vertices)
        centroid = self.points[vertices].mean(axis=0)
        self.assertLess(support.largest(np.array(api.pivot(handle)) - centroid), 1e-12)
        api.set_vertices(handle, vertices[:3])
        centroid = self.points[vertices[:3]].mean(axis=0)
        self.assertLess(support.largest(np.array(handle.Pivot) - centroid), 1e-12)

    def test_bad_arguments_are_refused_and_nothing_is_added(self):
        count = len(self.document.Objects)
        cases = (
            ([], "at least one"),
            ([-1], "no vertex -1"),
            ([len(self.points)], "no vertex"),
            ([1.5], "whole number"),
        )
        for vertices, words in cases:
            with self.subTest(words), self.assertRaisesRegex(ValueError, words):
                api.add_fixed(self.assembly, self.part, vertices)
        with self.assertRaisesRegex(ValueError, "not available"):
            api.add_feature(self.assembly, self.part, [1, 2], rotation="loose")
        with self.assertRaisesRegex(ValueError, "axis is zero"):
            api.add_feature(self.assembly, self.part, [1, 2], rotation=((0, 0, 0), 3))
        with self.assertRaisesRegex(ValueError, "not in the morph"):
            api.add_fixed(api.create_assembly(self.document), self.part, [1])
        self.assertEqual(len(self.document.Objects), count + 2)  # the other, empty assembly
        with self.assertRaisesRegex(ValueError, "not a SheetMorph region"):
            api.set_vertices(self.part, [1])

    def test_equal_labels_are_made_unique(self):
        labels = {api.add_fixed(self.assembly, self.part, [k], "Hold").Label for k in range(3)}
        self.assertEqual(len(labels), 3)


class TestPicking(RegionTest):
    def test_facets_give_their_vertices(self):
        expected = sorted(set(self.triangles[[0, 5]].ravel().tolist()))
        self.assertEqual(api.vertices_of_facets(self.part, [5, 0]), expected)
        with self.assertRaisesRegex(ValueError, "no facet"):
            api.vertices_of_facets(self.part, [len(self.triangles)])

    def test_the_strip_has_three_holes(self):
        rims = api.hole_rims(self.part)
        self.assertEqual(len(rims), 3)
        centres = sorted(self.points[rim].mean(axis=0)[0] for rim in rims)
        np.testing.assert_allclose(centres, [75.0, 150.0, 225.0], atol=5.0)

    def test_a_rim_is_found_from_any_of_its_vertices(self):
        for rim in api.hole_rims(self.part):
            for vertex in (rim[0], rim[-1]):
                self.assertEqual(api.hole_rim(self.part, vertex), rim)

    def test_a_rim_grows_by_rings(self):
        rim = api.hole_rims(self.part)[0]
        wider = api.hole_rim(self.part, rim[0], rings=1)
        touched = np.isin(self.triangles, rim).any(axis=1)
        self.assertEqual(wider, np.unique(self.triangles[touched]).tolist())

    def test_every_hole_of_a_closed_body_is_found_though_it_has_no_outline(self):
        points, triangles = support.strip()
        is_outer = (points[:, 0] % support.LENGTH == 0) | (points[:, 1] % support.WIDTH == 0)
        inner = np.flatnonzero(~is_outer)
        of_copy = np.arange(len(points))
        of_copy[inner] = len(points) + np.arange(len(inner))
        pillow = (
            np.concatenate([points, points[inner] + (0, 0, 10)]),
            np.concatenate([triangles, of_copy[triangles][:, ::-1]]).astype(np.int32),
        )
        part = api.add_part(self.assembly, self.add_source("Pillow", mesh=pillow))
        self.assertEqual(len(api.hole_rims(part)), 6)

    def test_a_rim_is_found_in_a_part_with_more_vertices_than_mm(self):
        points, triangles = support.strip()
        small = self.add_source("Small", mesh=(0.1 * points, triangles))
        part = api.add_part(self.assembly, small)
        rim = api.hole_rims(part)[-1]
        self.assertGreater(max(rim), 32)
        self.assertEqual(api.hole_rim(part, max(rim)), rim)

    def test_a_vertex_inside_the_sheet_is_on_no_rim(self):
        distance = np.linalg.norm(self.points - (110.0, 50.0, 0.0), axis=1)
        with self.assertRaises(ValueError):
            api.hole_rim(self.part, int(distance.argmin()))
        with self.assertRaisesRegex(ValueError, "no vertex"):
            api.hole_rim(self.part, len(self.points))


class TestLargeRegions(support.DocumentTest):
    def test_a_hundred_thousand_vertices_are_saved_in_binary(self):
        mesh = support.strip(401, 271)
        assembly = api.create_assembly(self.document)
        part = api.add_part(assembly, self.add_source(mesh=mesh))
        wanted = list(range(100_000))
        name = api.add_fixed(assembly, part, wanted).Name
        opened = self.reopen(self.document, "large.FCStd")
        self.assertEqual(api.vertices(opened.getObject(name)), wanted)
        with zipfile.ZipFile(opened.FileName) as archive:
            self.assertLess(archive.getinfo("Document.xml").file_size, 200_000)


class TestMending(support.DocumentTest):
    def test_a_region_leaves_to_another_one_what_both_have(self):
        assembly, part, handle = self.add_morph()
        mine = api.vertices(handle)
        second = api.add_handle(assembly, part, mine[:4] + [0, 1], "Second")
        api.take_out(second, handle)
        self.assertEqual(api.vertices(second), [0, 1])
        with self.assertRaisesRegex(ValueError, "contains all vertices of 'Tip'; delete one"):
            api.take_out(handle, handle)
        self.assertEqual(api.vertices(handle), mine)

    def test_pieces_that_nothing_holds_are_fixed(self):
        assembly, part, _ = self.add_morph()
        with self.assertRaisesRegex(ValueError, "nothing to fix"):
            api.hold_loose_pieces(part)
        points, triangles = support.strip()
        both = np.concatenate([points, points + (0, 0, 50)])
        corners = np.concatenate([triangles, triangles + len(points)])
        part.Source.Mesh = conversion.MeshWriter(corners).mesh(both)
        self.document.recompute()
        self.assertEqual(model.failure_of(assembly), "")
        api.set_unheld(assembly, "refuse")
        self.document.recompute()
        self.assertIn("nothing constrains", model.failure_of(assembly))
        region = api.hold_loose_pieces(part)
        self.assertEqual(api.vertices(region), list(range(len(points), len(both))))
        self.document.recompute()
        self.assert_up_to_date(self.document)


class TestFaults(support.DocumentTest):
    def test_one_object_says_what_is_wrong_and_not_every_part(self):
        assembly, handle, _contact = self.add_pair()
        self.document.recompute()
        before = faults.faults_in(self.document)
        second = api.add_handle(assembly, handle.Part, api.vertices(handle)[:4], "Second")
        api.set_motion(second, (0, 0, 3))
        self.document.recompute()
        wrong = [obj for obj in self.document.Objects if "Invalid" in obj.State]
        self.assertEqual([model.kind(obj) for obj in wrong], [model.DEFORMATION])
        sentence = faults.new_fault(self.document, before)
        self.assertEqual(faults.at_fault(assembly, sentence), [handle, second])
        self.assertIsNone(faults.new_fault(self.document, faults.faults_in(self.document)))


if __name__ == "__main__":
    unittest.main()

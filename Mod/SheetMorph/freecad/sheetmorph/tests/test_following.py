# SPDX-License-Identifier: LGPL-2.1-or-later
"""A part follows the body or shape that it was made from; its regions are found by their words."""

import json
import os
import tempfile
import unittest

import FreeCAD
import numpy as np
import Part
import Sketcher

from freecad.sheetmorph import api
from freecad.sheetmorph.tests.support import DocumentTest, placement

Vector = FreeCAD.Vector
SIZES = {"edge": 6.0}
LEFT, RIGHT = {"face_at": [0, 20, 1]}, {"face_at": [60, 20, 1]}
HOLE = {"rim_at": [40, 25, 2], "rings": 1}


class TestFollowing(DocumentTest):
    def setUp(self) -> None:
        super().setUp()
        self.assembly = api.create_assembly(self.document)

    def padded(self):
        """A PartDesign body, a plate of 60 x 40 x 2 mm with a hole of radius 5 mm, and its pad."""
        body = self.document.addObject("PartDesign::Body", "Body")
        sketch = body.newObject("Sketcher::SketchObject", "Sketch")
        corners = [Vector(x, y) for x, y in ((0, 0), (60, 0), (60, 40), (0, 40))]
        for k, corner in enumerate(corners):
            sketch.addGeometry(Part.LineSegment(corner, corners[(k + 1) % 4]), False)
        for k in range(4):
            sketch.addConstraint(Sketcher.Constraint("Coincident", k, 2, (k + 1) % 4, 1))
        sketch.addGeometry(Part.Circle(Vector(40, 20), Vector(0, 0, 1), 5.0), False)
        pad = body.newObject("PartDesign::Pad", "Pad")
        pad.Profile, pad.Length = sketch, 2.0
        self.document.recompute()
        return body, pad

    def marked(self, body):
        """The body as a part, fixed left, moved right, its hole kept; all in words."""
        (part,) = api.add_shape(self.assembly, body, "plate", SIZES)
        clamp = api.add_fixed(self.assembly, part, LEFT, "Clamp")
        tip = api.add_handle(self.assembly, part, RIGHT, "Tip")
        hole = api.add_feature(self.assembly, part, HOLE, "Hole")
        api.set_motion(tip, (0, 0, 5))
        self.document.recompute()
        return part, (clamp, tip, hole)

    def test_a_longer_pad_is_followed_and_every_region_is_found_again(self):
        body, pad = self.padded()
        part, regions = self.marked(body)
        self.assertFalse(part.SourceChanged)
        pad.Length = 3.0
        self.document.recompute()
        self.assertTrue(part.SourceChanged)
        found = api.follow_shape(part)
        self.document.recompute()
        self.assertFalse(part.SourceChanged)
        points = api.rest_mesh(part)[0]
        self.assertAlmostEqual(float(np.ptp(points[:, 2])), 3.0, delta=1e-9)
        self.assertEqual([api.where(region) for region in regions], [LEFT, RIGHT, HOLE])
        for region in regions:
            self.assertEqual(api.vertices(region), api.select(part, api.where(region)))
        self.assertEqual(found["different"][:2], [region.Name for region in regions[:2]])
        self.assertIn("'Clamp' covers 120 mm2 now, 80 mm2 before.", found["told"])
        self.assertEqual(json.loads(part.Differences), found)
        rows = api.vertices(regions[1])
        moved = api.deform(self.assembly)[part.Name]
        np.testing.assert_allclose(moved[rows] - points[rows], [[0, 0, 5]] * len(rows), atol=1e-9)
        shape = api.deformed_shape(part).Shape
        self.assertTrue(shape.isValid() and shape.isClosed())
        walls = [f.Surface for f in shape.Faces if isinstance(f.Surface, Part.Cylinder)]
        self.assertEqual([round(wall.Radius, 12) for wall in walls], [5.0])

    def test_what_stays_the_same_is_no_change_and_an_edit_taken_back_is_none(self):
        body, pad = self.padded()
        part, _ = self.marked(body)
        body.Placement = placement((7, 0, 0), (0, 0, 1), 20)
        self.document.recompute()
        pad.touch()
        self.document.recompute()
        self.assertFalse(part.SourceChanged)
        for length, is_another in ((2.5, True), (2.0, False)):
            pad.Length = length
            self.document.recompute()
            self.assertEqual(part.SourceChanged, is_another)

    def test_a_hole_that_moves_is_a_change(self):
        body, pad = self.padded()
        part, _ = self.marked(body)
        curves = pad.Profile[0].Geometry
        curves[4].Center = Vector(38, 20)
        pad.Profile[0].Geometry = curves
        self.document.recompute()
        self.assertTrue(part.SourceChanged)

    def test_following_is_undone_exactly(self):
        body, pad = self.padded()
        part, regions = self.marked(body)
        before = api.rest_mesh(part)[0]
        ids = [api.vertices(region) for region in regions]
        self.document.openTransaction("edit")
        pad.Length = 3.0
        self.document.recompute()
        self.document.commitTransaction()
        self.document.openTransaction("follow")
        api.follow_shape(part)
        self.document.recompute()
        self.document.commitTransaction()
        self.document.undo()
        np.testing.assert_array_equal(api.rest_mesh(part)[0], before)
        self.assertEqual([api.vertices(region) for region in regions], ids)
        self.assertTrue(part.SourceChanged)
        self.document.undo()
        self.assertFalse(part.SourceChanged)

    def test_a_part_stays_where_it_stands_and_its_deformed_shape_is_told(self):
        body, pad = self.padded()
        part, _ = self.marked(body)
        feature = api.deformed_shape(part)
        part.Source.Placement = placement((500, 0, 0)).multiply(part.Source.Placement)
        pad.Length = 3.0
        self.document.recompute()
        found = api.follow_shape(part)
        self.assertIn(feature.Name, found["different"])
        self.assertAlmostEqual(float(api.rest_mesh(part)[0][:, 0].min()), 500.0, delta=1e-9)

    def test_a_saved_document_still_follows(self):
        body, pad = self.padded()
        part, _ = self.marked(body)
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "saved.FCStd")
            self.document.saveAs(path)
            restored = FreeCAD.openDocument(path)
            try:
                part, pad = (restored.getObject(one.Name) for one in (part, pad))
                restored.recompute()
                self.assertFalse(part.SourceChanged)
                pad.Length = 3.0
                restored.recompute()
                self.assertTrue(part.SourceChanged)
                api.follow_shape(part)
                self.assertEqual(round(float(np.ptp(api.rest_mesh(part)[0][:, 2])), 6), 3.0)
            finally:
                FreeCAD.closeDocument(restored.Name)

    def drilled(self, *places):
        """A plate of 160 x 40 x 2 mm as a shape of the document, with holes of 9 mm along x."""
        shape = Part.makeBox(160, 40, 2)
        for x in places:
            shape = shape.cut(Part.makeCylinder(4.5, 4, Vector(x, 20, -1)))
        return shape

    def drilled_part(self, *places):
        """The object, its part, and the second of its holes as a form feature."""
        source = self.document.addObject("Part::Feature", "Drilled")
        source.Shape = self.drilled(*places)
        (part,) = api.add_shape(self.assembly, source, "plate", SIZES)
        hole = api.add_feature(
            self.assembly, part, {"rim_at": [places[1], 20, 2], "rings": 1}, "second hole"
        )
        return source, part, hole

    def middle(self, part, region) -> float:
        """Where the middle of a region is along x."""
        points = api.rest_mesh(part)[0][api.vertices(region), 0]
        return float(points.min() + points.max()) / 2

    def test_a_pattern_of_holes_is_followed_as_a_whole(self):
        source, part, hole = self.drilled_part(20, 50, 80, 110)
        source.Shape = self.drilled(36, 66, 96, 126)
        found = api.follow_shape(part)
        self.assertAlmostEqual(self.middle(part, hole), 66.0, delta=1.0)
        self.assertIn("'second hole': the round hole of 9 mm at (50, 20", found["told"][0])
        self.assertIn("moved by 16 mm", found["told"][0])
        self.assertEqual(api.vertices(hole), api.select(part, api.where(hole)))

    def test_a_hole_that_may_be_another_one_is_a_question_with_candidates(self):
        source, part, hole = self.drilled_part(20, 50, 80, 110)
        before, ids = api.rest_mesh(part)[0], api.vertices(hole)
        source.Shape = self.drilled(20, 66, 80, 110)
        with self.assertRaisesRegex(
            api.Unbound, "second hole' was the round hole of 9 mm"
        ) as asked:
            api.follow_shape(part)
        (one,) = asked.exception.unbound.values()
        self.assertEqual([round(place["place"][0]) for place in one["candidates"]], [66, 20])
        np.testing.assert_array_equal(api.rest_mesh(part)[0], before)
        self.assertEqual(api.vertices(hole), ids)
        api.follow_shape(part, bindings={hole.Name: one["candidates"][0]["place"]})
        self.assertAlmostEqual(self.middle(part, hole), 66.0, delta=1.0)

    def test_a_removed_hole_of_which_only_vertices_are_known_is_a_question(self):
        source, part, hole = self.drilled_part(20, 50, 80, 110)
        api.set_vertices(hole, api.vertices(hole))
        source.Shape = self.drilled(20, 80, 110)
        with self.assertRaises(api.Unbound):
            api.follow_shape(part)
        api.follow_shape(part, bindings={hole.Label: {"rim_at": [80, 20, 2]}})
        self.assertAlmostEqual(self.middle(part, hole), 80.0, delta=1.0)

    def test_what_cannot_be_followed_is_told_and_changes_nothing(self):
        source = self.document.addObject("Part::Feature", "Shape")
        source.Shape = Part.makeBox(20, 20, 2)
        (part,) = api.add_shape(self.assembly, source, "plate", SIZES)
        before = api.rest_mesh(part)[0]
        boxes = [Part.makeBox(20, 20, 2, Vector(x, 0, 0)) for x in (0, 40)]
        source.Shape = Part.makeCompound(boxes)
        with self.assertRaisesRegex(ValueError, "now has 2 solids instead of 1"):
            api.follow_shape(part)
        source.Shape = Part.Shape()
        with self.assertRaisesRegex(ValueError, "has no faces"):
            api.follow_shape(part)
        self.document.removeObject(source.Name)
        with self.assertRaisesRegex(ValueError, "has no shape to follow"):
            api.follow_shape(part)
        np.testing.assert_array_equal(api.rest_mesh(part)[0], before)


if __name__ == "__main__":
    unittest.main()

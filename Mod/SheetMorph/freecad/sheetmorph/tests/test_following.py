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

    def test_what_cannot_be_followed_is_told_and_changes_nothing(self):
        source = self.document.addObject("Part::Feature", "Shape")
        source.Shape = Part.makeBox(20, 20, 2)
        (part,) = api.add_shape(self.assembly, source, "plate", SIZES)
        before = api.rest_mesh(part)[0]
        boxes = [Part.makeBox(20, 20, 2, Vector(x, 0, 0)) for x in (0, 40)]
        source.Shape = Part.makeCompound(boxes)
        with self.assertRaisesRegex(ValueError, "has 2 solids now and had 1"):
            api.follow_shape(part)
        source.Shape = Part.Shape()
        with self.assertRaisesRegex(ValueError, "has no faces"):
            api.follow_shape(part)
        self.document.removeObject(source.Name)
        with self.assertRaisesRegex(ValueError, "follows no shape"):
            api.follow_shape(part)
        np.testing.assert_array_equal(api.rest_mesh(part)[0], before)


if __name__ == "__main__":
    unittest.main()

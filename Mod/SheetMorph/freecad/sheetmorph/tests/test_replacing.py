# SPDX-License-Identifier: LGPL-2.1-or-later
"""The changed file of a part is read in its place; what was picked is found again, or told."""

import os
import unittest

import FreeCAD
import Import
import numpy as np
import Part

from freecad.sheetmorph import api
from freecad.sheetmorph.bridge import selecting
from freecad.sheetmorph.objects import model
from freecad.sheetmorph.tests.support import DocumentTest, placement, strip, write_obj

Vector = FreeCAD.Vector
SIZES = {"edge": 6.0}
LEFT, RIGHT = {"face_at": [0, 20, 1]}, {"face_at": [60, 20, 1]}
HOLE = {"rim_at": [40, 25, 2], "rings": 1}


def plate(width: float = 40.0, radius: float = 5.0, shift: float = 0.0):
    """A plate of 60 x 40 x 2 mm with a hole, its left edge at x = shift."""
    shape = Part.makeBox(60 - shift, width, 2, Vector(shift, 0, 0))
    return shape.cut(Part.makeCylinder(radius, 4, Vector(40, 20, -1)))


class TestReplacing(DocumentTest):
    def setUp(self) -> None:
        super().setUp()
        self.assembly = api.create_assembly(self.document)

    def step(self, name: str, *shapes) -> str:
        """The path of a new STEP file of shapes with labels."""
        path = os.path.join(self.folder, name)
        made = FreeCAD.newDocument("Export", hidden=True)
        try:
            for label, shape in shapes:
                feature = made.addObject("Part::Feature", "Shape")
                feature.Label, feature.Shape = label, shape
            Import.export(made.Objects, path)
        finally:
            FreeCAD.closeDocument(made.Name)
        FreeCAD.setActiveDocument(self.document.Name)
        return path

    def marked_plate(self):
        """The plate from its file, fixed left, moved right, its hole kept; all in words."""
        (part,) = api.import_cad(self.assembly, self.step("a.step", ("plate", plate())), SIZES)
        clamp = api.add_fixed(self.assembly, part, LEFT, "Clamp")
        tip = api.add_handle(self.assembly, part, RIGHT, "Tip")
        hole = api.add_feature(self.assembly, part, HOLE, "Hole")
        api.set_motion(tip, (0, 0, 5))
        self.document.recompute()
        return part, (clamp, tip, hole)

    def assert_resolved(self, part, regions) -> None:
        for region in regions:
            self.assertEqual(api.vertices(region), api.select(part, api.where(region)))

    def test_another_state_of_a_step_file_keeps_every_region_and_tells_what_differs(self):
        part, regions = self.marked_plate()
        before = api.rest_mesh(part)[0]
        changed = self.step("b.step", ("plate", plate(46.0, 6.0)))
        found = api.replace_file(part, changed, SIZES)
        self.document.recompute()
        points = api.rest_mesh(part)[0]
        self.assertEqual(round(float(np.ptp(points[:, 1])), 6), 46.0)
        self.assertNotEqual(len(points), len(before))
        self.assert_resolved(part, regions)
        self.assertEqual([api.where(region) for region in regions], [LEFT, RIGHT, HOLE])
        self.assertEqual(found["different"], [region.Name for region in regions])
        self.assertIn("'Clamp' covers 92 mm2 now, 80 mm2 before.", found["told"])
        self.assertAlmostEqual(
            max(f["radius"] for f in api.exact_features(part) if f["kind"] == "round hole"), 6.0
        )
        moved = api.deform(self.assembly)[part.Name]
        rows = api.vertices(regions[1])
        np.testing.assert_allclose(moved[rows] - points[rows], [[0, 0, 5]] * len(rows), atol=1e-9)
        self.assertEqual(part.State, ["Up-to-date"])

    def test_the_same_file_again_changes_nothing_and_the_part_stays_where_it_stands(self):
        part, regions = self.marked_plate()
        part.Source.Placement = placement((500, 3, 1), (0, 0, 1), 30).multiply(
            part.Source.Placement
        )
        self.document.recompute()
        before, ids = api.rest_mesh(part)[0], [api.vertices(region) for region in regions]
        found = api.replace_file(part, os.path.join(self.folder, "a.step"), SIZES)
        self.assertEqual(found, {"told": [], "different": []})
        self.assertEqual([api.vertices(region) for region in regions], ids)
        np.testing.assert_allclose(api.rest_mesh(part)[0], before, atol=1e-9)

    def test_a_prepared_part_is_prepared_again_and_vertices_alone_are_told(self):
        part, regions = self.marked_plate()
        api.prepare(part, edge=4.0)
        api.set_vertices(regions[2], api.vertices(regions[2]))
        found = api.replace_file(part, self.step("b.step", ("plate", plate(40.5))), SIZES)
        self.document.recompute()
        self.assertEqual(api.preparation_of(part)["remesh"]["edge"], 4.0)
        self.assertEqual(found["different"], [regions[2].Name])
        self.assertIn("nearest vertices", found["told"][0])
        self.assert_resolved(part, regions[:2])
        points = api.rest_mesh(part)[0][api.vertices(regions[2])]
        self.assertLess(np.abs(np.hypot(points[:, 0] - 40, points[:, 1] - 20) - 5).min(), 0.1)
        self.assertEqual(part.State, ["Up-to-date"])

    def test_what_is_not_found_again_keeps_its_vertices_and_is_told(self):
        part, regions = self.marked_plate()
        where = {"found": "round hole", "diameter": [9.9, 10.1]}
        api.set_vertices(regions[2], where)
        found = api.replace_file(part, self.step("b.step", ("plate", plate(40.0, 7.0))), SIZES)
        self.assertIn("'Hole' keeps its vertices without a selector", found["told"][0])
        self.assertIsNone(api.where(regions[2]))
        self.assertGreater(len(api.vertices(regions[2])), 0)

    def test_of_several_solids_the_one_of_the_name_is_taken(self):
        part, regions = self.marked_plate()
        other = Part.makeBox(9, 9, 9, Vector(500, 0, 0))
        two = self.step("two.step", ("lid", other), ("plate", plate(46.0)))
        api.replace_file(part, two, SIZES)
        self.assertEqual(round(float(np.ptp(api.rest_mesh(part)[0][:, 1])), 6), 46.0)
        part.Label = "cover"
        before = api.rest_mesh(part)[0]
        with self.assertRaisesRegex(ValueError, 'not exactly one is called .cover.*"lid", "plate"'):
            api.replace_file(part, two, SIZES)
        np.testing.assert_array_equal(api.rest_mesh(part)[0], before)

    def test_a_mesh_file_is_replaced_and_written_in_its_own_format(self):
        points, triangles = strip()
        old, new = (os.path.join(self.folder, name) for name in ("old.obj", "new.obj"))
        write_obj(old, points, triangles)
        write_obj(new, points * [1.0, 1.2, 1.0], triangles)
        part = api.import_part(self.assembly, old)
        left = {"half_space": {"point": [15, 0, 0], "normal": [-1, 0, 0]}}
        clamp = api.add_fixed(self.assembly, part, left)
        self.assertEqual(api.replace_file(part, new)["different"], [clamp.Name])
        self.assertEqual(part.FileName, "new.obj")
        self.document.recompute()
        api.write_parts(self.assembly, os.path.join(self.folder, "out"))
        with open(os.path.join(self.folder, "out", "new.obj"), encoding="utf-8") as file:
            written = file.read()
        with open(new, encoding="utf-8") as file:
            self.assertEqual(written, file.read())
        with self.assertRaisesRegex(ValueError, "comes from a mesh file"):
            api.replace_file(part, self.step("a.step", ("plate", plate())))
        self.assertEqual(len([o for o in model.parts(self.assembly)]), 1)
        self.assertIsNotNone(selecting.sentence_of(clamp))


if __name__ == "__main__":
    unittest.main()

# SPDX-License-Identifier: LGPL-2.1-or-later
"""Parts made from shapes are shapes again: valid, closed, holes round, undone exactly."""

import os
import tempfile

import FreeCAD
import Mesh
import numpy as np
import Part
import TechDraw

from freecad.sheetmorph import api
from freecad.sheetmorph.objects.errors import MorphError
from freecad.sheetmorph.tests import test_cad

Vector = FreeCAD.Vector


class TestDeformedShapes(test_cad.CadTest):
    def bent_plate(self):
        """Return a part made from a plate, bent, its wide hole a form feature."""
        (part,) = api.add_shape(self.assembly, self.add(test_cad.plate()), mesh=test_cad.SIZES)
        self.bend(part)
        return part

    def radii(self, shape) -> list[float]:
        """Return the radii of the cylinders of a shape."""
        surfaces = [face.Surface for face in shape.Faces]
        return [one.Radius for one in surfaces if isinstance(one, Part.Cylinder)]

    def test_a_bent_plate_is_a_valid_solid_with_a_round_hole(self):
        part = self.bent_plate()
        feature = api.deformed_shape(part)
        shape = feature.Shape
        self.assertTrue(feature.isDerivedFrom("Part::Feature"))
        self.assertTrue(shape.isValid() and shape.isClosed())
        self.assertEqual((shape.ShapeType, len(shape.Faces)), ("Solid", 8))
        self.assertEqual(len(self.radii(shape)), 1)
        self.assertAlmostEqual(self.radii(shape)[0], 5.0, delta=1e-12)
        self.assertAlmostEqual(shape.BoundBox.ZMax, 10.0, delta=0.02)
        mesh = part.Mesh.BoundBox
        self.assertAlmostEqual(shape.BoundBox.XMax, mesh.XMax, delta=0.02)

    def test_what_takes_a_shape_takes_it(self):
        shape = api.deformed_shape(self.bent_plate()).Shape
        cut = shape.cut(Part.makeBox(10, 10, 40, Vector(28, -1, -20)))
        self.assertTrue(cut.isValid())
        self.assertLess(cut.Volume, shape.Volume)
        mesh = Mesh.Mesh(shape.tessellate(0.05))
        self.assertTrue(mesh.isSolid())
        self.assertFalse(mesh.hasSelfIntersections())

    def test_a_drawing_shows_the_hole_as_a_circle(self):
        shape = api.deformed_shape(self.bent_plate()).Shape
        (axis,) = [f.Surface.Axis for f in shape.Faces if isinstance(f.Surface, Part.Cylinder)]
        drawn = [edge for group in TechDraw.projectEx(shape, axis) for edge in group.Edges]
        circles = [edge.Curve.Radius for edge in drawn if isinstance(edge.Curve, Part.Circle)]
        self.assertTrue(any(abs(radius - 5.0) < 1e-9 for radius in circles), circles)

    def test_a_drawing_along_each_of_two_holes_with_washers_shows_its_circles(self):
        (part,) = api.add_shape(self.assembly, self.add(test_cad.plate()), mesh=test_cad.SIZES)
        points, _ = api.rest_mesh(part)
        api.add_fixed(self.assembly, part, np.flatnonzero(points[:, 0] < 1e-6))
        tip = np.flatnonzero(points[:, 0] > 60 - 1e-6)
        for x, radius in ((15.0, 3.0), (40.0, 5.0)):
            near = np.hypot(points[:, 0] - x, points[:, 1] - 20.0) < 2.0 * radius
            api.add_feature(self.assembly, part, np.flatnonzero(near))
        api.set_motion(api.add_handle(self.assembly, part, tip), (0, 0, 8), axis=(1, 0, 0), angle=9)
        self.document.recompute()
        shape = api.deformed_shape(part).Shape
        walls = [face.Surface for face in shape.Faces if isinstance(face.Surface, Part.Cylinder)]
        self.assertEqual(sorted(round(wall.Radius, 9) for wall in walls), [3.0, 5.0])
        for wall in walls:
            groups = TechDraw.projectEx(shape, wall.Axis)
            curves = [edge.Curve for group in groups for edge in group.Edges]
            radii = [round(one.Radius, 9) for one in curves if isinstance(one, Part.Circle)]
            self.assertIn(round(wall.Radius, 9), radii)

    def test_it_is_brought_up_to_date_and_undone(self):
        part = self.bent_plate()
        self.document.openTransaction("shape")
        feature = api.deformed_shape(part)
        self.document.commitTransaction()
        before = feature.Shape.BoundBox.ZMax
        handle = next(o for o in self.document.Objects if o.Label.startswith("Handle"))
        self.document.openTransaction("move")
        api.set_motion(handle, (0, 0, 4))
        self.document.recompute()
        (same,) = api.update_shapes(self.assembly)
        self.document.commitTransaction()
        self.assertEqual(same.Name, feature.Name)
        self.assertLess(feature.Shape.BoundBox.ZMax, before - 3.0)
        self.document.undo()
        self.assertEqual(feature.Shape.BoundBox.ZMax, before)
        self.document.undo()
        self.assertIsNone(part.DeformedShape)

    def test_it_stands_where_its_part_does(self):
        source = self.add(test_cad.plate())
        source.Placement = FreeCAD.Placement(
            Vector(100, 20, 5), FreeCAD.Rotation(Vector(1, 1, 0), 30)
        )
        (part,) = api.add_shape(self.assembly, source, mesh=test_cad.SIZES)
        points, _ = api.rest_mesh(part)
        api.add_fixed(self.assembly, part, np.arange(10))
        self.document.recompute()
        shape = api.deformed_shape(part).Shape
        self.assertEqual(len(self.radii(shape)), 2)
        self.assertAlmostEqual(shape.BoundBox.XMax, points[:, 0].max(), delta=0.02)

    def test_a_mesh_that_folds_makes_no_shape(self):
        part = self.bent_plate()
        handle = next(o for o in self.document.Objects if o.Label.startswith("Handle"))
        api.set_motion(handle, (-200, 0, 0))
        self.document.recompute()
        with self.assertRaisesRegex(MorphError, "folds .*turn its handles less"):
            api.deformed_shape(part)
        self.assertIsNone(part.DeformedShape)

    def test_a_mesh_has_no_shape(self):
        source = self.document.addObject("Mesh::Feature", "Mesh")
        source.Mesh = Mesh.createBox(4, 4, 4)
        part = api.add_part(self.assembly, source)
        with self.assertRaisesRegex(MorphError, "not made from a shape"):
            api.deformed_shape(part)

    def test_export_parts_writes_it(self):
        part = self.bent_plate()
        api.deformed_shape(part)
        with tempfile.TemporaryDirectory() as folder:
            paths = api.write_parts(self.assembly, folder)
            steps = [path for path in paths if path.suffix == ".step"]
            self.assertEqual(len(steps), 1)
            self.assertTrue(os.path.isfile(steps[0]))
            shape = Part.read(str(steps[0]))
        self.assertTrue(shape.isValid())
        self.assertAlmostEqual(self.radii(shape)[0], 5.0, delta=1e-12)

    def test_a_saved_document_still_makes_it(self):
        part = self.bent_plate()
        name = part.Name
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "saved.FCStd")
            self.document.saveAs(path)
            restored = FreeCAD.openDocument(path)
            try:
                shape = api.deformed_shape(restored.getObject(name)).Shape
                self.assertTrue(shape.isValid())
            finally:
                FreeCAD.closeDocument(restored.Name)

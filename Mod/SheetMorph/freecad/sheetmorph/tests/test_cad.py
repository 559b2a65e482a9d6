# SPDX-License-Identifier: LGPL-2.1-or-later
"""CAD files and shapes of the document become parts, meshed by the kernel's own reader."""

import os

import FreeCAD
import Import
import numpy as np
import Part

from freecad.sheetmorph import api
from freecad.sheetmorph.bridge import kernel
from freecad.sheetmorph.tests import support

SIZES = {"edge": 6.0, "deflection": 0.1, "angle": 20.0}
Vector = FreeCAD.Vector


def plate():
    """Return a plate of 60 x 40 x 2 mm with holes of radius 3 mm and 5 mm."""
    shape = Part.makeBox(60, 40, 2)
    for x, radius in ((15, 3), (40, 5)):
        shape = shape.cut(Part.makeCylinder(radius, 4, Vector(x, 20, -1)))
    return shape


def of_kind(part, kind: str) -> list[dict]:
    """Return the exact features of one kind, by radius."""
    found = [feature for feature in api.exact_features(part) if feature["kind"] == kind]
    return sorted(found, key=lambda feature: feature.get("radius", 0.0))


class CadTest(support.DocumentTest):
    def setUp(self):
        super().setUp()
        self.assembly = api.create_assembly(self.document)

    def add(self, shape, label: str = "Plate"):
        """Return a new Part::Feature of the document."""
        feature = self.document.addObject("Part::Feature", "Shape")
        feature.Label = label
        feature.Shape = shape
        return feature

    def bend(self, part) -> dict[str, np.ndarray]:
        """Clamp one end of the plate, lift the other, keep the wide hole; return positions."""
        points, _ = api.rest_mesh(part)
        hole = of_kind(part, "round hole")[-1]
        api.add_fixed(self.assembly, part, np.flatnonzero(points[:, 0] < 1e-6))
        tip = np.flatnonzero(points[:, 0] > 60 - 1e-6)
        api.add_feature(self.assembly, part, hole["vertices"])
        api.set_motion(api.add_handle(self.assembly, part, tip), (0, 0, 8))
        self.document.recompute()
        return api.deform(self.assembly)


class TestShapes(CadTest):
    def test_a_shape_of_the_document_becomes_a_part_with_exact_holes(self):
        source = self.add(plate())
        (part,) = api.add_shape(self.assembly, source, "cover", mesh=SIZES)
        self.assertEqual((part.Label, source.Visibility), ("cover", False))
        narrow, wide = of_kind(part, "round hole")
        self.assertAlmostEqual(narrow["radius"], 3.0, delta=1e-13)
        self.assertAlmostEqual(wide["radius"], 5.0, delta=1e-13)
        self.assertLess(support.largest(np.array(wide["center"]) - (40, 20, 1)), 1e-12)
        rest, _ = api.rest_mesh(part)
        gaps = np.hypot(*(rest[wide["vertices"]][:, :2] - (40, 20)).T) - 5.0
        self.assertLess(np.abs(gaps).max(), 1e-12)
        moved = self.bend(part)[part.Name]
        spans = [
            np.linalg.norm(rim[:, None] - rim[None], axis=2)
            for rim in (rest[wide["vertices"]], moved[wide["vertices"]])
        ]
        self.assertLess(np.abs(spans[0] - spans[1]).max(), 1e-9)

    def test_a_moved_shape_is_taken_where_it_is_seen(self):
        source = self.add(plate())
        source.Placement = support.placement((100, 0, 7), (1, 0, 0), 90)
        (part,) = api.add_shape(self.assembly, source, "lid", SIZES)
        wide = of_kind(part, "round hole")[-1]
        self.assertLess(support.largest(np.array(wide["center"]) - (140, -1, 27)), 1e-9)
        self.assertLess(support.largest(np.abs(wide["axis"]) - (0, 1, 0)), 1e-12)

    def test_features_go_with_a_part_that_is_moved_and_vanish_when_it_is_edited(self):
        (part,) = api.add_shape(self.assembly, self.add(plate()), mesh=SIZES)
        part.Source.Placement = support.placement((0, 0, 50))
        wide = of_kind(part, "round hole")[-1]
        self.assertLess(support.largest(np.array(wide["center"]) - (40, 20, 51)), 1e-9)
        edited = part.Source.Mesh.copy()
        edited.translate(0, 0, 1)
        part.Source.Mesh = edited
        self.assertEqual(api.exact_features(part), [])

    def test_every_solid_of_a_shape_is_a_part(self):
        both = Part.makeCompound([plate(), Part.makeSphere(5, Vector(100, 0, 0))])
        parts = api.add_shape(self.assembly, self.add(both), "Kit", mesh=SIZES)
        self.assertEqual([part.Label for part in parts], ["Kit.1", "Kit.2"])
        (ball,) = of_kind(parts[1], "sphere")
        self.assertAlmostEqual(ball["radius"], 5.0, delta=1e-12)

    def test_what_has_no_faces_is_refused(self):
        line = self.add(Part.makeLine(Vector(), Vector(1, 0, 0)), "Line")
        with self.assertRaisesRegex(ValueError, "Line"):
            api.add_shape(self.assembly, line)
        with self.assertRaisesRegex(ValueError, "add_shape"):
            api.add_part(self.assembly, self.add(plate()))
        self.assertEqual(len(self.assembly.Group), 1)


class TestFiles(CadTest):
    def export(self, name: str) -> str:
        """Return the path of a STEP file of a plate and two pins."""
        path = os.path.join(self.folder, name)
        pin = Part.makeCylinder(3, 8)
        shapes = [self.add(plate(), "cover"), self.add(pin, "pin"), self.add(pin, "other pin")]
        for shape, x in zip(shapes[1:], (15, 100)):
            shape.Placement.Base = Vector(x, 20, -3)
        Import.export(shapes, path)
        for shape in shapes:
            self.document.removeObject(shape.Name)
        return path

    def test_every_solid_of_a_file_is_a_part_under_its_name(self):
        parts = api.import_cad(self.assembly, self.export("kit.step"), SIZES)
        self.assertEqual([part.Label for part in parts], ["cover", "pin", "pin 2"])
        self.assertEqual(self.assembly.Primary, parts[0])
        self.assertEqual(len(of_kind(parts[0], "round hole")), 2)
        self.assertEqual(of_kind(parts[1], "round hole"), [])
        self.assertAlmostEqual(of_kind(parts[2], "cylinder")[0]["radius"], 3.0, delta=1e-12)

    def test_solids_that_are_sheets_bend_as_sheets_however_they_come_in(self):
        path = self.export("kit.step")
        one = os.path.join(self.folder, "one.step")
        plate().exportStep(one)
        come_in = {
            "imported": api.import_cad(self.assembly, path, SIZES)[0],
            "one part": api.import_part(self.assembly, one, mesh=SIZES),
            "of the document": api.add_shape(self.assembly, self.add(plate()), mesh=SIZES)[0],
        }
        for way, part in come_in.items():
            self.assertEqual(part.Thin, "automatic", way)
            solid, reason = api.thin_solid(part)
            self.assertEqual(reason, "", way)
            self.assertAlmostEqual(solid.thickness, 2.0, delta=1e-6)

    def test_a_recipe_says_whether_a_shape_bends_as_a_sheet(self):
        plate().exportStep(os.path.join(self.folder, "plate.step"))
        for said, thin in (("", "automatic"), (', "thin": false', "no")):
            recipe = os.path.join(self.folder, "recipe.json")
            with open(recipe, "w", encoding="utf-8") as file:
                file.write(
                    '{"sheetmorph": 1, "parts": [{"name": "plate", "file": "plate.step"'
                    f'{said}}}], "fixed": [{{"part": "plate", "vertices": [0, 1, 2]}}]}}'
                )
            read = api.import_recipe(self.document, recipe)
            self.assertEqual(read.Primary.Thin, thin)
            again = api.import_recipe(
                self.document, api.export_recipe(read, os.path.join(self.folder, "again.json"))
            )
            self.assertEqual(again.Primary.Thin, thin)

    def test_deformed_parts_are_written_as_obj(self):
        cover = api.import_cad(self.assembly, self.export("kit.step"), SIZES)[0]
        exact = self.bend(cover)[cover.Name]
        paths = api.write_parts(self.assembly, os.path.join(self.folder, "out"))
        self.assertEqual(paths[0].name, "cover.obj")
        written = kernel.load().read_part(paths[0]).mesh.points
        np.testing.assert_array_equal(written, exact)

    def test_a_recipe_of_a_cad_file_is_the_same_in_a_document(self):
        parts = api.import_cad(self.assembly, self.export("kit.step"), SIZES)
        recipe = os.path.join(self.folder, "recipe.json")
        with open(recipe, "w", encoding="utf-8") as file:
            file.write(
                '{"sheetmorph": 1, "primary": "kit/cover", "parts": [{"file": "kit.step", '
                '"split": true, "mesh": {"edge": 6, "deflection": 0.1, "angle": 20}}], '
                '"fixed": [{"part": "kit/cover", "vertices": [0, 1, 2]}]}'
            )
        read = api.import_recipe(self.document, recipe)
        names = [part.Label for part in read.Group if hasattr(part, "RestData")]
        self.assertEqual(names, ["kit/cover", "kit/pin", "kit/pin 2"])
        rests = [api.rest_mesh(part)[0] for part in (read.Primary, parts[0])]
        np.testing.assert_array_equal(*rests)

    def test_a_file_that_cannot_be_read_leaves_the_document_as_it_was(self):
        path = os.path.join(self.folder, "broken.step")
        with open(path, "w", encoding="utf-8") as file:
            file.write("nothing")
        before = len(self.document.Objects)
        with self.assertRaisesRegex(ValueError, "STEP"):
            api.import_cad(self.assembly, path)
        with self.assertRaisesRegex(ValueError, "import_part"):
            api.import_cad(self.assembly, os.path.join(self.folder, "mesh.obj"))
        self.assertEqual(len(self.document.Objects), before)

    def test_features_are_saved_with_the_document(self):
        cover = api.import_cad(self.assembly, self.export("kit.step"), SIZES)[0]
        before, name = api.exact_features(cover), cover.Name
        self.assertGreater(len(before), 2)
        self.document.recompute()
        restored = self.reopen(self.document)
        self.assertEqual(api.exact_features(restored.getObject(name)), before)

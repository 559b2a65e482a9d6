# SPDX-License-Identifier: LGPL-2.1-or-later
"""Parts from files are kept in double and written back with only their coordinates changed."""

import json
import os
import unittest

import numpy as np

from freecad.sheetmorph import api, objects
from freecad.sheetmorph.bridge import kernel
from freecad.sheetmorph.tests import support

FAR = np.array([2.0e5 + 1 / 3, -1.0e5 + 1 / 7, 3.0e5])


class FileTest(support.DocumentTest):
    def setUp(self):
        super().setUp()
        self.points, self.triangles = support.strip()
        self.assembly = api.create_assembly(self.document)
        self.output = os.path.join(self.folder, "out")

    def write(self, name: str, points: np.ndarray) -> str:
        path = os.path.join(self.folder, name)
        support.write_obj(path, points, self.triangles)
        return path

    def import_and_lift(self, points: np.ndarray, name: str = "strip.obj"):
        """Import a strip, clamp it, lift its tip by 30 mm, and return the part."""
        part = api.import_part(self.assembly, self.write(name, points))
        api.add_fixed(self.assembly, part, support.left_edge(self.points))
        handle = api.add_handle(self.assembly, part, support.right_edge(self.points))
        api.set_motion(handle, (0, 0, 30))
        return part

    def read(self, name: str) -> np.ndarray:
        return kernel.load().read_part(os.path.join(self.output, name)).mesh.points


class TestImport(FileTest):
    def test_rest_positions_are_those_of_the_file_in_double(self):
        part = api.import_part(self.assembly, self.write("far.obj", self.points + FAR))
        points, triangles = api.rest_mesh(part)
        np.testing.assert_array_equal(points, self.points + FAR)
        np.testing.assert_array_equal(triangles, self.triangles)
        self.assertEqual((part.Label, part.FileName), ("far", "far.obj"))

    def test_a_mesh_of_freecad_has_single_precision(self):
        part = api.add_part(
            self.assembly, self.add_source(mesh=(self.points + FAR, self.triangles))
        )
        error = support.largest(api.rest_mesh(part)[0] - (self.points + FAR))
        self.assertGreater(error, 1e-3)

    def test_an_import_far_away_is_shown_precisely(self):
        part = self.import_and_lift(self.points + FAR)
        self.document.recompute()
        self.assert_up_to_date(self.document)
        self.assertLess(np.abs(support.local_points(part)).max(), 400.0)
        exact = api.deform(self.assembly)[part.Name]
        self.assertLess(support.largest(support.seen_points(part) - exact), 1e-4)

    def test_a_moved_import_is_deformed_where_it_is_seen(self):
        part = self.import_and_lift(self.points + FAR)
        part.Source.Placement = support.placement((1, 2, 3), (0, 1, 0), 90)
        self.document.recompute()
        rest, _ = api.rest_mesh(part)
        self.assertLess(support.largest(support.seen_points(part.Source) - rest), 1e-4)
        tip = support.right_edge(self.points)
        moved = support.seen_points(part)[tip] - rest[tip]
        self.assertLess(support.largest(moved - (0, 0, 30)), 1e-4)

    def test_an_edited_import_is_taken_as_it_is_now(self):
        part = api.import_part(self.assembly, self.write("strip.obj", self.points + 1 / 3))
        edited = part.Source.Mesh.copy()
        edited.translate(0, 0, 1)
        part.Source.Mesh = edited
        points, _ = api.rest_mesh(part)
        self.assertLess(support.largest(points - self.points - 1 / 3 - (0, 0, 1)), 1e-4)

    def test_bad_files_are_refused_and_nothing_is_added(self):
        bad = os.path.join(self.folder, "bad.obj")
        with open(bad, "w", encoding="ascii") as file:
            file.write("v 0 0 zero\n")
        count = len(self.document.Objects)
        for path in (bad, os.path.join(self.folder, "none.obj"), self.folder):
            with self.subTest(path), self.assertRaises((ValueError, OSError)):
                api.import_part(self.assembly, path)
        self.assertEqual(len(self.document.Objects), count)


class TestWriting(FileTest):
    def test_a_written_part_is_its_file_with_other_coordinates(self):
        part = self.import_and_lift(self.points + FAR)
        written = api.write_parts(self.assembly, self.output)
        self.assertIn("strip.obj", [path.name for path in written])
        exact = api.deform(self.assembly)[part.Name]
        np.testing.assert_array_equal(self.read("strip.obj"), exact)
        with open(os.path.join(self.output, "strip.obj"), encoding="ascii") as file:
            self.assertEqual(file.readlines()[:2], ["# drawn by hand\n", "g sheet\n"])

    def test_the_report_is_written_beside(self):
        self.import_and_lift(self.points)
        api.write_parts(self.assembly, self.output)
        with open(os.path.join(self.output, "report.json"), encoding="utf-8") as file:
            self.assertIsInstance(json.load(file), dict)

    def test_a_mesh_of_freecad_is_written_as_obj_in_double(self):
        _, part, handle = self.add_morph()
        part.Label = "door: left/right"
        api.set_motion(handle, (0, 0, 1 / 3), (0, 1, 0), 1)
        assembly = objects.assembly_of(part)
        written = api.write_parts(assembly, self.output)
        self.assertEqual(written[0].name, "door_ left_right.obj")
        np.testing.assert_array_equal(self.read(written[0].name), api.deform(assembly)[part.Name])

    def test_equal_names_do_not_overwrite_each_other(self):
        self.import_and_lift(self.points)
        os.mkdir(self.output)
        other = os.path.join(self.output, "strip.obj")
        support.write_obj(other, self.points + 1.0, self.triangles)
        second = api.import_part(self.assembly, other)
        api.add_fixed(self.assembly, second, [0, 1, 2])
        os.remove(other)
        names = [path.name for path in api.write_parts(self.assembly, self.output)]
        self.assertEqual(len(set(names)), 3)
        np.testing.assert_array_equal(self.read(names[1]), self.points + 1.0)

    def test_the_document_is_enough_to_write_the_file(self):
        self.import_and_lift(self.points + FAR)
        os.remove(os.path.join(self.folder, "strip.obj"))
        self.document = self.reopen(self.document)
        assembly = self.document.getObject("Morph")
        api.write_parts(assembly, self.output)
        part = self.document.getObject("Part")
        np.testing.assert_array_equal(self.read("strip.obj"), api.deform(assembly)[part.Name])

    def test_nothing_is_written_when_the_morph_fails(self):
        self.import_and_lift(self.points)
        handle = self.document.getObjectsByLabel("Handle")[0]
        handle.Vertices = []
        with self.assertRaisesRegex(ValueError, "Handle"):
            api.write_parts(self.assembly, self.output)
        self.assertFalse(os.path.exists(self.output))


if __name__ == "__main__":
    unittest.main()

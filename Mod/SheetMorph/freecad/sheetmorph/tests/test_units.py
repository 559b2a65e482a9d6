# SPDX-License-Identifier: LGPL-2.1-or-later
"""Lengths and angles as they are typed and read, and arrays as documents keep them."""

import json
import os
import tempfile
import unittest

import FreeCAD
import numpy as np

from freecad.sheetmorph.bridge import stored_arrays, units
from freecad.sheetmorph.bridge.rest import read_rest_data

STANDARD, METRES, INCHES, CIVIL = 0, 1, 3, 7


class TestUnits(unittest.TestCase):
    def setUp(self):
        self.addCleanup(FreeCAD.Units.setSchema, FreeCAD.Units.getSchema())

    def said(self, schema: int, value: float, unit: str = "mm") -> tuple[str, float]:
        FreeCAD.Units.setSchema(schema)
        return units.said(value, unit)

    def test_lengths_of_sheets_are_read_in_millimetres(self):
        for value, text in (
            (0.0, "0.00 mm"),
            (0.0008, "0.0008 mm"),
            (-0.05, "-0.05 mm"),
            (1e-17, "0.00 mm"),
            (1.23456, "1.23 mm"),
            (12345.678, "12345.68 mm"),
        ):
            self.assertEqual(self.said(STANDARD, value), (text, 1.0))

    def test_who_has_chosen_other_units_reads_those_but_no_nanometres(self):
        self.assertEqual(self.said(INCHES, 25.4), ("1.00 in", 25.4))
        self.assertEqual(self.said(METRES, 25000.0), ("25.00 m", 1000.0))  # 1.1: from 10 m on
        self.assertEqual(self.said(METRES, 0.0008), ("0.0008 mm", 1.0))

    def test_angles_are_read_in_degrees(self):
        """FreeCAD's civil engineers read -0.5 degrees as -1°30′."""
        for schema in (STANDARD, INCHES, CIVIL):
            self.assertEqual(self.said(schema, -0.5, "deg"), ("-0.50 °", 1.0))

    def test_what_is_typed_is_a_number_or_nothing(self):
        for text, value in (
            ("2 cm", 20.0),
            ("12,5", 12.5),
            ("3*4 mm", 12.0),
            ("1/0", None),
            ("nan", None),
            ("5 kg", None),
            ("", None),
        ):
            self.assertEqual(units.number_in(text, "mm"), value, text)
        self.assertAlmostEqual(units.number_in("1'2\"", "mm"), 355.6, delta=1e-12)
        self.assertEqual(units.number_in("2", "mm", 25.4), 50.8)
        self.assertEqual(units.number_in("2 mm", "mm", 25.4), 2.0)


class TestStoredArrays(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.path = os.path.join(folder.name, "some.npz")

    def test_arrays_and_texts_come_back(self):
        some = np.linspace(0.0, 1.0, 3000).reshape(-1, 3)
        stored_arrays.write(self.path, some=some, text=stored_arrays.of_text("Blech, 板"))
        with np.load(self.path, allow_pickle=False) as data:
            self.assertTrue(np.array_equal(data["some"], some))
            self.assertEqual(stored_arrays.text_in(data["text"]), "Blech, 板")
        self.assertLess(os.path.getsize(self.path), some.nbytes)

    def test_a_document_of_before_is_read(self):
        """It has the triangles themselves, and texts of four bytes a character."""
        points, triangles = np.eye(3), np.array([[0, 1, 2]], np.int32)
        known = {"ids": np.zeros(0, np.int64), "origin": np.zeros(3)}
        features = np.array(json.dumps([{"kind": "plane"}]))
        np.savez(self.path, points=points, triangles=triangles, features=features, **known)
        stored = read_rest_data(self.path)
        self.assertEqual(stored["features"], [{"kind": "plane"}])
        self.assertTrue(np.array_equal(stored["points"], points))


if __name__ == "__main__":
    unittest.main()

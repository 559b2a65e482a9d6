# SPDX-License-Identifier: LGPL-2.1-or-later
"""Thin solids in documents: recognised, switched on and off, saved, exchanged as recipes."""

import unittest

import numpy as np

from freecad.sheetmorph import api
from freecad.sheetmorph.tests.support import DocumentTest, left_edge, right_edge, strip

THICKNESS = 2.0


def thick_strip():
    """The strip as a closed solid: points, triangles, count; vertex i is above count + i."""
    points, triangles = strip()
    count = len(points)
    edges = np.concatenate([triangles[:, [k, (k + 1) % 3]] for k in range(3)])
    used = {tuple(edge) for edge in edges.tolist()}
    border = np.array([edge for edge in edges.tolist() if (edge[1], edge[0]) not in used])
    a, b = border[:, 0], border[:, 1]
    walls = [np.stack([b, a, a + count], axis=1), np.stack([b, a + count, b + count], axis=1)]
    solid = np.concatenate([triangles, triangles[:, ::-1] + count, *walls]).astype(np.int32)
    return np.concatenate([points, points - [0.0, 0.0, THICKNESS]]), solid, count


class TestThinSolids(DocumentTest):
    def setUp(self) -> None:
        super().setUp()
        self.points, self.triangles, self.count = thick_strip()
        self.assembly = api.create_assembly(self.document)
        source = self.add_source(mesh=(self.points, self.triangles))
        self.part = api.add_part(self.assembly, source)
        api.add_fixed(self.assembly, self.part, left_edge(self.points))
        self.handle = api.add_handle(self.assembly, self.part, right_edge(self.points))

    def deformed(self) -> np.ndarray:
        """The part lifted and turned at its end."""
        api.set_motion(self.handle, (-10, 0, 40), axis=(0, 1, 0), angle=-25)
        self.document.recompute()
        return api.deform(self.assembly)[self.part.Name]

    def gaps(self, positions: np.ndarray) -> np.ndarray:
        """Distances of the vertices of the upper skin to those under them."""
        upper, lower = positions[: self.count], positions[self.count : 2 * self.count]
        return np.linalg.norm(upper - lower, axis=1)

    def test_a_part_is_taken_as_it_is_until_it_is_said_to_be_thin(self):
        self.assertEqual(self.part.Thin, "no")
        self.assertTrue(api.propose_thin(self.part))
        self.assertEqual(self.part.Thin, "automatic")
        flat = api.add_part(self.assembly, self.add_source("Flat"))
        self.assertFalse(api.propose_thin(flat))
        self.assertEqual(flat.Thin, "no")

    def test_a_thin_solid_keeps_its_thickness(self):
        api.set_thin(self.part, "auto")
        self.assertLess(np.abs(self.gaps(self.deformed()) / THICKNESS - 1.0).max(), 0.005)

    def test_a_given_thickness_is_shown_and_must_fit(self):
        api.set_thin(self.part, 2.0)
        self.assertEqual(self.part.Thickness.Value, 2.0)
        self.assertLess(np.abs(self.gaps(self.deformed()) / THICKNESS - 1.0).max(), 0.005)
        api.set_thin(self.part, 9.0)
        self.document.recompute()
        self.assertIn("it is not a thin solid", self.assembly.Status)
        for nonsense in ("yes", True, 0.0, -1.0):
            with self.assertRaises(ValueError):
                api.set_thin(self.part, nonsense)

    def test_holes_become_features_through_both_skins_once(self):
        holes = api.add_through_holes(self.assembly, self.part)
        self.assertEqual(len(holes), 3)
        self.assertEqual(api.add_through_holes(self.assembly, self.part), [])
        solid, reason = api.thin_solid(self.part)
        self.assertEqual(reason, "")
        self.assertEqual(api.vertices(holes[0]), solid.holes[0].vertices.tolist())

    def test_saved_opened_and_exchanged_as_a_recipe_it_stays_thin(self):
        api.set_thin(self.part, "auto")
        expected = self.deformed()
        recipe = api.export_recipe(self.assembly, f"{self.folder}/morph.json")
        other = self.new_document()
        again = api.import_recipe(other, recipe)
        (part,) = [obj for obj in again.Group if obj.isDerivedFrom("Mesh::Feature")]
        self.assertEqual(part.Thin, "automatic")
        other.recompute()
        self.assertLess(np.abs(api.deform(again)[part.Name] - expected).max(), 1e-9)
        name = self.part.Name
        self.assertEqual(self.reopen(self.document).getObject(name).Thin, "automatic")


if __name__ == "__main__":
    unittest.main()

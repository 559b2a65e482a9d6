# SPDX-License-Identifier: LGPL-2.1-or-later
"""Preparing meshes in documents: the source stays, what was picked follows, undo brings it back."""

import unittest

import numpy as np

from freecad.sheetmorph import api
from freecad.sheetmorph.tests.support import DocumentTest, largest, left_edge, local_points
from freecad.sheetmorph.tests.support import right_edge, seen_points, write_obj
from freecad.sheetmorph.tests.test_thin import thick_strip


def shattered(points: np.ndarray, triangles: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """The same triangles, each with vertices of its own, as an STL file has them."""
    return points[triangles].reshape(-1, 3), np.arange(triangles.size).reshape(-1, 3)


class TestSplitting(DocumentTest):
    def setUp(self) -> None:
        super().setUp()
        points, triangles, _ = thick_strip()
        both = np.concatenate([points, points[:, [1, 0, 2]] * 0.5 + (0.0, 0.0, 50.0)])
        turned = triangles[:, [0, 2, 1]] + len(points)
        self.points, self.count = both, len(points)
        self.assembly = api.create_assembly(self.document)
        mesh = (both, np.concatenate([triangles, turned]))
        self.source = self.add_source(mesh=mesh)
        self.part = api.add_part(self.assembly, self.source, "two")
        api.set_thin(self.part, "auto")
        self.document.recompute()

    def test_every_piece_is_a_part_and_the_largest_the_primary(self):
        made = api.split_part(self.part)
        self.document.recompute()
        self.assert_up_to_date(self.document)
        self.assertEqual([part.Label for part in made], ["two 1", "two 2"])
        self.assertEqual(self.assembly.Primary, made[0])
        self.assertEqual({part.Thin for part in made}, {"automatic"})
        self.assertFalse(self.source.Visibility)
        rest = np.concatenate([api.rest_mesh(part)[0] for part in made])
        self.assertLess(largest(rest - self.points), 1e-4)
        self.assertEqual(api.split_part(made[1]), [made[1]])

    def test_what_is_marked_is_not_torn(self):
        marked = api.add_fixed(self.assembly, self.part, [0, 1, 2])
        with self.assertRaisesRegex(ValueError, "split the part first, then mark its pieces"):
            api.split_part(self.part)
        self.assertEqual(marked.Part, self.part)


class TestPreparing(DocumentTest):
    def setUp(self) -> None:
        super().setUp()
        self.points, self.triangles, _ = thick_strip()
        self.assembly = api.create_assembly(self.document)
        self.source = self.add_source(mesh=(self.points, self.triangles))
        self.part = api.add_part(self.assembly, self.source)
        api.set_thin(self.part, "auto")
        self.clamp = api.add_fixed(self.assembly, self.part, left_edge(self.points))
        self.handle = api.add_handle(self.assembly, self.part, right_edge(self.points))
        self.holes = api.add_through_holes(self.assembly, self.part)
        self.document.recompute()

    def prepare(self, **wish) -> dict:
        """Prepare the part as one undo step."""
        self.document.openTransaction("Prepare Mesh")
        done = api.prepare(self.part, **wish)
        self.document.commitTransaction()
        self.document.recompute()
        return done

    def bend(self) -> np.ndarray:
        """The part bent, global positions."""
        api.set_motion(self.handle, (-10, 0, 40), axis=(0, 1, 0), angle=-25)
        self.document.recompute()
        self.assert_up_to_date(self.document)
        return api.deform(self.assembly)[self.part.Name]

    def test_the_new_mesh_lies_on_the_old_one_and_the_source_stays(self):
        before = local_points(self.source)
        done = self.prepare(edge=8.0)
        self.assertLess(done["remesh"]["flat_deviation"], 1e-9)
        self.assertEqual(largest(local_points(self.source) - before), 0.0)
        self.assertEqual(self.part.Original, self.source)
        points, _ = api.rest_mesh(self.part)
        self.assertNotEqual(len(points), len(before))
        self.assertLess(largest(points.max(axis=0) - before.max(axis=0)), 1e-9)

    def test_what_was_picked_follows(self):
        self.prepare(edge=8.0)
        points, _ = api.rest_mesh(self.part)
        clamp = points[api.vertices(self.clamp)]
        self.assertGreater(len(clamp), 10)
        self.assertLess(clamp[:, 0].max(), 15.0)
        solid, _ = api.thin_solid(self.part)
        holes = sorted(hole.vertices.tolist() for hole in solid.holes)
        self.assertEqual(sorted(api.vertices(hole) for hole in self.holes), holes)
        bent = self.bend()
        self.assertLess(largest(bent[api.vertices(self.clamp)] - clamp), 1e-12)

    def test_prepared_twice_it_begins_with_the_source_again(self):
        self.prepare(edge=20.0)
        api.set_vertices(self.clamp, left_edge(api.rest_mesh(self.part)[0]))
        self.prepare(edge=8.0)
        once = api.preparation(self.part, edge=8.0)
        points, _ = api.rest_mesh(self.part)
        self.assertLess(largest(points - once.points), 1e-12)
        self.assertGreater(len(api.vertices(self.clamp)), 10)
        self.assertEqual(self.part.Original, self.source)
        prepared = [obj for obj in self.document.Objects if obj.Name.startswith("Prepared")]
        self.assertEqual(prepared, [self.part.Source])
        self.bend()

    def test_undo_and_redo(self):
        rest = api.rest_mesh(self.part)[0]
        regions = [api.vertices(self.clamp), api.vertices(self.handle)]
        self.document.clearUndos()
        self.prepare(edge=8.0)
        fresh = api.rest_mesh(self.part)[0]
        self.document.undo()
        self.document.recompute()
        self.assertEqual(largest(api.rest_mesh(self.part)[0] - rest), 0.0)
        self.assertEqual([api.vertices(self.clamp), api.vertices(self.handle)], regions)
        self.assertIsNone(self.part.Original)
        self.document.redo()
        self.document.recompute()
        self.assertEqual(largest(api.rest_mesh(self.part)[0] - fresh), 0.0)
        self.bend()

    def test_saved_and_opened_it_is_the_same(self):
        self.prepare(edge=8.0)
        expected, name, rest = self.bend(), self.part.Name, api.rest_mesh(self.part)[0]
        opened = self.reopen(self.document)
        part = opened.getObject(name)
        self.assertEqual(largest(api.rest_mesh(part)[0] - rest), 0.0)
        self.assertLess(largest(seen_points(part) - expected), 1e-3)

    def test_a_soup_of_an_imported_file_is_welded_and_scaled(self):
        path = f"{self.folder}/soup.obj"
        points, triangles = shattered(self.points / 1000.0 + 0.002, self.triangles)
        write_obj(path, points, triangles)
        other = api.create_assembly(self.document)
        part = api.import_part(other, path)
        self.assertIn("m", api.diagnose(part)["unit"]["plausible"])
        done = api.prepare(part, weld=1e-4, edge=10.0, scale=1000.0)
        self.assertGreater(done["welded"], 0)
        rest = api.rest_mesh(part)[0]
        self.assertLess(largest(rest.min(axis=0) - (self.points.min(axis=0) + 2.0)), 1e-9)
        self.assertTrue(api.propose_thin(part))
        self.document.recompute()
        (file, *_) = api.write_parts(other, f"{self.folder}/out")
        self.assertEqual(file.suffix, ".obj")

    def test_a_moved_source_keeps_its_place(self):
        self.source.Placement.Base = (100, 20, 5)
        self.document.recompute()
        before = api.rest_mesh(self.part)[0]
        self.prepare(edge=8.0)
        after = api.rest_mesh(self.part)[0]
        self.assertLess(largest(after.max(axis=0) - before.max(axis=0)), 1e-9)
        self.assertLess(largest(after.min(axis=0) - before.min(axis=0)), 1e-9)

    def test_removed_it_leaves_the_source_alone(self):
        self.prepare(edge=8.0)
        prepared = self.part.Source.Name
        api.remove(self.part)
        self.assertIsNone(self.document.getObject(prepared))
        self.assertTrue(self.source.Visibility)

    def test_what_makes_no_sense_changes_nothing(self):
        rest = api.rest_mesh(self.part)[0]
        for wish in (
            {"edge": 0.0},
            {"edge": -1},
            {"rims": "square", "edge": 5},
            {"weld": -1},
            {"edgy": 5},
        ):
            with self.assertRaises(ValueError):
                api.prepare(self.part, **wish)
        self.assertIsNone(self.part.Original)
        self.assertEqual(largest(api.rest_mesh(self.part)[0] - rest), 0.0)


if __name__ == "__main__":
    unittest.main()

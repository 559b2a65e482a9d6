# SPDX-License-Identifier: LGPL-2.1-or-later
"""A mesh of the document is read once for all who need it, and anew as soon as it changes."""

from unittest import mock

import FreeCAD
import numpy as np

from freecad.sheetmorph import api
from freecad.sheetmorph.bridge import conversion
from freecad.sheetmorph.bridge.snapshots import Snapshot, snapshot_of
from freecad.sheetmorph.bridge.rest import read_rest
from freecad.sheetmorph.tests import support


def counted():
    """Return a patch under which readings of meshes are counted."""
    return mock.patch.object(conversion, "read_mesh", wraps=conversion.read_mesh)


def moved(mesh, z: float):
    """Return a copy of a mesh, shifted."""
    copied = mesh.copy()
    copied.translate(0, 0, z)
    return copied


class TestSnapshots(support.DocumentTest):
    def height(self, source) -> float:
        return float(snapshot_of(source).points[:, 2].max())

    def test_a_mesh_is_read_once_for_all(self):
        assembly, part, handle = self.add_morph()
        for rim in api.hole_rims(part):
            api.add_feature(assembly, part, rim)
        self.document.recompute()
        with counted() as read:
            api.set_motion(handle, (0, 0, 5))
            self.document.recompute()
            api.rest_mesh(part)
            api.face(part, 3)
            api.pivot(handle)
        self.assertEqual(read.call_count, 0)

    def test_what_was_worked_out_at_rest_is_kept(self):
        _, part, _ = self.add_morph()
        self.assertIs(read_rest(part), read_rest(part))
        part.Label = "Another name"
        self.assertEqual(read_rest(part).label, "Another name")

    def test_a_moved_source_rests_elsewhere(self):
        _, part, _ = self.add_morph()
        before = read_rest(part).points
        part.Source.Placement = support.placement((1, 2, 3), (0, 0, 1), 90)
        after = read_rest(part).points
        frame = support.matrix(part.Source.Placement)
        self.assertLess(support.largest(before @ frame[:3, :3].T + frame[:3, 3] - after), 1e-9)

    def test_a_changed_mesh_is_read_again(self):
        source = self.add_source()
        self.assertEqual(self.height(source), 0.0)
        source.Mesh = moved(source.Mesh, 4.0)
        self.assertEqual(self.height(source), 4.0)

    def test_undo_and_redo_are_changes(self):
        source = self.add_source()
        self.document.openTransaction("Lift")
        source.Mesh = moved(source.Mesh, 4.0)
        self.document.commitTransaction()
        for step, height in (("undo", 0.0), ("redo", 4.0), ("undo", 0.0)):
            getattr(self.document, step)()
            self.assertEqual(self.height(source), height)

    def test_an_object_of_the_same_name_is_another_one(self):
        source = self.add_source()
        self.assertEqual(self.height(source), 0.0)
        lifted, name = moved(source.Mesh, 2.0), source.Name
        self.document.removeObject(name)
        again = self.document.addObject("Mesh::Feature", name)
        again.Mesh = lifted
        self.assertEqual((again.Name, self.height(again)), (name, 2.0))

    def test_a_document_of_the_same_name_is_another_one(self):
        heights = []
        for height in (0.0, 3.0):
            document = FreeCAD.newDocument("SheetMorphTwin")
            source = self.add_source(document=document)
            source.Mesh = moved(source.Mesh, height)
            heights.append(self.height(source))
            FreeCAD.closeDocument(document.Name)
        self.assertEqual(heights, [0.0, 3.0])

    def test_a_saved_morph_is_read_as_it_was(self):
        _, part, _ = self.add_morph()
        points, name = api.rest_mesh(part)[0], part.Name
        reopened = self.reopen(self.document)
        np.testing.assert_array_equal(api.rest_mesh(reopened.getObject(name))[0], points)

    def test_what_scripts_get_is_theirs(self):
        _, part, _ = self.add_morph()
        points, triangles = api.rest_mesh(part)
        points[:], triangles[:] = 0.0, 0
        self.assertGreater(np.ptp(api.rest_mesh(part)[0][:, 0]), 100.0)
        with self.assertRaises(ValueError):
            read_rest(part).points[0] = 0.0
        with self.assertRaises(ValueError):
            snapshot_of(part.Source).triangles[0] = 0

    def test_the_triangles_at_vertices_are_found(self):
        snapshot = Snapshot(self.add_source().Mesh)
        chosen = np.random.default_rng(3).choice(len(snapshot.points), 25, replace=False)
        is_at = np.isin(snapshot.triangles, chosen).any(axis=1)
        np.testing.assert_array_equal(snapshot.touching(chosen), snapshot.triangles[is_at])
        self.assertEqual(snapshot.touching(np.array([], int)).shape, (0, 3))
        self.assertEqual(snapshot.touching(np.array([-1, 10**6])).shape, (0, 3))

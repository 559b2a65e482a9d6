# SPDX-License-Identifier: LGPL-2.1-or-later
"""Undo, redo and abort bring back the documents exactly."""

import unittest

import numpy as np

from freecad.sheetmorph import api, objects
from freecad.sheetmorph.bridge import solving
from freecad.sheetmorph.tests import support


class UndoTest(support.DocumentTest):
    def setUp(self):
        super().setUp()
        self.assembly, self.part, self.handle = self.add_morph()
        self.document.recompute()

    def act(self, name: str, action) -> None:
        self.document.openTransaction(name)
        action()
        self.document.recompute()
        self.document.commitTransaction()

    def lift(self, height: float) -> None:
        self.act(f"Lift {height}", lambda: api.set_motion(self.handle, (0, 0, height)))

    def mesh(self) -> np.ndarray:
        return support.local_points(self.part)


class TestUndo(UndoTest):
    def test_undo_and_redo_of_a_motion_are_exact_at_once_and_after_a_recompute(self):
        seen = [self.mesh()]
        for height in (10, 20, 30):
            self.lift(height)
            seen.append(self.mesh())
        for expected in reversed(seen[:-1]):
            self.document.undo()
            np.testing.assert_array_equal(self.mesh(), expected)
            self.document.recompute()
            np.testing.assert_array_equal(self.mesh(), expected)
        for expected in seen[1:]:
            self.document.redo()
            np.testing.assert_array_equal(self.mesh(), expected)
        self.document.recompute()
        self.assert_up_to_date(self.document)
        self.assertEqual(self.handle.TranslationZ.Value, 30.0)

    def test_a_deletion_in_no_step_leaves_no_step_that_still_holds_what_is_gone(self):
        self.document.clearUndos()
        (fixed,) = [r for r in objects.regions(self.assembly) if r.Role == "fixed"]
        self.act("Pose", lambda: api.save_pose(self.assembly, "High"))
        self.assertEqual(self.document.UndoCount, 1)
        self.document.removeObject(fixed.Name)
        self.assertEqual((self.document.UndoCount, self.document.RedoCount), (0, 0))
        self.assertNotIn(None, self.assembly.Group)

    def test_abort_is_exact(self):
        self.lift(10)
        before = self.mesh()
        self.document.openTransaction("Drag")
        for height in (20, 30, 40):
            api.set_motion(self.handle, (0, 0, height), (0, 1, 0), height)
            self.document.recompute()
        self.document.abortTransaction()
        np.testing.assert_array_equal(self.mesh(), before)
        self.assertEqual(self.handle.TranslationZ.Value, 10.0)
        self.document.recompute()
        np.testing.assert_array_equal(self.mesh(), before)

    def test_adding_a_region_can_be_undone_and_redone(self):
        self.lift(30)
        before = self.mesh()
        rim = api.hole_rims(self.part)[1]
        self.act("Fix", lambda: api.add_fixed(self.assembly, self.part, rim))
        after = self.mesh()
        self.document.undo()
        self.document.recompute()
        self.assert_up_to_date(self.document)
        np.testing.assert_array_equal(self.mesh(), before)
        self.document.redo()
        self.document.recompute()
        self.assert_up_to_date(self.document)
        np.testing.assert_array_equal(self.mesh(), after)
        self.assertEqual(len(objects.regions(self.assembly)), 3)

    def test_changed_vertices_come_back(self):
        before = api.vertices(self.handle)
        self.act("Pick", lambda: api.set_vertices(self.handle, before[:5]))
        self.document.undo()
        self.assertEqual(api.vertices(self.handle), before)
        self.document.redo()
        self.assertEqual(api.vertices(self.handle), before[:5])

    def test_removing_a_part_can_be_undone(self):
        self.lift(30)
        before, name = self.mesh(), self.part.Name
        self.act("Delete", lambda: api.remove(self.part))
        self.assertEqual(objects.parts(self.assembly), [])
        self.document.undo()
        self.document.recompute()
        self.assert_up_to_date(self.document)
        self.part = self.document.getObject(name)
        np.testing.assert_array_equal(self.mesh(), before)
        self.assertFalse(self.part.Source.Visibility)
        self.assertEqual([r.Part for r in objects.regions(self.assembly)], [self.part] * 2)

    def test_making_a_whole_morph_is_one_step(self):
        count = len(self.document.Objects)
        source = self.add_source("Another")

        def make():
            _, _, handle = self.add_morph(source)
            api.set_motion(handle, (0, 0, 9))

        self.act("Make", make)
        self.document.undo()
        self.assertEqual(len(self.document.Objects), count + 1)
        self.document.redo()
        self.document.recompute()
        self.assert_up_to_date(self.document)
        part = self.document.getObjectsByLabel("Strip001")[0]
        self.assertAlmostEqual(support.largest(support.seen_points(part)[:, 2]), 9.0, 4)

    def test_importing_a_part_can_be_undone_and_redone_with_its_doubles(self):
        points, triangles = support.strip()
        path = f"{self.folder}/strip.obj"
        support.write_obj(path, points + 1 / 3, triangles)
        self.act("Import", lambda: api.import_part(self.assembly, path, "Imported"))
        self.document.undo()
        self.assertEqual(self.document.getObjectsByLabel("Imported"), [])
        self.document.redo()
        found, _ = api.rest_mesh(self.document.getObjectsByLabel("Imported")[0])
        np.testing.assert_array_equal(found, points + 1 / 3)
        self.act("Delete", lambda: api.remove(self.document.getObjectsByLabel("Imported")[0]))
        self.document.undo()
        opened = self.reopen(self.document)
        part = opened.getObjectsByLabel("Imported")[0]
        found, _ = api.rest_mesh(part)
        np.testing.assert_array_equal(found, points + 1 / 3)
        with open(part.FileData, encoding="ascii") as file:
            self.assertEqual(file.readline(), "# drawn by hand\n")


class TestCost(UndoTest):
    def test_a_pose_does_not_rebuild_the_session(self):
        cache = solving.cache_of(self.assembly)
        before = cache.session(solving.read_morph(self.assembly))
        self.lift(10)
        self.assertIs(cache.session(solving.read_morph(self.assembly)), before)

    def test_undo_finds_the_session_again(self):
        cache = solving.cache_of(self.assembly)
        before = cache.session(solving.read_morph(self.assembly))
        self.act("Fix", lambda: api.add_fixed(self.assembly, self.part, [150]))
        self.assertIsNot(cache.session(solving.read_morph(self.assembly)), before)
        self.document.undo()
        self.document.recompute()
        self.assertIs(cache.session(solving.read_morph(self.assembly)), before)

    def test_undo_finds_the_result_again(self):
        cache = solving.cache_of(self.assembly)
        self.lift(10)
        before = cache.result(solving.read_morph(self.assembly))
        self.lift(20)
        self.document.undo()
        self.document.recompute()
        self.assertIs(cache.result(solving.read_morph(self.assembly)), before)

    def test_regions_meshes_and_energy_rebuild_it(self):
        cache = solving.cache_of(self.assembly)
        known = [cache.session(solving.read_morph(self.assembly))]
        for change in (
            lambda: api.set_vertices(self.handle, api.vertices(self.handle)[:5]),
            lambda: api.set_energy(self.assembly, "paper"),
            lambda: setattr(self.part.Source, "Placement", support.placement((0, 0, 1))),
        ):
            change()
            found = cache.session(solving.read_morph(self.assembly))
            self.assertNotIn(found, known)
            known.append(found)


if __name__ == "__main__":
    unittest.main()

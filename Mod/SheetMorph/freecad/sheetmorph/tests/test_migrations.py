# SPDX-License-Identifier: LGPL-2.1-or-later
"""Documents of older and newer versions."""

import os
import shutil
import unittest
from unittest import mock

import numpy as np

from freecad.sheetmorph import api
from freecad.sheetmorph.objects import migrations, model
from freecad.sheetmorph.tests import support

OLD = os.path.join(os.path.dirname(__file__), "data", "version1.FCStd")
"""Two strips of SchemaVersion 1: a region by a lasso, a handle, a feature, a contact, a pose."""


class TestMigrations(support.DocumentTest):
    def open_old(self):
        """Open a copy of the document of version 1; return its morph."""
        path = os.path.join(self.folder, "old.FCStd")
        shutil.copy(OLD, path)
        return self.open(path).getObject("Morph")

    def test_a_document_of_version_1_becomes_one_of_today(self):
        morph = self.open_old()
        self.assert_up_to_date(morph.Document)
        self.assertEqual({o.SchemaVersion for o in (morph, *morph.Group)}, {migrations.VERSION})
        (contact,), clamp = model.contacts(morph), model.regions(morph)[0]
        for owner, name in ((clamp, "Where"), (contact, "WhereA"), (contact, "WhereB")):
            self.assertEqual(owner.getGroupOfProperty(name), "Advanced")
        again = self.reopen(morph.Document)
        self.assertEqual(again.getObject("Morph").SchemaVersion, migrations.VERSION)

    def test_a_document_of_version_1_gives_the_same_shape(self):
        morph = self.open_old()
        parts = model.parts(morph)
        before = [support.local_points(part) for part in parts]
        self.assertGreater(support.largest(before[1][:, 2]), 19.0)
        for part in parts:
            part.touch()
        morph.Document.recompute()
        self.assert_up_to_date(morph.Document)
        for part, points in zip(parts, before):
            np.testing.assert_allclose(support.local_points(part), points, atol=1e-4)
        (pose,) = api.poses(morph)
        api.blend_poses(None, pose, 0.5)
        handle = next(region for region in model.regions(morph) if region.Role == "handle")
        self.assertEqual(handle.TranslationZ.Value, 10.0)

    def test_a_lasso_with_the_camera_of_version_1_takes_the_same_vertices(self):
        clamp = model.regions(self.open_old())[0]
        where = api.where(clamp)
        self.assertIn("camera", where["drawn"])
        self.assertEqual(api.select(clamp.Part, where), api.vertices(clamp))

    def test_a_document_of_a_newer_version_is_left_as_it_is(self):
        morph, part, _ = self.add_morph()
        for obj in (morph, *morph.Group):
            obj.SchemaVersion = 99
        with mock.patch.object(migrations, "FreeCAD") as program:
            opened = self.reopen(self.document)
        self.assertEqual(opened.getObject("Morph").SchemaVersion, 99)
        ((warning,), _) = program.Console.PrintWarning.call_args
        self.assertIn("'Morph' was saved by a newer version", warning)
        program.Console.PrintWarning.assert_called_once()

    def test_each_step_from_the_version_of_an_object_is_done_once(self):
        _, part, handle = self.add_morph()
        done: list = []
        steps = {k: lambda obj, k=k: done.append((obj.Name, k)) for k in (1, 2, 3)}
        part.SchemaVersion, handle.SchemaVersion = 1, 3
        with mock.patch.multiple(migrations, STEPS=steps, VERSION=4):
            for obj in (part, handle, handle):
                migrations.migrate(obj)
        self.assertEqual(done, [(part.Name, 1), (part.Name, 2), (part.Name, 3), (handle.Name, 3)])


if __name__ == "__main__":
    unittest.main()

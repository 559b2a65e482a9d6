# SPDX-License-Identifier: LGPL-2.1-or-later
"""Whatever may take long tells how far it is to whoever waits, and stops when it is told to."""

import os

import Import
import Part

from freecad.sheetmorph import api, objects, reporting
from freecad.sheetmorph.objects import model
from freecad.sheetmorph.tests import support


class Listener:
    """Keeps what it is told; goes on as often as `patience` says."""

    def __init__(self, patience: int = 10**9):
        self.told: list[tuple[float, str]] = []
        self.patience = patience

    def __call__(self, share: float, task: str) -> bool:
        self.told.append((share, task))
        return len(self.told) <= self.patience


class Waiting(Listener):
    """Does the work in its own way, as a window does."""

    def __init__(self):
        super().__init__()
        self.given = 0

    def wait_for(self, work):
        self.given += 1
        return work(self)


class TestReporting(support.DocumentTest):
    def assert_told(self, work) -> None:
        """Fail unless `work` tells its progress, and ends early when nobody wants to wait."""
        with self.assertRaises(RuntimeError), reporting.told_to(Listener(0)):
            work()
        listener = Listener()
        with reporting.told_to(listener):
            work()
        shares = [share for share, _ in listener.told]
        self.assertTrue(shares and all(0.0 <= share <= 1.0 for share in shares), shares)
        self.assertEqual(shares, sorted(shares))

    def step_file(self) -> str:
        """Return the path of a STEP file with a plate in it."""
        plate = self.document.addObject("Part::Feature", "Plate")
        plate.Shape = Part.makeBox(60, 40, 2).cut(Part.makeCylinder(5, 20))
        path = os.path.join(self.folder, "plate.step")
        Import.export([plate], path)
        return path

    def test_a_search_for_features_is_followed(self):
        assembly, _, _ = self.add_morph()
        self.assert_told(lambda: api.find_features(assembly))

    def test_a_search_for_contacts_is_followed(self):
        assembly, _, _ = self.add_morph()
        self.add_second(assembly)
        self.assert_told(lambda: api.find_contacts(assembly))

    def test_the_import_of_a_cad_file_is_followed_and_leaves_nothing_when_stopped(self):
        path = self.step_file()
        assembly = api.create_assembly(self.document)
        with self.assertRaises(RuntimeError), reporting.told_to(Listener(0)):
            api.import_cad(assembly, path)
        self.assertEqual(objects.parts(assembly), [])
        listener = Listener()
        with reporting.told_to(listener):
            self.assertEqual(len(api.import_cad(assembly, path)), 1)
        self.assertTrue(listener.told)

    def test_a_recompute_that_is_stopped_is_a_failure_that_the_next_one_mends(self):
        assembly, _, handle = self.add_morph()
        api.set_motion(handle, (0, 0, 20))
        with reporting.told_to(Listener(0)):
            self.document.recompute()
        self.assertNotEqual(model.failure_of(assembly), "")
        handle.touch()
        self.document.recompute()
        self.assert_up_to_date(self.document)

    def test_who_waits_with_a_window_is_given_what_takes_long(self):
        assembly, _, handle = self.add_morph()
        waiting = Waiting()
        with reporting.told_to(waiting):
            api.find_features(assembly)
            self.assertEqual(waiting.given, 1)
            api.set_motion(handle, (0, 0, 20))
            self.document.recompute()
        self.assertGreater(waiting.given, 2)  # building the session, and solving
        self.assert_up_to_date(self.document)

    def test_nobody_is_told_outside(self):
        listener = Listener()
        with reporting.told_to(listener):
            self.assertIs(reporting.progress(), listener)
        self.assertIsNone(reporting.progress())

# SPDX-License-Identifier: LGPL-2.1-or-later
"""OpenCASCADE reads CAD files in a process of its own: its end costs one file and one sentence."""

import os
import random
import signal
import subprocess
import threading
import time

from freecad.sheetmorph import api, reporting
from freecad.sheetmorph.bridge import kernel
from freecad.sheetmorph.tests import test_cad


class Workers:
    """In its context, the processes of the CAD workers that start."""

    def __enter__(self) -> list:
        self.module = kernel.cad_module().worker.subprocess
        self.before = before = self.module.Popen
        found: list = []

        class Recorded(subprocess.Popen):
            def __init__(self, *arguments, **keys):
                before.__init__(self, *arguments, **keys)
                found.append(self)

        self.module.Popen = Recorded
        return found

    def __exit__(self, *_) -> None:
        self.module.Popen = self.before


class TestWorker(test_cad.CadTest):
    def state(self) -> list:
        """Return the state of the document for a comparison."""
        return [
            (obj.Name, obj.Label, obj.State, obj.PropertiesList) for obj in self.document.Objects
        ]

    def kit(self) -> str:
        """Return the path of a STEP file of two plates."""
        path = os.path.join(self.folder, "kit.step")
        shapes = [self.add(test_cad.plate(), name) for name in ("one", "other")]
        test_cad.Import.export(shapes, path)
        return path

    def test_a_worker_that_is_killed_at_any_moment_costs_one_sentence_and_no_change(self):
        path, chance, failed = self.kit(), random.Random(38), 0
        self.document.recompute()
        before = self.state()
        for number in range(20):
            moment = 0.25 * (number + chance.random()) / 20.0
            self.document.openTransaction("import")
            with Workers() as started:
                killer = threading.Thread(target=kill_first, args=(started, moment))
                killer.start()
                try:
                    self.assertEqual(len(api.import_cad(self.assembly, path)), 2)
                except ValueError as error:
                    failed += 1
                    self.assertRegex(str(error), "kit.step: the CAD worker ended unexpectedly")
                    self.assertNotIn("\n", str(error))
                    self.assertEqual(self.state(), before)
                killer.join()
            self.document.abortTransaction()
        self.assertGreater(failed, 0)
        self.assertEqual(len(api.import_cad(self.assembly, path)), 2)

    def test_a_shape_whose_worker_is_killed_stays_as_it_was(self):
        source = self.add(test_cad.plate())
        (part,) = api.add_shape(self.assembly, source, mesh=test_cad.SIZES)
        self.bend(part)
        shape = api.deformed_shape(part)
        volume, before = shape.Shape.Volume, self.state()
        with Workers() as started, self.assertRaisesRegex(ValueError, "ended unexpectedly"):
            with reporting.told_to(lambda *_: started[0].kill() or True):
                api.deformed_shape(part)
        self.assertEqual((api.deformed_shape(part).Shape.Volume, self.state()), (volume, before))

    def test_no_worker_stays_when_all_is_imported(self):
        with Workers() as started:
            api.import_cad(self.assembly, self.kit())
        self.assertEqual(len(started), 1)
        self.assertEqual(started[0].wait(10), -signal.SIGKILL)


def kill_first(started: list, moment: float) -> None:
    """Kill the first worker that starts, some seconds later."""
    while not started:
        time.sleep(0.001)
    time.sleep(moment)
    started[0].kill()

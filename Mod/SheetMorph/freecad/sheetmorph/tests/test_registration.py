# SPDX-License-Identifier: LGPL-2.1-or-later
"""FreeCAD knows the tests and starts without touching the kernel or a window."""

import subprocess
import tempfile
import unittest
from pathlib import Path
from unittest import mock

import FreeCAD

from freecad.sheetmorph import api, tests
from freecad.sheetmorph.bridge.study_run import interpreter
from freecad.sheetmorph.objects import watcher
from freecad.sheetmorph.tests import support

PACKAGE = Path(tests.__file__).resolve().parent.parent
QUIET_START = """
import sys
import freecad.sheetmorph
heavy = ("sheetmorph", "FreeCADGui", "numpy", "PySide2", "PySide6")
bad = [name for name in heavy if name in sys.modules]
print("loaded at start:", bad)
"""


class TestRegistration(unittest.TestCase):
    def test_every_test_file_is_listed(self):
        files = sorted((PACKAGE / "tests").glob("test_*.py"))
        found = {f"freecad.sheetmorph.tests.{file.stem}" for file in files}
        self.assertEqual(found, set(tests.MODULES))

    def test_freecads_test_workbench_lists_them(self):
        self.assertLessEqual(set(tests.MODULES), set(FreeCAD.__unit_test__))

    def test_the_start_is_light(self):
        with tempfile.TemporaryDirectory() as home:  # FreeCAD 1.1 makes a folder there, or ends
            result = subprocess.run(
                [interpreter(), "-c", QUIET_START],
                env={"PYTHONPATH": str(PACKAGE.parent.parent), "HOME": home},
                capture_output=True,
                text=True,
                check=False,
            )
        self.assertIn("loaded at start: []", result.stdout, result.stderr)


class TestWatching(support.DocumentTest):
    def test_documents_are_watched_from_the_first_morph_on(self):
        self.addCleanup(watcher.watch.cache_clear)
        watcher.watch.cache_clear()
        with mock.patch.object(watcher.FreeCAD, "addDocumentObserver") as watched:
            document = self.new_document()
            document.addObject("Mesh::Feature", "Mesh")
            watched.assert_not_called()
            api.create_assembly(document)
            api.create_assembly(self.new_document())
            watched.assert_called_once()


if __name__ == "__main__":
    unittest.main()

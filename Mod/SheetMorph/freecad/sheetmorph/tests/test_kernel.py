# SPDX-License-Identifier: LGPL-2.1-or-later
"""A kernel that is absent, for another Python, broken or outdated is told apart in one sentence."""

import importlib
import os
import sys
import tempfile
import unittest
from importlib.machinery import EXTENSION_SUFFIXES

from freecad.sheetmorph import api
from freecad.sheetmorph.bridge import kernel
from freecad.sheetmorph.objects import model
from freecad.sheetmorph.tests import support


def is_ours(name: str) -> bool:
    return name == "sheetmorph" or name.startswith("sheetmorph.")


class ReplacedKernel:
    """A context in which `sheetmorph` is another package, or none, for the whole interpreter."""

    def __init__(self, files: dict[str, str] | None):
        """`files`: name -> text, the package `sheetmorph`; None: there is no such package."""
        self._files = files

    def __enter__(self):
        self._folder = tempfile.TemporaryDirectory()
        self._modules = {name: sys.modules.pop(name) for name in list(sys.modules) if is_ours(name)}
        self._path = list(sys.path)
        if self._files is None:
            sys.path[:] = [p for p in sys.path if not os.path.isdir(os.path.join(p, "sheetmorph"))]
        else:
            package = os.path.join(self._folder.name, "sheetmorph")
            os.mkdir(package)
            for name, text in {"__init__.py": "", **self._files}.items():
                with open(os.path.join(package, name), "w", encoding="utf-8") as file:
                    file.write(text)
            sys.path.insert(0, self._folder.name)
        importlib.invalidate_caches()
        return self

    def __exit__(self, *_):
        for name in [name for name in sys.modules if is_ours(name)]:
            del sys.modules[name]
        sys.modules.update(self._modules)
        sys.path[:] = self._path
        importlib.invalidate_caches()
        self._folder.cleanup()


BAD_KERNELS = {
    "absent package": (None, "'sheetmorph' is not installed"),
    "absent kernel": ({}, "is not in"),
    "other Python": ({"_core.cpython-27m-x86_64-linux-gnu.so": ""}, "built for another Python"),
    "broken": ({f"_core{EXTENSION_SUFFIXES[0]}": "no machine code"}, "cannot be loaded"),
    "outdated": ({"_core.py": "KERNEL_API = 0"}, "version 0"),
    "without version": ({"_core.py": ""}, "version None"),
    "damaged package": ({"__init__.py": "import ("}, "cannot be loaded"),
    "missing library": ({"__init__.py": "import no_such_library"}, "'no_such_library'"),
}


class TestDiagnosis(unittest.TestCase):
    def test_every_bad_kernel_is_explained_and_has_a_remedy(self):
        for name, (files, words) in BAD_KERNELS.items():
            with self.subTest(name), ReplacedKernel(files):
                with self.assertRaises(kernel.KernelError) as raised:
                    kernel.load()
                message = str(raised.exception)
                self.assertIn(words, message)
                self.assertRegex(message, "install")
                self.assertNotIn("\n", message)
                self.assertFalse(kernel.is_available())

    def test_another_python_is_named_with_what_is_needed(self):
        with ReplacedKernel(BAD_KERNELS["other Python"][0]):
            with self.assertRaises(kernel.KernelError) as raised:
                kernel.load()
        self.assertIn("_core.cpython-27m-x86_64-linux-gnu.so", str(raised.exception))
        self.assertIn(EXTENSION_SUFFIXES[0], str(raised.exception))

    def test_report_tells_the_state_with_every_kernel(self):
        for name, (files, words) in BAD_KERNELS.items():
            with self.subTest(name), ReplacedKernel(files):
                report = kernel.report()
                self.assertIn("State: not usable.", report)
                self.assertIn(words, report)

    def test_report_of_a_good_kernel_says_ready(self):
        report = kernel.report()
        self.assertIn("State: ready.", report)
        self.assertIn("Kernel version", report)
        self.assertTrue(kernel.is_available())


class TestDocumentsWithoutKernel(support.DocumentTest):
    def test_the_last_mesh_stays_and_the_reason_is_shown(self):
        assembly, part, handle = self.add_morph()
        api.set_motion(handle, (0, 0, 20))
        self.document.recompute()
        before = support.local_points(part)
        for name, (files, words) in BAD_KERNELS.items():
            with self.subTest(name), ReplacedKernel(files):
                opened = self.reopen(self.document, f"{name}.FCStd")
                part = opened.getObject("Part")
                self.document = opened
                self.assertEqual(support.largest(support.local_points(part) - before), 0.0)
                api.set_motion(opened.getObject("Region001"), (0, 0, 30))
                opened.recompute()
                self.assertEqual(support.largest(support.local_points(part) - before), 0.0)
                self.assertIn(words, model.failure_of(opened.getObject("Morph")))
                self.assertIn(words, opened.getObject("Morph").Status)
                api.set_motion(opened.getObject("Region001"), (0, 0, 20))

    def test_a_kernel_that_comes_back_is_used(self):
        assembly, part, handle = self.add_morph()
        with ReplacedKernel(None):
            self.document.recompute()
            self.assertIn("not installed", model.failure_of(assembly))
        api.set_motion(handle, (0, 0, 5))
        self.document.recompute()
        self.assert_up_to_date(self.document)

    def test_building_a_morph_needs_no_kernel(self):
        with ReplacedKernel(None):
            assembly, part, handle = self.add_morph()
            with self.assertRaisesRegex(kernel.KernelError, "not installed"):
                api.hole_rims(part)
        self.assertEqual(len(assembly.Group), 4)
        self.assertEqual(handle.Role, "handle")


if __name__ == "__main__":
    unittest.main()

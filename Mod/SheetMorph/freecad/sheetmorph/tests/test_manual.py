# SPDX-License-Identifier: LGPL-2.1-or-later
"""The manual is found beside the add-on, and opens at the page of a command."""

import tempfile
import unittest
from pathlib import Path
from unittest import mock

import FreeCAD

from freecad.sheetmorph import paths


class TestAddresses(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.root = Path(folder.name, "an add-on")
        self.page = self.root / "manual" / "command" / "SheetMorph_One.html"
        self.page.parent.mkdir(parents=True)
        self.page.write_text("one", encoding="utf-8")
        patch = mock.patch.object(paths, "_ROOT", str(self.root))
        patch.start()
        self.addCleanup(patch.stop)

    def test_a_page_has_an_address_without_spaces(self):
        address = paths.manual_of("SheetMorph_One")
        self.assertTrue(address.startswith("file:///"))
        self.assertTrue(address.endswith("/an%20add-on/manual/command/SheetMorph_One.html"))

    def test_a_page_that_is_not_there_has_none(self):
        self.assertEqual(paths.manual_of("SheetMorph_Two"), "")
        self.assertEqual(paths.manual("index.html"), "")


@unittest.skipUnless(FreeCAD.GuiUp, "FreeCAD has no window")
class TestCommand(unittest.TestCase):
    def setUp(self):
        from freecad.sheetmorph.commands import registered
        from freecad.sheetmorph.qt import QtGui

        self.command = registered()["SheetMorph_Manual"]
        patch = mock.patch.object(QtGui.QDesktopServices, "openUrl", return_value=True)
        self.opened = patch.start()
        self.addCleanup(patch.stop)

    def test_it_opens_the_start_page(self):
        with mock.patch.object(paths, "manual", return_value="file:///a/index.html"):
            self.command.execute()
        self.assertEqual(self.opened.call_args[0][0].toString(), "file:///a/index.html")

    def test_without_a_manual_it_says_how_to_get_one(self):
        with mock.patch.object(paths, "manual", return_value=""):
            with self.assertRaisesRegex(RuntimeError, "sheetmorph docs"):
                self.command.execute()
        self.opened.assert_not_called()

    def test_without_a_browser_it_says_the_address(self):
        self.opened.return_value = False
        with mock.patch.object(paths, "manual", return_value="file:///a/index.html"):
            with self.assertRaisesRegex(RuntimeError, "file:///a/index.html"):
                self.command.execute()

    def test_whats_this_is_the_page_of_the_command_or_its_tooltip(self):
        with mock.patch.object(paths, "manual_of", return_value="file:///a/b.html"):
            self.assertEqual(self.command.GetResources()["WhatsThis"], "file:///a/b.html")
        with mock.patch.object(paths, "manual_of", return_value=""):
            self.assertEqual(self.command.GetResources()["WhatsThis"], self.command.tooltip)

    def test_every_command_has_a_page_in_an_installed_manual(self):
        import FreeCADGui

        if not paths.manual("index.html"):
            self.skipTest("The manual is not installed beside the add-on.")
        FreeCADGui.activateWorkbench("SheetMorphWorkbench")
        names = [name for name in FreeCADGui.listCommands() if name.startswith("SheetMorph_")]
        self.assertGreater(len(names), 30)
        self.assertEqual([name for name in names if not paths.manual_of(name)], [])


if __name__ == "__main__":
    unittest.main()

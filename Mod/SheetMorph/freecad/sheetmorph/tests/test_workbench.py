# SPDX-License-Identifier: LGPL-2.1-or-later
"""The workbench in FreeCAD's window: commands, help texts, panels, languages; skipped without."""

import os
import unittest

import FreeCAD

from freecad.sheetmorph import paths

PANELS = os.path.dirname(paths.panel("move"))
BUTTONS = ("QPushButton", "QToolButton", "QCheckBox", "QComboBox")


@unittest.skipUnless(FreeCAD.GuiUp, "FreeCAD has no window")
class TestWorkbench(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        import FreeCADGui

        cls.gui = FreeCADGui
        FreeCADGui.activateWorkbench("SheetMorphWorkbench")

    def names(self) -> list[str]:
        """The commands of the workbench."""
        return [name for name in self.gui.listCommands() if name.startswith("SheetMorph_")]

    def test_every_command_has_texts_and_an_icon(self):
        self.assertGreater(len(self.names()), 20)
        for name in self.names():
            with self.subTest(name):
                info = self.gui.Command.get(name).getInfo()
                for key in ("menuText", "toolTip", "whatsThis", "statusTip"):
                    self.assertTrue(info[key], key)
                self.assertTrue(os.path.isfile(info["pixmap"]), info["pixmap"])

    def test_every_command_is_in_the_menu_and_most_in_a_toolbar(self):
        from freecad.sheetmorph import commands

        listed = [name for row in commands.menu().values() for name in row if name != "Separator"]
        self.assertEqual(sorted(self.names()), sorted(listed))
        workbench = self.gui.getWorkbench("SheetMorphWorkbench")
        shown = {name for title in workbench.toolbars for name in workbench.toolbars[title]}
        self.assertEqual(len(workbench.toolbars), 3)
        self.assertGreater(len(shown), len(self.names()) // 2)
        self.assertLessEqual(shown, {*self.names(), "Separator"})

    def test_shortcuts_are_different_and_begin_with_a_free_letter(self):
        from freecad.sheetmorph import commands

        keys = [command.keys for command in commands.registered().values() if command.keys]
        self.assertGreater(len(keys), 15)
        self.assertEqual(len(set(keys)), len(keys))
        foreign = [name for name in self.gui.listCommands() if name not in self.names()]
        taken = {self.gui.Command.get(name).getShortcut() for name in foreign}
        for one in keys:
            self.assertRegex(one, r"^Y, [A-Z]$")
            self.assertFalse({"Y", one} & taken, one)

    def test_every_panel_that_a_command_opens_is_there(self):
        from importlib import import_module

        from freecad.sheetmorph import commands
        from freecad.sheetmorph.commands.base import Panel

        panels = [one.act for one in commands.registered().values() if isinstance(one.act, Panel)]
        self.assertGreater(len(panels), 8)
        for panel in panels:
            module = import_module(f"freecad.sheetmorph.panels.{panel.module}")
            self.assertTrue(callable(getattr(module, panel.function)), panel.function)

    def test_every_panel_loads(self):
        for file in sorted(os.listdir(PANELS)):
            with self.subTest(file):
                form = self.gui.PySideUic.loadUi(os.path.join(PANELS, file))
                self.assertTrue(form.objectName())

    def test_a_panel_has_help_at_its_widgets(self):
        from freecad.sheetmorph.editing.session import Session
        from freecad.sheetmorph.panels.base import Panel

        form = Panel(Session(), "propagation", "Propagation", "Propagation").form
        self.assertEqual(form.kind.whatsThis(), form.kind.toolTip())
        self.assertEqual(form.kind.statusTip(), form.kind.toolTip())
        self.assertTrue(form.kind.toolTip())

    def test_texts_are_there_in_german_and_japanese(self):
        from freecad.sheetmorph.qt import translate

        self.addCleanup(self.gui.setLocale, "English")
        for language, command, panel in (
            ("German", "&Griff bewegen…", "Mitte des Griffs"),
            ("Japanese", "ハンドルを動かす(&M)…", "ハンドルの中心"),
        ):
            self.gui.setLocale(language)
            self.assertEqual(translate("SheetMorph_MoveHandle", "&Move Handle…"), command)
            form = self.gui.PySideUic.loadUi(paths.panel("move"))
            self.assertIn(panel, [label.text() for label in vars(form).values() if has_text(label)])


def has_text(widget) -> bool:
    """Whether a widget shows a text or a title."""
    return hasattr(widget, "text")


if __name__ == "__main__":
    unittest.main()

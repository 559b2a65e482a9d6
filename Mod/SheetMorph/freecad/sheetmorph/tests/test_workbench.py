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

        self.assertEqual(set(self.names()), set(commands.menu()) - {"Separator"})
        workbench = self.gui.getWorkbench("SheetMorphWorkbench")
        shown = {name for title in workbench.toolbars for name in workbench.toolbars[title]}
        self.assertGreater(len(shown), len(self.names()) // 2)
        self.assertLessEqual(shown, set(self.names()))

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
            ("German", "Griff bewegen…", "Mitte des Griffs"),
            ("Japanese", "ハンドルを動かす…", "ハンドルの中心"),
        ):
            self.gui.setLocale(language)
            self.assertEqual(translate("SheetMorph_MoveHandle", "Move Handle…"), command)
            form = self.gui.PySideUic.loadUi(paths.panel("move"))
            self.assertIn(panel, [label.text() for label in vars(form).values() if has_text(label)])


def has_text(widget) -> bool:
    """Whether a widget shows a text or a title."""
    return hasattr(widget, "text")


if __name__ == "__main__":
    unittest.main()

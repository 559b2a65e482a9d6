# SPDX-License-Identifier: LGPL-2.1-or-later
"""The context menus of objects in the tree, in every workbench."""

import FreeCADGui as Gui

from freecad.sheetmorph import commands, paths
from freecad.sheetmorph.qt import connect, icon_of, translate
from freecad.sheetmorph.tools.marked import QT_TRANSLATE_NOOP

PROBLEM = QT_TRANSLATE_NOOP("SheetMorph_menus", "Show Problem")


def fill(menu) -> None:
    """Add the commands that apply to the selection, which FreeCAD sets at a right click."""
    for name in commands.suiting(Gui.Selection.getSelection()):
        command = commands.registered().get(name)
        if command is None:
            menu.addSeparator()
        else:
            add(menu, command.icon, command.label, name)


def add_problem(menu) -> None:
    """Add the entry that shows a fault of a morph in the guide."""
    text = translate("SheetMorph_menus", PROBLEM)
    add(menu, paths.icon("MorphFault"), text, "SheetMorph_Guide")


def add(menu, icon: str, text: str, command: str) -> None:
    """Add an entry that runs a command."""
    entry = menu.addAction(icon_of(icon), text)
    connect(entry, "triggered()", lambda *_: Gui.runCommand(command))

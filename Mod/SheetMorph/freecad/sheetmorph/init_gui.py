# SPDX-License-Identifier: LGPL-2.1-or-later
"""Registers the workbench; whatever is heavy is imported when it is first activated."""

import FreeCADGui as Gui

from freecad.sheetmorph import paths


class SheetMorphWorkbench(Gui.Workbench):
    """Feature-preserving deformation of sheet-metal assemblies."""

    MenuText = "SheetMorph"
    ToolTip = "Deforms sheet-metal assemblies by a handle; holes keep their shape"
    Icon = paths.icon("SheetMorph")

    def Initialize(self):
        """Adds the commands to menu and toolbar; called once by FreeCAD."""
        from freecad.sheetmorph import commands

        Gui.addLanguagePath(paths.translations())
        Gui.updateLocale()
        Gui.addIconPath(paths.icons())
        Gui.addPreferencePage(paths.panel("preferences"), "SheetMorph")
        self.toolbars = commands.register()
        for title, names in self.toolbars.items():
            self.appendToolbar(title, names)
        self.appendMenu("&SheetMorph", commands.menu())

    def Activated(self):
        """Places the toolbars, and says in one sentence if the kernel cannot be used."""
        from freecad.sheetmorph.commands import installation
        from freecad.sheetmorph.panels import toolbars

        toolbars.place(list(self.toolbars))
        installation.warn_once(self)

    def GetClassName(self) -> str:
        """The C++ class FreeCAD wraps around this workbench."""
        return "Gui::PythonWorkbench"


Gui.addWorkbench(SheetMorphWorkbench())

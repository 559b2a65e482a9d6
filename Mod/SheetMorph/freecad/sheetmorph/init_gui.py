# SPDX-License-Identifier: LGPL-2.1-or-later
"""The registration of the workbench; slow imports wait for its first activation."""

import FreeCADGui as Gui

from freecad.sheetmorph import paths


class SheetMorphWorkbench(Gui.Workbench):
    """The workbench for feature-preserving deformation of sheet-metal assemblies."""

    MenuText = "SheetMorph"
    ToolTip = "Deforms sheet-metal assemblies by a handle; holes keep their shape"
    Icon = paths.icon("SheetMorph")

    def Initialize(self):
        """Add the commands to menu and toolbars; FreeCAD calls this once."""
        from freecad.sheetmorph import commands

        Gui.addLanguagePath(paths.translations())
        Gui.updateLocale()
        Gui.addIconPath(paths.icons())
        Gui.addPreferencePage(paths.panel("preferences"), "SheetMorph")
        self.toolbars = commands.register()
        for title, names in self.toolbars.items():
            self.appendToolbar(title, names)
        self.appendMenu("&SheetMorph", commands.menu())
        self.appendMenu("&Help", ["SheetMorph_Manual"])

    def Activated(self):
        """Place the toolbars, and warn if the kernel cannot be used."""
        from freecad.sheetmorph.commands import installation
        from freecad.sheetmorph.panels import toolbars

        toolbars.place(list(self.toolbars))
        installation.warn_once(self)

    def GetClassName(self) -> str:
        """Return the C++ class that FreeCAD wraps around this workbench."""
        return "Gui::PythonWorkbench"


Gui.addWorkbench(SheetMorphWorkbench())

# SPDX-License-Identifier: LGPL-2.1-or-later
"""The registration of the workbench; slow imports wait for its first activation."""

import FreeCADGui as Gui

from freecad.sheetmorph import paths


class SheetMorphWorkbench(Gui.Workbench):
    """The workbench for feature-preserving deformation of sheet-metal assemblies."""

    MenuText = "SheetMorph"
    ToolTip = "Deforms sheet-metal assemblies by a handle; holes keep their shape"
    Icon = paths.icon("SheetMorph")
    has_looked = False

    def Initialize(self):
        """Add the commands to menu and toolbars; FreeCAD calls this once."""
        from freecad.sheetmorph import commands

        Gui.addLanguagePath(paths.translations())
        Gui.updateLocale()
        Gui.addIconPath(paths.icons())
        Gui.addPreferencePage(paths.panel("preferences"), "SheetMorph")
        commands.registered()
        self.toolbars = commands.toolbars()
        for title, names in self.toolbars.items():
            self.appendToolbar(title, names)
        for title, names in commands.menu().items():
            self.appendMenu(["&SheetMorph", title] if title else "&SheetMorph", names)
        self.appendMenu("&Help", ["SheetMorph_Manual"])

    def Activated(self):
        """Place the toolbars, and warn once if the kernel cannot be used."""
        from freecad.sheetmorph.panels import toolbars

        toolbars.place(list(self.toolbars))
        if not self.has_looked:
            self.has_looked = True
            warn_without_kernel()

    def ContextMenu(self, recipient):
        """Add the commands that apply to the selection to the context menu of the 3D view.

        FreeCAD calls this before it opens the menu. The tree's menu gets them from the objects.
        """
        from freecad.sheetmorph import commands

        if recipient == "View":
            names = commands.suiting(Gui.Selection.getSelection())
            self.appendContextMenu("", ["Separator", *names])

    def GetClassName(self) -> str:
        """Return the C++ class that FreeCAD wraps around this workbench."""
        return "Gui::PythonWorkbench"


def warn_without_kernel():
    """Print one sentence if the kernel cannot be used."""
    import FreeCAD

    from freecad.sheetmorph.bridge import kernel

    try:
        kernel.load()
    except kernel.KernelError as error:
        FreeCAD.Console.PrintWarning(f"SheetMorph: {error}\n")


Gui.addWorkbench(SheetMorphWorkbench())

# SPDX-License-Identifier: LGPL-2.1-or-later
"""Commands that create a morph and bring parts into it."""

import FreeCAD as App
import FreeCADGui as Gui

from freecad.sheetmorph import actions
from freecad.sheetmorph.actions import call, name
from freecad.sheetmorph.commands import context
from freecad.sheetmorph.commands.base import Command
from freecad.sheetmorph.qt import QtCore, QtWidgets

QT_TRANSLATE_NOOP = QtCore.QT_TRANSLATE_NOOP
FILTER = (
    "Meshes and decks (*.obj *.off *.ply *.stl *.nas *.bdf *.dat *.vtk *.vtu *.inp);;All files (*)"
)


class CreateMorph(Command):
    """Creates a morph, with the selected meshes as its parts."""

    name = "SheetMorph_CreateMorph"
    text = QT_TRANSLATE_NOOP("SheetMorph_CreateMorph", "Create Morph")
    tooltip = QT_TRANSLATE_NOOP(
        "SheetMorph_CreateMorph",
        "Creates a morph; selected meshes become its parts, the meshes themselves stay unchanged",
    )

    def possible(self) -> bool:
        """Always: without a document one is made."""
        return True

    def execute(self) -> None:
        """One undo step; the first mesh selected becomes the primary."""
        sources = context.meshes()
        if App.ActiveDocument is None:
            Gui.doCommand("App.newDocument()")
        new = call("create_assembly", "App.ActiveDocument")
        before = set(App.ActiveDocument.Objects)
        lines = [f"morph = {new}"] + [call("add_part", "morph", name(s)) for s in sources]
        if actions.attempt("Create Morph", *lines):
            Gui.Selection.clearSelection()
            made = [o for o in App.ActiveDocument.Objects if o not in before]
            Gui.Selection.addSelection(next(o for o in made if context.kind(o) == context.ASSEMBLY))


class AddPart(Command):
    """Adds the selected meshes to a morph."""

    name = "SheetMorph_AddPart"
    text = QT_TRANSLATE_NOOP("SheetMorph_AddPart", "Add Part")
    tooltip = QT_TRANSLATE_NOOP(
        "SheetMorph_AddPart", "Adds the selected meshes to the morph as parts that deform"
    )

    def possible(self) -> bool:
        """With a morph and a mesh selected."""
        return bool(context.meshes()) and context.assembly() is not None

    def execute(self) -> None:
        """Adds all of them in one undo step."""
        owner = name(context.assembly())
        lines = [call("add_part", owner, name(mesh)) for mesh in context.meshes()]
        actions.attempt("Add Part", *lines)


class ImportPart(Command):
    """Imports a file as a part, its positions in double precision."""

    name = "SheetMorph_ImportPart"
    text = QT_TRANSLATE_NOOP("SheetMorph_ImportPart", "Import Part…")
    tooltip = QT_TRANSLATE_NOOP(
        "SheetMorph_ImportPart",
        "Imports a mesh file as a part; its exact positions are kept and written back on export",
    )

    def possible(self) -> bool:
        """With a morph to import into."""
        return context.assembly() is not None

    def execute(self) -> None:
        """Asks for files and imports them in one undo step."""
        window = Gui.getMainWindow()
        files, _ = QtWidgets.QFileDialog.getOpenFileNames(window, "Import Part", "", FILTER)
        if files:
            owner = name(context.assembly())
            actions.attempt("Import Part", *[call("import_part", owner, repr(f)) for f in files])
            Gui.SendMsgToActiveView("ViewFit")

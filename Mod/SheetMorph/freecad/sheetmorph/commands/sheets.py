# SPDX-License-Identifier: LGPL-2.1-or-later
"""Commands about the sheet of a part."""

from freecad.sheetmorph import actions, subject
from freecad.sheetmorph.actions import call, name
from freecad.sheetmorph.commands.base import Command
from freecad.sheetmorph.qt import QtCore

QT_TRANSLATE_NOOP = QtCore.QT_TRANSLATE_NOOP


class ThicknessMap(Command):
    """The command that opens the panel about thickness."""

    name = "SheetMorph_ThicknessMap"
    text = QT_TRANSLATE_NOOP("SheetMorph_ThicknessMap", "Thickness…")
    tooltip = QT_TRANSLATE_NOOP(
        "SheetMorph_ThicknessMap",
        "Shows the thickness of the selected part in colours, and lets the part "
        "bend as one sheet",
    )

    def possible(self) -> bool:
        """Return whether there is a part."""
        return subject.part() is not None

    def execute(self) -> None:
        """Open the panel."""
        from freecad.sheetmorph.panels import thickness_panel

        thickness_panel.open_panel(subject.part())


class Flatten(Command):
    """The command that creates sketches of a part's flat blank."""

    name = "SheetMorph_Flatten"
    text = QT_TRANSLATE_NOOP("SheetMorph_Flatten", "Flatten")
    tooltip = QT_TRANSLATE_NOOP(
        "SheetMorph_Flatten",
        "Flattens the selected part, in its current shape and at rest: sketches "
        "of blank and bend lines",
    )

    def possible(self) -> bool:
        """Return whether there is a part."""
        return subject.part() is not None

    def execute(self) -> None:
        """Create the sketches in one undo step."""
        part = subject.part()
        actions.attempt(
            "Flatten", call("flatten", name(part), at_rest=True), document=part.Document
        )


class DeformedShape(Command):
    """The command that creates a part's shape in its deformed state."""

    name = "SheetMorph_DeformedShape"
    text = QT_TRANSLATE_NOOP("SheetMorph_DeformedShape", "Deformed Shape")
    tooltip = QT_TRANSLATE_NOOP(
        "SheetMorph_DeformedShape",
        "Creates a deformed CAD shape of the selected part, with the faces of "
        "its original shape",
    )

    def possible(self) -> bool:
        """Return whether there is a part made from a shape."""
        part = subject.part()
        return part is not None and bool(part.ShapeData)

    def execute(self) -> None:
        """Create the shape in one undo step."""
        actions.attempt("Deformed Shape", call("deformed_shape", name(subject.part())))


class PrepareMesh(Command):
    """The command that opens the panel to repair and remesh a part."""

    name = "SheetMorph_PrepareMesh"
    text = QT_TRANSLATE_NOOP("SheetMorph_PrepareMesh", "Prepare Mesh…")
    tooltip = QT_TRANSLATE_NOOP(
        "SheetMorph_PrepareMesh",
        "Checks the mesh of the selected part, repairs it and remeshes it",
    )

    def possible(self) -> bool:
        """Return whether there is a part."""
        return subject.part() is not None

    def execute(self) -> None:
        """Open the panel; OK changes the document."""
        from freecad.sheetmorph.panels import prepare_panel

        prepare_panel.open_panel(subject.part())

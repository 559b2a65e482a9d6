# SPDX-License-Identifier: LGPL-2.1-or-later
"""Commands that move handles."""

from freecad.sheetmorph import actions, subject
from freecad.sheetmorph.actions import call, name
from freecad.sheetmorph.commands.base import Command
from freecad.sheetmorph.qt import QtCore

QT_TRANSLATE_NOOP = QtCore.QT_TRANSLATE_NOOP


class MoveHandle(Command):
    """The command that opens the panel with a handle's translation and rotation."""

    name = "SheetMorph_MoveHandle"
    text = QT_TRANSLATE_NOOP("SheetMorph_MoveHandle", "Move Handle…")
    tooltip = QT_TRANSLATE_NOOP(
        "SheetMorph_MoveHandle",
        "Moves and turns a handle; the parts follow as you change the values",
    )

    def possible(self) -> bool:
        """Return whether there is a handle."""
        return subject.handle() is not None

    def execute(self) -> None:
        """Open the panel."""
        from freecad.sheetmorph.panels import move_panel

        move_panel.open_panel(subject.handle())


class ResetMotion(Command):
    """The command that returns handles to rest."""

    name = "SheetMorph_ResetMotion"
    text = QT_TRANSLATE_NOOP("SheetMorph_ResetMotion", "Reset Motion")
    tooltip = QT_TRANSLATE_NOOP(
        "SheetMorph_ResetMotion",
        "Returns the selected handles, or all handles of the morph, to rest",
    )

    def possible(self) -> bool:
        """Return whether there is a handle."""
        return subject.handle() is not None

    def execute(self) -> None:
        """Reset all handles in one undo step."""
        chosen = [r for r in subject.selected(subject.REGION) if r.Role == "handle"]
        handles = chosen or subject.regions(subject.assembly(), "handle")
        actions.attempt("Reset Motion", *[call("reset_motion", name(h)) for h in handles])

# SPDX-License-Identifier: LGPL-2.1-or-later
"""Commands about contacts between parts."""

from freecad.sheetmorph import actions, subject
from freecad.sheetmorph.actions import call, name
from freecad.sheetmorph.commands.base import Command
from freecad.sheetmorph.qt import QtCore

QT_TRANSLATE_NOOP = QtCore.QT_TRANSLATE_NOOP


class MarkContact(Command):
    """The command that opens the panel to join two parts."""

    name = "SheetMorph_MarkContact"
    text = QT_TRANSLATE_NOOP("SheetMorph_MarkContact", "Mark Contact…")
    tooltip = QT_TRANSLATE_NOOP(
        "SheetMorph_MarkContact",
        "Joins two parts where they touch, so that one follows the other. Select "
        "both parts, or click on them in the 3D view",
    )

    def possible(self) -> bool:
        """Return whether there is a morph of at least two parts."""
        return subject.has(subject.PART, 2)

    def execute(self) -> None:
        """Open the panel; OK creates the contact."""
        from freecad.sheetmorph.panels import contact_panel

        owner = subject.assembly()
        mine = subject.parts(owner)
        contact_panel.create(owner, [p for p in subject.selected(subject.PART) if p in mine])


class Propagation(Command):
    """The command that opens the panel about propagation."""

    name = "SheetMorph_Propagation"
    text = QT_TRANSLATE_NOOP("SheetMorph_Propagation", "Propagation…")
    tooltip = QT_TRANSLATE_NOOP(
        "SheetMorph_Propagation",
        "Shows how the motion spreads from the primary part through the contacts",
    )

    def possible(self) -> bool:
        """Return whether there is a part."""
        return subject.has(subject.PART)

    def execute(self) -> None:
        """Open the panel."""
        from freecad.sheetmorph.panels import propagation_panel

        propagation_panel.open_panel(subject.assembly())


class SetPrimary(Command):
    """The command that makes the selected part the primary."""

    name = "SheetMorph_SetPrimary"
    text = QT_TRANSLATE_NOOP("SheetMorph_SetPrimary", "Set as Primary")
    tooltip = QT_TRANSLATE_NOOP(
        "SheetMorph_SetPrimary",
        "Makes the selected part the primary part, which is deformed first; the "
        "others follow it",
    )

    def possible(self) -> bool:
        """Return whether one part is selected that is not the primary."""
        chosen = subject.selected(subject.PART)
        owner = subject.assembly_of(chosen[0]) if len(chosen) == 1 else None
        return owner is not None and owner.Primary != chosen[0]

    def execute(self) -> None:
        """Set the primary in one undo step."""
        (chosen,) = subject.selected(subject.PART)
        line = call("set_primary", name(subject.assembly_of(chosen)), name(chosen))
        actions.attempt("Set as Primary", line)

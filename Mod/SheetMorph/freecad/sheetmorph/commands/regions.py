# SPDX-License-Identifier: LGPL-2.1-or-later
"""Commands that mark regions of a part by picking in the 3D view."""

from freecad.sheetmorph import subject
from freecad.sheetmorph.commands.base import Command
from freecad.sheetmorph.qt import QtCore

QT_TRANSLATE_NOOP = QtCore.QT_TRANSLATE_NOOP


class _Mark(Command):
    """The base of commands that open the picking panel for one role."""

    role = ""

    def possible(self) -> bool:
        """Return whether there is a part."""
        return subject.part() is not None

    def execute(self) -> None:
        """Open the panel; OK creates the region."""
        from freecad.sheetmorph.panels import region_panel

        region_panel.create(subject.part(), self.role)


class MarkFixed(_Mark):
    """The command that marks a fixed region."""

    name = "SheetMorph_MarkFixed"
    role = "fixed"
    text = QT_TRANSLATE_NOOP("SheetMorph_MarkFixed", "Mark Fixed Region…")
    tooltip = QT_TRANSLATE_NOOP(
        "SheetMorph_MarkFixed", "Marks a region that stays in place, by picking in the 3D view"
    )


class MarkHandle(_Mark):
    """The command that marks a handle."""

    name = "SheetMorph_MarkHandle"
    role = "handle"
    text = QT_TRANSLATE_NOOP("SheetMorph_MarkHandle", "Mark Handle…")
    tooltip = QT_TRANSLATE_NOOP(
        "SheetMorph_MarkHandle",
        "Marks a region that you move and turn; the part follows",
    )


class MarkFeature(_Mark):
    """The command that marks form features."""

    name = "SheetMorph_MarkFeature"
    role = "form feature"
    text = QT_TRANSLATE_NOOP("SheetMorph_MarkFeature", "Mark Form Features…")
    tooltip = QT_TRANSLATE_NOOP(
        "SheetMorph_MarkFeature",
        "Marks holes and other form features, which move but keep their shape",
    )


class MarkFollower(_Mark):
    """The command that marks a follower, which moves with the control meshes of contacts."""

    name = "SheetMorph_MarkFollower"
    role = "follower"
    text = QT_TRANSLATE_NOOP("SheetMorph_MarkFollower", "Mark Follower…")
    tooltip = QT_TRANSLATE_NOOP(
        "SheetMorph_MarkFollower",
        "Marks a region that follows the control meshes of the part's contacts",
    )

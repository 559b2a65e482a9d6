# SPDX-License-Identifier: LGPL-2.1-or-later
"""The command that computes many variants of a morph."""

from freecad.sheetmorph import subject
from freecad.sheetmorph.commands.base import Command
from freecad.sheetmorph.qt import QtCore

QT_TRANSLATE_NOOP = QtCore.QT_TRANSLATE_NOOP


class Study(Command):
    """The command that opens the panel of a study."""

    name = "SheetMorph_Study"
    text = QT_TRANSLATE_NOOP("SheetMorph_Study", "Study…")
    tooltip = QT_TRANSLATE_NOOP(
        "SheetMorph_Study",
        "Computes and certifies many variants in the background and lists them " "in a table",
    )

    def possible(self) -> bool:
        """Return whether there is a handle."""
        return subject.handle() is not None

    def execute(self) -> None:
        """Open the panel of the selected study, else of a new one."""
        from freecad.sheetmorph.panels import study_panel

        chosen = subject.selected(subject.STUDY)
        study_panel.open_panel(subject.assembly(), chosen[-1] if chosen else None)

# SPDX-License-Identifier: LGPL-2.1-or-later
"""The command that leads a new user through a morph."""

from freecad.sheetmorph.commands.base import Command
from freecad.sheetmorph.qt import QtCore

QT_TRANSLATE_NOOP = QtCore.QT_TRANSLATE_NOOP


class OpenGuide(Command):
    """The command that opens the guide."""

    name = "SheetMorph_Guide"
    text = QT_TRANSLATE_NOOP("SheetMorph_Guide", "Guide")
    tooltip = QT_TRANSLATE_NOOP(
        "SheetMorph_Guide",
        "Guides you through a morph step by step: shows what is missing and "
        "opens the right panel",
    )
    alters = False

    def possible(self) -> bool:
        """Return True, since the guide starts without a document."""
        return True

    def execute(self) -> None:
        """Open the panel."""
        from freecad.sheetmorph.panels.guide import Guide

        Guide.open(Command.registered)

# SPDX-License-Identifier: LGPL-2.1-or-later
"""Commands that propose what would be marked by hand otherwise."""

from freecad.sheetmorph import subject
from freecad.sheetmorph.commands.base import Command
from freecad.sheetmorph.qt import QtCore

QT_TRANSLATE_NOOP = QtCore.QT_TRANSLATE_NOOP


class FindFeatures(Command):
    """Opens the list of the features found."""

    name = "SheetMorph_FindFeatures"
    text = QT_TRANSLATE_NOOP("SheetMorph_FindFeatures", "Find Features…")
    tooltip = QT_TRANSLATE_NOOP(
        "SheetMorph_FindFeatures",
        "Finds holes and other features on all parts; those you accept become form features",
    )

    def possible(self) -> bool:
        """With a part."""
        return subject.has(subject.PART)

    def execute(self) -> None:
        """Opens the panel; the document changes when the user says OK."""
        from freecad.sheetmorph.panels import find_panel

        find_panel.open_features(subject.assembly(), subject.chosen_parts())


class FindContacts(Command):
    """Opens the list of the contacts found."""

    name = "SheetMorph_FindContacts"
    text = QT_TRANSLATE_NOOP("SheetMorph_FindContacts", "Find Contacts…")
    tooltip = QT_TRANSLATE_NOOP(
        "SheetMorph_FindContacts",
        "Finds where parts lie on each other or are bolted; those you accept become contacts",
    )

    def possible(self) -> bool:
        """With a morph of two parts or more."""
        return subject.has(subject.PART, 2)

    def execute(self) -> None:
        """Opens the panel; the document changes when the user says OK."""
        from freecad.sheetmorph.panels import find_panel

        find_panel.open_contacts(subject.assembly(), subject.chosen_parts())

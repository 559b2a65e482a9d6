# SPDX-License-Identifier: LGPL-2.1-or-later
"""Commands that propose features and contacts."""

from freecad.sheetmorph import subject
from freecad.sheetmorph.commands.base import Command
from freecad.sheetmorph.qt import QtCore

QT_TRANSLATE_NOOP = QtCore.QT_TRANSLATE_NOOP


class FindFeatures(Command):
    """The command that lists the features found."""

    name = "SheetMorph_FindFeatures"
    text = QT_TRANSLATE_NOOP("SheetMorph_FindFeatures", "Find Features…")
    tooltip = QT_TRANSLATE_NOOP(
        "SheetMorph_FindFeatures",
        "Finds holes and other features on all parts; the ones you accept become " "form features",
    )

    def possible(self) -> bool:
        """Return whether there is a part."""
        return subject.has(subject.PART)

    def execute(self) -> None:
        """Open the panel; OK changes the document."""
        from freecad.sheetmorph.panels import find_panel

        find_panel.open_features(subject.assembly(), subject.chosen_parts())


class FindContacts(Command):
    """The command that lists the contacts found."""

    name = "SheetMorph_FindContacts"
    text = QT_TRANSLATE_NOOP("SheetMorph_FindContacts", "Find Contacts…")
    tooltip = QT_TRANSLATE_NOOP(
        "SheetMorph_FindContacts",
        "Finds where parts touch or are bolted; the ones you accept become " "contacts",
    )

    def possible(self) -> bool:
        """Return whether there is a morph of at least two parts."""
        return subject.has(subject.PART, 2)

    def execute(self) -> None:
        """Open the panel; OK changes the document."""
        from freecad.sheetmorph.panels import find_panel

        find_panel.open_contacts(subject.assembly(), subject.chosen_parts())

# SPDX-License-Identifier: LGPL-2.1-or-later
"""The commands of the workbench, their order in menu and toolbars."""

import FreeCADGui as Gui

from freecad.sheetmorph.commands import contacts, create, exchange, features, finding
from freecad.sheetmorph.commands import installation, motion, regions, sheets

_TOOLBARS = {
    "Morph": (create.CreateMorph, create.AddPart, create.ImportPart, sheets.ThicknessMap),
    "Regions": (
        regions.MarkFixed,
        regions.MarkHandle,
        regions.MarkFeature,
        regions.MarkFollower,
        finding.FindFeatures,
    ),
    "Contacts": (
        contacts.MarkContact,
        finding.FindContacts,
        contacts.Propagation,
        contacts.SetPrimary,
    ),
    "Features": (
        features.FeatureSettings,
        features.GroupFeatures,
        features.MakeCoaxial,
        features.KeepDistance,
    ),
    "Motion": (motion.MoveHandle, motion.ResetMotion),
    "Exchange": (exchange.ExportParts, exchange.ExportRecipe, exchange.ImportRecipe),
    "Help": (exchange.OpenExample, installation.CheckInstallation),
}


def register() -> dict[str, list[str]]:
    """Registers all commands; returns command names by title of the toolbar."""
    for classes in _TOOLBARS.values():
        for command in classes:
            Gui.addCommand(command.name, command())
    return {
        f"SheetMorph {title}": [command.name for command in classes]
        for title, classes in _TOOLBARS.items()
        if title != "Help"
    }


def menu() -> list[str]:
    """Command names of the menu, in groups."""
    names: list[str] = []
    for classes in _TOOLBARS.values():
        if names:
            names.append("Separator")
        names += [command.name for command in classes]
    return names

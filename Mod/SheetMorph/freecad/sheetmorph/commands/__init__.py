# SPDX-License-Identifier: LGPL-2.1-or-later
"""The commands of the workbench and their order in menu and toolbars."""

import FreeCADGui as Gui

from freecad.sheetmorph.commands import contacts, create, exchange, features, finding, guide
from freecad.sheetmorph.commands import installation, manual, motion, poses, regions, sheets, study
from freecad.sheetmorph.commands.base import Command
from freecad.sheetmorph.tools.marked import QT_TRANSLATE_NOOP

_TOOLBARS = {
    QT_TRANSLATE_NOOP("Workbench", "SheetMorph Morph"): (
        guide.OpenGuide,
        create.CreateMorph,
        create.AddPart,
        create.ImportPart,
        create.ReplaceFile,
        create.FollowShape,
        sheets.PrepareMesh,
        sheets.ThicknessMap,
        sheets.Flatten,
    ),
    QT_TRANSLATE_NOOP("Workbench", "SheetMorph Regions"): (
        regions.MarkFixed,
        regions.MarkHandle,
        regions.MarkFeature,
        regions.MarkFollower,
        finding.FindFeatures,
    ),
    QT_TRANSLATE_NOOP("Workbench", "SheetMorph Contacts"): (
        contacts.MarkContact,
        finding.FindContacts,
        contacts.Propagation,
        contacts.SetPrimary,
    ),
    QT_TRANSLATE_NOOP("Workbench", "SheetMorph Features"): (
        features.FeatureSettings,
        features.GroupFeatures,
        features.MakeCoaxial,
        features.KeepDistance,
    ),
    QT_TRANSLATE_NOOP("Workbench", "SheetMorph Motion"): (
        motion.MoveHandle,
        motion.ResetMotion,
        poses.SavePose,
        poses.BlendPoses,
        poses.CopyInPose,
        poses.CopyAsMeshes,
        study.Study,
        sheets.DeformedShape,
    ),
    QT_TRANSLATE_NOOP("Workbench", "SheetMorph Exchange"): (
        exchange.ExportParts,
        exchange.Certify,
        exchange.ExportRecipe,
        exchange.ImportRecipe,
    ),
    "Help": (exchange.OpenExample, manual.Manual, installation.CheckInstallation),
}


def register() -> dict[str, list[str]]:
    """Register all commands; return their names by toolbar title."""
    for classes in _TOOLBARS.values():
        for command in classes:
            Command.registered[command.name] = command()
            Gui.addCommand(command.name, Command.registered[command.name])
    return {
        title: [command.name for command in classes]
        for title, classes in _TOOLBARS.items()
        if title != "Help"
    }


def menu() -> list[str]:
    """Return the command names of the menu, in groups."""
    names: list[str] = []
    for classes in _TOOLBARS.values():
        if names:
            names.append("Separator")
        names += [command.name for command in classes]
    return names

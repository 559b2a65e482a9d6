# SPDX-License-Identifier: LGPL-2.1-or-later
"""Commands that save poses, blend them and copy them as ordinary meshes."""

import FreeCADGui as Gui

from freecad.sheetmorph import actions, subject
from freecad.sheetmorph.actions import call, name
from freecad.sheetmorph.commands.base import Command
from freecad.sheetmorph.qt import QtCore, QtWidgets, translate

QT_TRANSLATE_NOOP = QtCore.QT_TRANSLATE_NOOP


class SavePose(Command):
    """The command that saves the present motions under a name."""

    name = "SheetMorph_SavePose"
    text = QT_TRANSLATE_NOOP("SheetMorph_SavePose", "Save Pose…")
    tooltip = QT_TRANSLATE_NOOP(
        "SheetMorph_SavePose", "Saves the current positions of all handles under a name"
    )

    def possible(self) -> bool:
        """Return whether there is a handle."""
        return subject.handle() is not None

    def execute(self) -> None:
        """Let the user enter a name, and save the pose in one undo step."""
        owner = subject.assembly()
        number = len(subject.poses(owner)) + 1
        label, is_given = QtWidgets.QInputDialog.getText(
            Gui.getMainWindow(),
            translate("SheetMorph_SavePose", "Save Pose"),
            translate("SheetMorph_SavePose", "Name of the pose"),
            QtWidgets.QLineEdit.Normal,
            translate("SheetMorph_SavePose", "Pose {0}").format(number),
        )
        if is_given and label.strip():
            line = call("save_pose", name(owner), repr(label.strip()))
            actions.attempt("Save Pose", line, document=owner.Document)


class BlendPoses(Command):
    """The command that opens the panel to blend two poses."""

    name = "SheetMorph_BlendPoses"
    text = QT_TRANSLATE_NOOP("SheetMorph_BlendPoses", "Blend Poses…")
    tooltip = QT_TRANSLATE_NOOP(
        "SheetMorph_BlendPoses",
        "Blends from one pose to another with a slider, and compares the two",
    )

    def possible(self) -> bool:
        """Return whether there is a pose."""
        return subject.has(subject.POSE)

    def execute(self) -> None:
        """Open the panel with the selected pose, else with the last one."""
        from freecad.sheetmorph.panels import pose_panel

        owner = subject.assembly()
        chosen = subject.selected(subject.POSE) or subject.poses(owner)
        pose_panel.open_panel(owner, chosen[-1])


class CopyInPose(Command):
    """The command that copies a morph and applies a pose to the copy."""

    name = "SheetMorph_CopyInPose"
    text = QT_TRANSLATE_NOOP("SheetMorph_CopyInPose", "Copy in Pose")
    tooltip = QT_TRANSLATE_NOOP(
        "SheetMorph_CopyInPose",
        "Copies the whole morph and applies the selected pose to the copy",
    )

    def possible(self) -> bool:
        """Return whether one pose is selected."""
        return len(subject.selected(subject.POSE)) == 1

    def execute(self) -> None:
        """Copy the morph in one undo step."""
        (chosen,) = subject.selected(subject.POSE)
        line = call("copy_in_pose", name(chosen))
        actions.attempt("Copy in Pose", line, document=chosen.Document)


class CopyAsMeshes(Command):
    """The command that copies the deformed parts as ordinary meshes."""

    name = "SheetMorph_CopyAsMeshes"
    text = QT_TRANSLATE_NOOP("SheetMorph_CopyAsMeshes", "Copy as Meshes")
    tooltip = QT_TRANSLATE_NOOP(
        "SheetMorph_CopyAsMeshes",
        "Copies the parts as plain meshes, in their current shape or in the " "selected pose",
    )

    def possible(self) -> bool:
        """Return whether there is a part."""
        return subject.part() is not None

    def execute(self) -> None:
        """Copy the parts in one undo step."""
        owner, chosen = subject.assembly(), subject.selected(subject.POSE)
        poses = [name(chosen[0])] if chosen else []
        line = call("copy_as_meshes", name(owner), *poses)
        actions.attempt("Copy as Meshes", line, document=owner.Document)

# SPDX-License-Identifier: LGPL-2.1-or-later
"""What commands do to their targets, apart from files: API calls and panels."""

import FreeCADGui as Gui

from freecad.sheetmorph import actions, paths, subject
from freecad.sheetmorph.actions import call, name
from freecad.sheetmorph.commands.base import REGISTERED, Panel
from freecad.sheetmorph.qt import QtCore, QtGui, QtWidgets, translate


def join_parts(owner) -> None:
    """Open the panel of a new contact with the selected parts; OK creates it."""
    mine = subject.parts(owner)
    chosen = [part for part in subject.selected(subject.PART) if part in mine]
    Panel("contact_panel.create")(owner, chosen)


def find_features(owner) -> None:
    """Open the panel that lists the features found; OK changes the document."""
    Panel("find_panel.open_features")(owner, subject.chosen_parts())


def find_contacts(owner) -> None:
    """Open the panel that lists the contacts found; OK changes the document."""
    Panel("find_panel.open_contacts")(owner, subject.chosen_parts())


def study(owner) -> None:
    """Open the panel of the selected study, else of a new one."""
    chosen = subject.selected(subject.STUDY)
    Panel("study_panel.open_panel")(owner, chosen[-1] if chosen else None)


def blend_poses(owner) -> None:
    """Open the panel with the selected pose, else with the last one."""
    chosen = subject.selected(subject.POSE) or subject.poses(owner)
    Panel("pose_panel.open_panel")(owner, chosen[-1])


def save_pose(owner) -> None:
    """Let the user enter a name, and save the pose in one undo step."""
    label, is_given = QtWidgets.QInputDialog.getText(
        Gui.getMainWindow(),
        translate("SheetMorph_SavePose", "Save Pose"),
        translate("SheetMorph_SavePose", "Name of the pose"),
        QtWidgets.QLineEdit.Normal,
        translate("SheetMorph_SavePose", "Pose {0}").format(len(subject.poses(owner)) + 1),
    )
    if is_given and label.strip():
        line = call("save_pose", name(owner), repr(label.strip()))
        actions.attempt("Save Pose", line, document=owner.Document)


def reset_lines(owner) -> list[str]:
    """Return the calls that reset the selected handles, else all handles of the morph."""
    chosen = [r for r in subject.selected(subject.REGION) if r.Role == "handle"]
    handles = chosen or subject.regions(owner, "handle")
    return [call("reset_motion", name(handle)) for handle in handles]


def copy_lines(owner) -> list[str]:
    """Return the call that copies the parts as meshes, in the selected pose if there is one."""
    poses = [name(pose) for pose in subject.selected(subject.POSE)[:1]]
    return [call("copy_as_meshes", name(owner), *poses)]


def relation_lines(function: str, features: list) -> list[str]:
    """Return the call that relates form features; a group takes them as a list."""
    members = ", ".join(map(name, features))
    members = f"[{members}]" if function == "group" else members
    return [call(function, name(subject.assembly_of(features[0])), members)]


def toggle_lines(contacts: list) -> list[str]:
    """Return the calls that switch contacts on or off."""
    return [call("set_active", name(one), repr(not one.Active)) for one in contacts]


def open_guide() -> None:
    """Open the guide, whose buttons run commands."""
    from freecad.sheetmorph.panels.guide import Guide

    Guide.open(REGISTERED)


def open_manual() -> None:
    """Open the start page of the manual in the browser."""
    page = paths.manual("index.html")
    if not page:
        raise RuntimeError(
            "The manual is not installed; run ./sheetmorph docs, then ./sheetmorph install."
        )
    if not QtGui.QDesktopServices.openUrl(QtCore.QUrl(page)):
        raise RuntimeError(f"No browser opens {page}; open this address in one.")

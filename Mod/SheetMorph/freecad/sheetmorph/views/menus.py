# SPDX-License-Identifier: LGPL-2.1-or-later
"""The actions of double clicks and context menus in the tree."""

import FreeCADGui as Gui

from freecad.sheetmorph import actions, paths
from freecad.sheetmorph.actions import call, name
from freecad.sheetmorph.objects import model
from freecad.sheetmorph.panels.guide import Guide
from freecad.sheetmorph.qt import connect, icon_of, translate
from freecad.sheetmorph.tools.marked import QT_TRANSLATE_NOOP

USED = QT_TRANSLATE_NOOP("SheetMorph_menus", "Do Not Use Contact")
UNUSED = QT_TRANSLATE_NOOP("SheetMorph_menus", "Use Contact")

MARKS = {
    "fixed": ("MarkFixed", "Mark Fixed Region…"),
    "handle": ("MarkHandle", "Mark Handle…"),
    "form feature": ("MarkFeature", "Mark Form Features…"),
    "follower": ("MarkFollower", "Mark Follower…"),
}


def move(handle) -> None:
    """Open the Move Handle panel unless another panel is open."""
    from freecad.sheetmorph.panels import move_panel

    _opened("Move Handle", lambda: move_panel.open_panel(handle))


def edit(region) -> None:
    """Open the picking panel of an existing region."""
    from freecad.sheetmorph.panels import region_panel

    _opened("Region", lambda: region_panel.edit(region))


def edit_feature(feature) -> None:
    """Open the panel of a form feature."""
    from freecad.sheetmorph.panels import feature_panel

    _opened("Form Feature", lambda: feature_panel.open_panel(feature))


def edit_contact(contact) -> None:
    """Open the panel of an existing contact."""
    from freecad.sheetmorph.panels import contact_panel

    _opened("Contact", lambda: contact_panel.edit(contact))


def show_propagation(assembly) -> None:
    """Open the Propagation panel."""
    from freecad.sheetmorph.panels import propagation_panel

    _opened("Propagation", lambda: propagation_panel.open_panel(assembly))


def _opened(title: str, action) -> None:
    """Open a panel if no other one is open, and report an error."""

    def opened() -> None:
        try:
            action()
        except actions.FAULTS as error:
            actions.tell(title, error)

    Guide.make_room(opened)


def add_assembly_actions(menu, assembly) -> None:
    """Add Propagation, and an entry that shows a fault."""
    if model.failure_of(assembly):
        title = QT_TRANSLATE_NOOP("SheetMorph_menus", "Show Problem")
        _add(menu, "MorphFault", title, lambda: Gui.runCommand("SheetMorph_Guide"))
    _add(
        menu,
        "Propagation",
        QT_TRANSLATE_NOOP("SheetMorph_menus", "Propagation…"),
        lambda: show_propagation(assembly),
    )


def add_contact_actions(menu, contact) -> None:
    """Add entries to edit a contact and to switch it on or off."""
    line = call("set_active", name(contact), repr(not contact.Active))
    title = USED if contact.Active else UNUSED
    icon = "ContactOff" if contact.Active else "MarkContact"
    _add(
        menu,
        "MarkContact",
        QT_TRANSLATE_NOOP("SheetMorph_menus", "Edit Contact…"),
        lambda: edit_contact(contact),
    )
    _add(menu, icon, title, lambda: actions.attempt(title, line))


def mark(part, role: str) -> None:
    """Open the picking panel for a new region of a part."""
    from freecad.sheetmorph.panels import region_panel

    _opened("Region", lambda: region_panel.create(part, role))


def add_part_actions(menu, assembly, part) -> None:
    """Add entries for new regions, and Set as Primary."""
    for role, (icon, title) in MARKS.items():
        _add(menu, icon, title, lambda r=role: mark(part, r))
    menu.addSeparator()
    line = call("set_primary", name(assembly), name(part))
    entry = _add(
        menu,
        "PartPrimary",
        QT_TRANSLATE_NOOP("SheetMorph_menus", "Set as Primary"),
        lambda: actions.attempt("Set as Primary", line),
    )
    entry.setEnabled(assembly.Primary != part)
    if part.ShapeSource is not None:
        title = QT_TRANSLATE_NOOP("SheetMorph_menus", "Follow Shape")
        _add(menu, "FollowShape", title, lambda: Gui.runCommand("SheetMorph_FollowShape"))


def apply_pose(pose) -> None:
    """Apply a pose unless a panel is open."""
    line = call("apply_pose", name(pose))
    _opened("Apply Pose", lambda: actions.run("Apply Pose", line, document=pose.Document))


def blend_poses(pose) -> None:
    """Open the panel that blends to a pose with a slider."""
    from freecad.sheetmorph.panels import pose_panel

    owner = model.assembly_of(pose)
    _opened("Blend Poses", lambda: pose_panel.open_panel(owner, pose))


def edit_study(study) -> None:
    """Open the panel of a study."""
    from freecad.sheetmorph.panels import study_panel

    owner = model.assembly_of(study)
    _opened("Study", lambda: study_panel.open_panel(owner, study))


def add_study_actions(menu, study) -> None:
    """Add the entry for the panel of a study."""
    _add(menu, "Study", QT_TRANSLATE_NOOP("SheetMorph_menus", "Study…"), lambda: edit_study(study))


def add_pose_actions(menu, pose) -> None:
    """Add entries to apply, blend and copy a pose."""
    line = call("copy_as_meshes", name(model.assembly_of(pose)), name(pose))
    _add(menu, "Pose", "Apply Pose", lambda: apply_pose(pose))
    _add(menu, "BlendPoses", "Blend Poses…", lambda: blend_poses(pose))
    _add(menu, "CopyAsMeshes", "Copy as Meshes", lambda: actions.attempt("Copy as Meshes", line))


def add_region_actions(menu, region) -> None:
    """Add move and reset for handles, settings for form features, and editing for all."""
    if region.Role == "handle":
        line = call("reset_motion", name(region))
        _add(
            menu,
            "MoveHandle",
            QT_TRANSLATE_NOOP("SheetMorph_menus", "Move Handle…"),
            lambda: move(region),
        )
        _add(
            menu,
            "ResetMotion",
            QT_TRANSLATE_NOOP("SheetMorph_menus", "Reset Motion"),
            lambda: actions.attempt("Reset Motion", line),
        )
    if region.Role == "form feature":
        _add(
            menu,
            "FeatureSettings",
            QT_TRANSLATE_NOOP("SheetMorph_menus", "Form Feature Settings…"),
            lambda: edit_feature(region),
        )
    _add(
        menu,
        "PickFace",
        QT_TRANSLATE_NOOP("SheetMorph_menus", "Edit Region…"),
        lambda: edit(region),
    )


def _add(menu, icon: str, text: str, action):
    entry = menu.addAction(icon_of(paths.icon(icon)), translate("SheetMorph_menus", text))
    connect(entry, "triggered()", lambda *_: action())
    return entry

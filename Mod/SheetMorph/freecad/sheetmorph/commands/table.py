# SPDX-License-Identifier: LGPL-2.1-or-later
"""The table of commands, and their places in menu and toolbars.

Shortcuts begin with Y, because no command of FreeCAD 0.20 to 1.1 does.
"""

from freecad.sheetmorph.actions import call, name
from freecad.sheetmorph.commands import acts, create, exchange, needs
from freecad.sheetmorph.commands.base import Command, Panel, Step
from freecad.sheetmorph.kinds import ASSEMBLY, CONTACT, PART, POSE, REGION, STUDY
from freecad.sheetmorph.subject import assembly_of
from freecad.sheetmorph.tools.marked import QT_TRANSLATE_NOOP

SOURCE, EMPTY = "a mesh or shape", "nothing"  # selections with a context menu, besides kinds

COMMANDS = (
    Command(
        "SheetMorph_Guide",
        "&Guide",
        "Guides you through a morph step by step: shows what is missing and opens the right panel",
        needs.NOTHING,
        acts.open_guide,
        keys="Y, G",
        on=(EMPTY,),
        alters=False,
    ),
    Command(
        "SheetMorph_CreateMorph",
        "&Create Morph",
        "Creates a morph from the selected meshes and shapes, which stay unchanged",
        needs.NOTHING,
        create.create_morph,
        keys="Y, N",
        on=(SOURCE,),
    ),
    Command(
        "SheetMorph_ImportPart",
        "&Import Part…",
        "Imports a mesh, every property of a deck, or every solid of a CAD file as parts",
        needs.CLEAR_MORPH,
        create.import_part,
        keys="Y, I",
        on=(ASSEMBLY, EMPTY),
    ),
    Command(
        "SheetMorph_AddPart",
        "&Add Part",
        "Adds the selected meshes and shapes to the morph as parts",
        needs.SOURCES,
        create.add_part,
        keys="Y, A",
        on=(SOURCE,),
    ),
    Command(
        "SheetMorph_ReplaceFile",
        "&Replace File…",
        "Reads the changed file of the selected part and finds its regions on the new mesh; "
        "regions that changed are listed and selected",
        needs.PART,
        create.replace_file,
        on=(PART,),
    ),
    Command(
        "SheetMorph_FollowShape",
        "&Follow Shape",
        "Meshes the changed body or shape of the selected part again and finds its regions on "
        "the new mesh; regions that changed are listed and selected",
        needs.SHAPED_PART,
        create.follow_shape,
        on=(PART,),
    ),
    Command(
        "SheetMorph_PrepareMesh",
        "&Prepare Mesh…",
        "Checks the mesh of the selected part, repairs it and remeshes it",
        needs.PART,
        Panel("prepare_panel.open_panel"),
        on=(PART,),
    ),
    Command(
        "SheetMorph_ThicknessMap",
        "&Thickness…",
        "Shows the thickness of the selected part in colours, and lets the part bend as one sheet",
        needs.PART,
        Panel("thickness_panel.open_panel"),
        on=(PART,),
    ),
    Command(
        "SheetMorph_SetPrimary",
        "&Set as Primary",
        "Makes the selected part the primary part, which is deformed first; the others follow it",
        needs.FOLLOWING_PART,
        Step(lambda part: [call("set_primary", name(assembly_of(part)), name(part))]),
        on=(PART,),
    ),
    Command(
        "SheetMorph_MarkFixed",
        "Mark &Fixed Region…",
        "Marks a region that stays in place, by picking in the 3D view",
        needs.PART,
        Panel("region_panel.create", "fixed"),
        keys="Y, X",
        on=(PART,),
    ),
    Command(
        "SheetMorph_MarkHandle",
        "Mark &Handle…",
        "Marks a region that you move and turn; the part follows",
        needs.PART,
        Panel("region_panel.create", "handle"),
        keys="Y, H",
        on=(PART,),
    ),
    Command(
        "SheetMorph_MarkFeature",
        "Mark F&orm Features…",
        "Marks holes and other form features, which move but keep their shape",
        needs.PART,
        Panel("region_panel.create", "form feature"),
        keys="Y, E",
        on=(PART,),
    ),
    Command(
        "SheetMorph_MarkFollower",
        "Mark Fo&llower…",
        "Marks a region that follows the control meshes of the part's contacts",
        needs.PART,
        Panel("region_panel.create", "follower"),
        keys="Y, L",
        on=(PART,),
    ),
    Command(
        "SheetMorph_FindFeatures",
        "F&ind Features…",
        "Finds holes and other features on all parts; the ones you accept become form features",
        needs.PARTED_MORPH,
        acts.find_features,
        keys="Y, F",
        on=(PART, ASSEMBLY),
    ),
    Command(
        "SheetMorph_EditRegion",
        "&Edit Region…",
        "Changes the vertices of the selected region by picking in the 3D view",
        needs.REGION,
        Panel("region_panel.edit"),
        on=(REGION,),
    ),
    Command(
        "SheetMorph_FeatureSettings",
        "Form Feature &Settings…",
        "Sets the rotation, the motion and the size of the selected form feature",
        needs.FEATURE,
        Panel("feature_panel.open_panel"),
        keys="Y, S",
        on=("form feature",),
    ),
    Command(
        "SheetMorph_GroupFeatures",
        "&Group Form Features",
        "Moves the selected form features of a part as one rigid body",
        needs.FEATURES,
        Step(lambda features: acts.relation_lines("group", features)),
        on=("form feature",),
    ),
    Command(
        "SheetMorph_MakeCoaxial",
        "&Make Coaxial",
        "Keeps two selected form features on a common axis, on one part or on two",
        needs.TWO_FEATURES,
        Step(lambda features: acts.relation_lines("coaxial", features)),
        on=("form feature",),
    ),
    Command(
        "SheetMorph_KeepDistance",
        "&Keep Distance",
        "Keeps the distance between two selected form features, on one part or on two",
        needs.TWO_FEATURES,
        Step(lambda features: acts.relation_lines("keep_distance", features)),
        on=("form feature",),
    ),
    Command(
        "SheetMorph_MarkContact",
        "&Mark Contact…",
        "Joins two parts where they touch, so that one follows the other. Select both parts, or "
        "click on them in the 3D view",
        needs.TWO_PARTS,
        acts.join_parts,
        keys="Y, C",
        on=(PART,),
    ),
    Command(
        "SheetMorph_FindContacts",
        "&Find Contacts…",
        "Finds where parts touch or are bolted; the ones you accept become contacts",
        needs.TWO_PARTS,
        acts.find_contacts,
        keys="Y, K",
        on=(ASSEMBLY,),
    ),
    Command(
        "SheetMorph_EditContact",
        "&Edit Contact…",
        "Changes the type, the regions and the settings of the selected contact",
        needs.CONTACT_PAIR,
        Panel("contact_panel.edit"),
        on=(CONTACT,),
    ),
    Command(
        "SheetMorph_ToggleContact",
        "&Toggle Contact",
        "Switches the selected contacts off, so that nothing propagates through them, or on again",
        needs.CONTACTS,
        Step(acts.toggle_lines),
        on=(CONTACT,),
        picture="ContactOff",
    ),
    Command(
        "SheetMorph_Propagation",
        "&Propagation…",
        "Shows how the motion spreads from the primary part through the contacts",
        needs.PARTED_MORPH,
        Panel("propagation_panel.open_panel"),
        keys="Y, P",
        on=(ASSEMBLY, CONTACT),
    ),
    Command(
        "SheetMorph_MoveHandle",
        "&Move Handle…",
        "Moves and turns a handle; the parts follow as you change the values",
        needs.HANDLE,
        Panel("move_panel.open_panel"),
        keys="Y, M",
        on=("handle", ASSEMBLY, EMPTY),
    ),
    Command(
        "SheetMorph_ResetMotion",
        "&Reset Motion",
        "Returns the selected handles, or all handles of the morph, to rest",
        needs.MOVING_MORPH,
        Step(acts.reset_lines),
        keys="Y, R",
        on=("handle", ASSEMBLY, EMPTY),
    ),
    Command(
        "SheetMorph_SavePose",
        "&Save Pose…",
        "Saves the current positions of all handles under a name",
        needs.MOVING_MORPH,
        acts.save_pose,
        keys="Y, V",
        on=(ASSEMBLY, EMPTY),
    ),
    Command(
        "SheetMorph_ApplyPose",
        "&Apply Pose",
        "Moves all handles to their positions in the selected pose",
        needs.POSE,
        Step(lambda pose: [call("apply_pose", name(pose))]),
        on=(POSE,),
        picture="Pose",
    ),
    Command(
        "SheetMorph_BlendPoses",
        "&Blend Poses…",
        "Blends from one pose to another with a slider, and compares the two",
        needs.POSED_MORPH,
        acts.blend_poses,
        keys="Y, B",
        on=(POSE,),
    ),
    Command(
        "SheetMorph_CopyInPose",
        "&Copy in Pose",
        "Copies the whole morph and applies the selected pose to the copy",
        needs.POSE,
        Step(lambda pose: [call("copy_in_pose", name(pose))]),
        on=(POSE,),
    ),
    Command(
        "SheetMorph_Study",
        "S&tudy…",
        "Computes and certifies many variants in the background and lists them in a table",
        needs.MOVING_MORPH,
        acts.study,
        keys="Y, T",
        on=(STUDY, ASSEMBLY),
    ),
    Command(
        "SheetMorph_ExportParts",
        "&Export Parts…",
        "Writes all deformed parts to a folder, each in its original file format",
        needs.MORPH,
        exchange.export_parts,
        keys="Y, O",
        on=(ASSEMBLY, EMPTY),
        alters=False,
    ),
    Command(
        "SheetMorph_Certify",
        "&Certificate…",
        "Writes all deformed parts to a folder, reads them back, and checks them against criteria",
        needs.MORPH,
        exchange.certify,
        on=(ASSEMBLY,),
        alters=False,
    ),
    Command(
        "SheetMorph_DeformedShape",
        "&Deformed Shape",
        "Creates a deformed CAD shape of the selected part, with the faces of its original shape",
        needs.PART_WITH_FACES,
        Step(lambda part: [call("deformed_shape", name(part))]),
        on=(PART,),
    ),
    Command(
        "SheetMorph_Flatten",
        "&Flatten",
        "Flattens the selected part, in its current shape and at rest: sketches of blank and bend "
        "lines",
        needs.PART,
        Step(lambda part: [call("flatten", name(part), at_rest="True")]),
    ),
    Command(
        "SheetMorph_CopyAsMeshes",
        "Copy as &Meshes",
        "Copies the parts as plain meshes, in their current shape or in the selected pose",
        needs.PARTED_MORPH,
        Step(acts.copy_lines),
        on=(POSE,),
    ),
    Command(
        "SheetMorph_ExportRecipe",
        "E&xport Recipe…",
        "Writes the morph as a recipe that also runs without FreeCAD",
        needs.MORPH,
        exchange.export_recipe,
        alters=False,
    ),
    Command(
        "SheetMorph_ImportRecipe",
        "&Import Recipe…",
        "Creates a morph from a recipe and its mesh files",
        needs.NOTHING,
        exchange.import_recipe,
    ),
    Command(
        "SheetMorph_OpenExample",
        "&Open Example…",
        "Opens an example assembly that is ready to move",
        needs.NOTHING,
        exchange.open_example,
    ),
    Command(
        "SheetMorph_Manual",
        "SheetMorph &Manual",
        "Opens the manual in the browser, also without a network",
        needs.NOTHING,
        acts.open_manual,
        alters=False,
        needs_kernel=False,
    ),
    Command(
        "SheetMorph_CheckInstallation",
        "&Check Installation",
        "Checks the deformation kernel and shows a report that you can copy",
        needs.NOTHING,
        Panel("report_dialog.show"),
        alters=False,
        needs_kernel=False,
    ),
)

MENU = {
    "": "Guide |",
    QT_TRANSLATE_NOOP("Workbench", "&Parts"): (
        "CreateMorph ImportPart AddPart | ReplaceFile FollowShape | PrepareMesh ThicknessMap "
        "SetPrimary"
    ),
    QT_TRANSLATE_NOOP("Workbench", "&Regions"): (
        "MarkFixed MarkHandle MarkFeature MarkFollower | FindFeatures | EditRegion"
    ),
    QT_TRANSLATE_NOOP("Workbench", "&Features"): (
        "FeatureSettings | GroupFeatures MakeCoaxial KeepDistance"
    ),
    QT_TRANSLATE_NOOP("Workbench", "&Contacts"): (
        "MarkContact FindContacts | EditContact ToggleContact | Propagation"
    ),
    QT_TRANSLATE_NOOP("Workbench", "&Motion"): (
        "MoveHandle ResetMotion | SavePose ApplyPose BlendPoses CopyInPose | Study"
    ),
    QT_TRANSLATE_NOOP("Workbench", "&Exchange"): (
        "ExportParts Certify | DeformedShape Flatten CopyAsMeshes | ExportRecipe ImportRecipe"
    ),
    "&Help": "OpenExample Manual CheckInstallation",  # FreeCAD translates it
}
"""Submenus with the commands in them, without prefix; a bar separates groups."""

FIRST = ("&Motion", "&Regions", "&Features", "&Contacts")
"""Submenus whose commands come first in a context menu: FreeCAD shows the first entry in bold."""

TOOLBARS = {
    QT_TRANSLATE_NOOP("Workbench", "SheetMorph Parts"): (
        "Guide | CreateMorph ImportPart AddPart ReplaceFile | PrepareMesh ThicknessMap SetPrimary"
    ),
    QT_TRANSLATE_NOOP("Workbench", "SheetMorph Regions"): (
        "MarkFixed MarkHandle MarkFeature MarkFollower FindFeatures | FeatureSettings "
        "GroupFeatures MakeCoaxial KeepDistance | MarkContact FindContacts Propagation"
    ),
    QT_TRANSLATE_NOOP("Workbench", "SheetMorph Motion"): (
        "MoveHandle ResetMotion | SavePose BlendPoses Study | ExportParts Certify CopyAsMeshes"
    ),
}
"""Toolbars for the steps of the work: bring in parts, mark them, move them."""


def names(row: str) -> list[str]:
    """Return the names of the commands in a row of MENU or TOOLBARS, and of its separators."""
    return ["Separator" if word == "|" else f"SheetMorph_{word}" for word in row.split()]

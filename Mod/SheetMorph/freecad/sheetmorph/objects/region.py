# SPDX-License-Identifier: LGPL-2.1-or-later
"""A region: fixed vertices of one part, a handle, a form feature, or a follower."""

from __future__ import annotations

from dataclasses import replace

import FreeCAD

from freecad.sheetmorph.objects.assembly import join_assembly
from freecad.sheetmorph.objects.migrations import ADVANCED
from freecad.sheetmorph.objects.model import REGION
from freecad.sheetmorph.objects.orphans import MemberProxy
from freecad.sheetmorph.objects.properties import (
    HIDDEN,
    READ_ONLY,
    SHOWN,
    Property,
    number_of,
    vector_of,
)
from freecad.sheetmorph.tools.motion import Motion

FIXED, HANDLE, FORM_FEATURE, FOLLOWER = "fixed", "handle", "form feature", "follower"
ROLES = [FIXED, HANDLE, FORM_FEATURE, FOLLOWER]
FREE, INTERPOLATED, PRESCRIBED = "free", "interpolated", "prescribed"
ROTATIONS = [FREE, INTERPOLATED, PRESCRIBED]
PLANE, LINE, AXIS = "plane", "line", "axis"
MOTIONS = [FREE, "fixed", "translation", PLANE, LINE, AXIS]
MOTION_DOC = (
    "Motion that the form feature is allowed. Free: any; fixed: none; "
    "translation: no rotation; plane: in a plane, and about its normal; "
    "line: along a line; axis: about an axis"
)
SIZE_DOC = (
    "Diameter of a hole, length of a slot, or radius of a cylinder. The "
    "form is then exact. 0: as in the mesh"
)
WHERE_DOC = (
    "Selector of the region, as in a recipe, in the coordinates of the "
    "part's file; empty if only the vertices are stored"
)
UP = FreeCAD.Vector(0, 0, 1)

COMMON = (
    Property(
        "Enumeration",
        "Role",
        "Region",
        "Fixed: stays in place. Handle: you move it. Form feature: keeps its "
        "shape. Follower: follows the control mesh of the part",
        ROLES,
    ),
    Property("LinkHidden", "Part", "Region", "The part of the region", mode=READ_ONLY),
    Property("FloatList", "Vertices", "Region", "Indices of the vertices", mode=HIDDEN),
    Property("String", "Where", ADVANCED, WHERE_DOC, mode=READ_ONLY),
)
MOTION = (
    Property("Distance", "TranslationX", "Motion", "Translation along the global x axis"),
    Property("Distance", "TranslationY", "Motion", "Translation along the global y axis"),
    Property("Distance", "TranslationZ", "Motion", "Translation along the global z axis"),
    Property("Vector", "Axis", "Motion", "Axis of the rotation, global", UP),
    Property("Angle", "Angle", "Motion", "Angle of the rotation; more than one turn is possible"),
    Property("Vector", "Pivot", "Motion", "Centre of the rotation, global, at rest"),
    Property("Bool", "PivotAtCentroid", "Motion", "Rotate about the centroid of the region", True),
    Property("Bool", "FreeRotation", "Motion", "The rotation of the handle follows the sheet"),
)
FEATURE = (
    Property(
        "Enumeration",
        "Rotation",
        "Form Feature",
        "Free: a rigid body in an elastic sheet. Interpolated: follows the "
        "handles around it, as published. Prescribed: by axis and angle",
        ROTATIONS,
    ),
    Property("Vector", "RotationAxis", "Form Feature", "Axis of a prescribed rotation", UP),
    Property("Angle", "RotationAngle", "Form Feature", "Angle of a prescribed rotation"),
    Property("Enumeration", "Motion", "Form Feature", MOTION_DOC, MOTIONS),
    Property("Vector", "MotionDirection", "Form Feature", "Normal, line or axis, global", UP),
    Property("Vector", "MotionPoint", "Form Feature", "Point on the axis, global, at rest"),
    Property("Length", "Size", "Form Feature", SIZE_DOC),
)


SHOWING = ("Role", "PivotAtCentroid", "FreeRotation", "Rotation", "Motion")
"""Properties that determine which others are shown."""


class RegionProxy(MemberProxy):
    """Proxy of a region; it has the properties of all roles and shows those of its own role."""

    Type = REGION
    PROPERTIES = COMMON + MOTION + FEATURE

    def __init__(self, obj):
        super().__init__(obj)
        show_properties_of_role(obj)

    def restore(self, obj) -> None:
        """Add the region to the morph of its part."""
        show_properties_of_role(obj)
        join_assembly(obj, obj.Part)

    def onChanged(self, obj, name: str) -> None:
        """Update the property editor after a change of role, pivot, rotation or motion."""
        if name in SHOWING and is_complete(obj):
            show_properties_of_role(obj)


def is_complete(obj) -> bool:
    """Return whether all properties exist; FreeCAD reports changes before that."""
    return RegionProxy.PROPERTIES[-1].name in obj.PropertiesList


def show_properties_of_role(obj) -> None:
    """Hide the properties without meaning for the role of the region."""
    is_handle, is_feature = obj.Role == HANDLE, obj.Role == FORM_FEATURE
    for row in MOTION:
        obj.setEditorMode(row.name, SHOWN if is_handle else HIDDEN)
    if is_handle and obj.PivotAtCentroid:
        obj.setEditorMode("Pivot", READ_ONLY)
    if obj.FreeRotation:
        obj.setEditorMode("Axis", HIDDEN)
        obj.setEditorMode("Angle", HIDDEN)
    for row in FEATURE:
        obj.setEditorMode(row.name, SHOWN if is_feature else HIDDEN)
    if obj.Rotation != PRESCRIBED:
        obj.setEditorMode("RotationAxis", HIDDEN)
        obj.setEditorMode("RotationAngle", HIDDEN)
    if obj.Motion not in (PLANE, LINE, AXIS):
        obj.setEditorMode("MotionDirection", HIDDEN)
    if obj.Motion != AXIS:
        obj.setEditorMode("MotionPoint", HIDDEN)


def motion_of(region) -> Motion:
    """Return the motion of a handle, or the rotation of a form feature as a motion."""
    if region.Role == FORM_FEATURE:
        return Motion(
            axis=vector_of(region, "RotationAxis"), angle=number_of(region, "RotationAngle")
        )
    pivot = None if region.PivotAtCentroid else vector_of(region, "Pivot")
    translation = tuple(number_of(region, f"Translation{axis}") for axis in "XYZ")
    return Motion(translation, vector_of(region, "Axis"), number_of(region, "Angle"), pivot)


def as_told(region, motion: Motion) -> Motion:
    """Return the part of a region's motion that the kernel needs."""
    if region.Role == FORM_FEATURE:
        return replace(motion, translation=None, pivot=None)
    return replace(motion, angle=0.0) if region.FreeRotation else motion

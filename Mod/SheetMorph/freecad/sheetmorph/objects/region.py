# SPDX-License-Identifier: LGPL-2.1-or-later
"""A region: vertices of one part that are fixed, moved by a handle, rigid, or followers."""

from __future__ import annotations

import FreeCAD

from freecad.sheetmorph.objects.model import REGION
from freecad.sheetmorph.objects.properties import HIDDEN, READ_ONLY, SHOWN, Property
from freecad.sheetmorph.objects.proxy import ObjectProxy

FIXED, HANDLE, FORM_FEATURE, FOLLOWER = "fixed", "handle", "form feature", "follower"
ROLES = [FIXED, HANDLE, FORM_FEATURE, FOLLOWER]
INTERPOLATED, PRESCRIBED = "interpolated", "prescribed"
UP = FreeCAD.Vector(0, 0, 1)

COMMON = (
    Property(
        "Enumeration",
        "Role",
        "Region",
        "Stays (fixed), moves as you say (handle), keeps its shape (form feature), or goes where "
        "the control mesh of the part takes it (follower)",
        ROLES,
    ),
    Property("LinkHidden", "Part", "Region", "The part the vertices belong to", mode=READ_ONLY),
    Property("FloatList", "Vertices", "Region", "Indices of the vertices", mode=HIDDEN),
)
MOTION = (
    Property("Distance", "TranslationX", "Motion", "Translation along the global x axis"),
    Property("Distance", "TranslationY", "Motion", "Translation along the global y axis"),
    Property("Distance", "TranslationZ", "Motion", "Translation along the global z axis"),
    Property("Vector", "Axis", "Motion", "Axis of the rotation, global", UP),
    Property("Angle", "Angle", "Motion", "Angle of the rotation, any number of turns"),
    Property("Vector", "Pivot", "Motion", "Point the rotation turns about, global, at rest"),
    Property("Bool", "PivotAtCentroid", "Motion", "Turn about the centroid of the region", True),
)
ROTATION = (
    Property(
        "Enumeration",
        "Rotation",
        "Form Feature",
        "Turned as the sheet around it, or as prescribed",
        [INTERPOLATED, PRESCRIBED],
    ),
    Property("Vector", "RotationAxis", "Form Feature", "Axis of a prescribed rotation", UP),
    Property("Angle", "RotationAngle", "Form Feature", "Angle of a prescribed rotation"),
)


class RegionProxy(ObjectProxy):
    """Proxy of a region; all properties exist whatever the role, those of the role are shown."""

    Type = REGION
    PROPERTIES = COMMON + MOTION + ROTATION

    def __init__(self, obj):
        super().__init__(obj)
        show_properties_of_role(obj)

    def onDocumentRestored(self, obj) -> None:
        super().onDocumentRestored(obj)
        show_properties_of_role(obj)

    def onChanged(self, obj, name: str) -> None:
        """Follow a change of role or of the kind of pivot in the property editor."""
        if name in ("Role", "PivotAtCentroid", "Rotation") and is_complete(obj):
            show_properties_of_role(obj)

    def execute(self, _obj) -> None:
        """Do nothing: the deformation that depends on the region reads it."""


def is_complete(obj) -> bool:
    """Whether all properties have been added; changes are announced before."""
    return RegionProxy.PROPERTIES[-1].name in obj.PropertiesList


def show_properties_of_role(obj) -> None:
    """Hide the properties that mean nothing for the role of the region."""
    is_handle, is_feature = obj.Role == HANDLE, obj.Role == FORM_FEATURE
    for row in MOTION:
        obj.setEditorMode(row.name, SHOWN if is_handle else HIDDEN)
    if is_handle and obj.PivotAtCentroid:
        obj.setEditorMode("Pivot", READ_ONLY)
    is_prescribed = is_feature and obj.Rotation == PRESCRIBED
    obj.setEditorMode("Rotation", SHOWN if is_feature else HIDDEN)
    for name in ("RotationAxis", "RotationAngle"):
        obj.setEditorMode(name, SHOWN if is_prescribed else HIDDEN)

# SPDX-License-Identifier: LGPL-2.1-or-later
"""What differs between FreeCAD 0.20, 1.0 and 1.1, in one place; of Qt, `qt.py` knows it.

Found by what is there, never by the number of a version: a FreeCAD that somebody built answers
for itself.
"""

import FreeCAD as App

DRAGGERS = ("SoFCCSysDragger", "SoTransformDragger")
"""FreeCAD's dragger of arrows and arcs in Coin, until 1.0 and since 1.1, of the same fields."""

SELECTION_SWITCHES = ("selectionRole", "selectionEnabled")
"""The field of a 3D view's root that says whether clicks select, until 1.0 and since 1.1."""


_viewers: dict = {}


def viewer_of(view):
    """The viewer of a 3D view, whose Python object outlives it from then on.

    FreeCAD drops its own reference when the view ends, without holding Python's lock: were it the
    last, Python 3.14 would die of it, and FreeCAD 1.1 with it.
    """
    viewer = view.getViewer()
    _viewers[id(viewer)] = viewer
    return viewer


def take_gloss(view_object) -> None:
    """Leaves a sheet its colour where it faces the eye: since 1.0 it shines white there."""
    if "ShapeAppearance" in view_object.PropertiesList:
        material = view_object.ShapeAppearance[0]
        material.SpecularColor = (0.0, 0.0, 0.0)
        view_object.ShapeAppearance = (material,)


def shows_errors() -> bool:
    """Whether FreeCAD itself shows an error that is printed, in its notification area: since 1.0,
    unless the user wants boxes that wait."""
    wishes = App.ParamGet("User parameter:BaseApp/Preferences/NotificationArea")
    entries = ("NotificationAreaEnabled", "NonIntrusiveNotificationsEnabled")
    has_area = hasattr(App.Console, "PrintTranslatedUserError")
    return has_area and all(wishes.GetBool(entry, True) for entry in entries)

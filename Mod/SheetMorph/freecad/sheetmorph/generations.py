# SPDX-License-Identifier: LGPL-2.1-or-later
"""The differences between FreeCAD 0.20, 1.0 and 1.1; those of Qt are in `qt.py`.

Features are detected, not derived from a version number, so that custom builds of FreeCAD work too.
"""

import FreeCAD as App

DRAGGERS = ("SoFCCSysDragger", "SoTransformDragger")
"""FreeCAD's dragger of arrows and arcs in Coin, until 1.0 and since 1.1, with equal fields."""

SELECTION_SWITCHES = ("selectionRole", "selectionEnabled")
"""The field of a 3D view's root for selection by clicks, until 1.0 and since 1.1."""


def document_named(name: str):
    """Return an open document by its name, None if there is none.

    `App.listDocuments` of FreeCAD 0.20 leaks every name that it returns, so no code that runs often
    may call it.
    """
    try:
        return App.getDocument(name)
    except NameError:
        return None


_viewers: dict = {}


def viewer_of(view):
    """Return the viewer of a 3D view, whose Python object outlives the view from then on.

    FreeCAD drops its own reference when the view ends, without Python's global lock. If that were
    the last reference, Python 3.14 would crash, and FreeCAD 1.1 with it.
    """
    viewer = view.getViewer()
    _viewers[id(viewer)] = viewer
    return viewer


def take_gloss(view_object) -> None:
    """Remove the specular colour, with which a sheet looks white from the front since 1.0."""
    if "ShapeAppearance" in view_object.PropertiesList:
        material = view_object.ShapeAppearance[0]
        material.SpecularColor = (0.0, 0.0, 0.0)
        view_object.ShapeAppearance = (material,)


def shows_errors() -> bool:
    """Return whether FreeCAD shows printed errors in its notification area (since 1.0).

    The user may prefer message boxes instead.
    """
    wishes = App.ParamGet("User parameter:BaseApp/Preferences/NotificationArea")
    entries = ("NotificationAreaEnabled", "NonIntrusiveNotificationsEnabled")
    has_area = hasattr(App.Console, "PrintTranslatedUserError")
    return has_area and all(wishes.GetBool(entry, True) for entry in entries)

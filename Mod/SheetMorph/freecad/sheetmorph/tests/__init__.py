# SPDX-License-Identifier: LGPL-2.1-or-later
"""Tests that run inside FreeCAD, with and without a window: `freecadcmd -t MODULE`."""

MODULES = tuple(
    f"freecad.sheetmorph.tests.test_{name}"
    for name in (
        "conversion",
        "snapshots",
        "units",
        "kernel",
        "objects",
        "regions",
        "selectors",
        "motions",
        "features",
        "placements",
        "documents",
        "undo",
        "failures",
        "contacts",
        "propagation",
        "welded",
        "thin",
        "steel",
        "preparing",
        "replacing",
        "following",
        "files",
        "overwriting",
        "decks",
        "cad",
        "shapes",
        "recipes",
        "examples",
        "registration",
        "preferences",
        "workbench",
        "live",
        "poses",
        "studies",
        "scripting",
        "reporting",
    )
)

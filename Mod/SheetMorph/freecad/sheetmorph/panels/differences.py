# SPDX-License-Identifier: LGPL-2.1-or-later
"""The report of differences on another mesh of a part."""

import FreeCAD as App
import FreeCADGui as Gui


def tell(document, found: dict) -> None:
    """Print the sentences under `told`, and select the objects named under `different`."""
    for text in found.get("told", ()):
        App.Console.PrintWarning(f"SheetMorph: {text}\n")
    if found.get("different"):
        Gui.Selection.clearSelection()
    for name in found.get("different", ()):
        Gui.Selection.addSelection(document.getObject(name))

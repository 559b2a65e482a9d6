# SPDX-License-Identifier: LGPL-2.1-or-later
"""What came out different on another mesh of a part is told, and lit up in view and tree."""

import FreeCAD as App
import FreeCADGui as Gui


def tell(document, found: dict) -> None:
    """Prints the sentences under `told`, selects the objects named under `different`."""
    for text in found.get("told", ()):
        App.Console.PrintWarning(f"SheetMorph: {text}\n")
    if found.get("different"):
        Gui.Selection.clearSelection()
    for name in found.get("different", ()):
        Gui.Selection.addSelection(document.getObject(name))

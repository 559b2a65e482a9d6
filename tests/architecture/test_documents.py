# SPDX-License-Identifier: LGPL-2.1-or-later
"""FreeCAD 0.20 leaks every name that `App.listDocuments` returns: no code that a timer runs may
call it. `generations.document_named` finds a document without it."""

import re
from pathlib import Path

WORKBENCH = Path(__file__).parents[2] / "Mod" / "SheetMorph" / "freecad" / "sheetmorph"
RARE = {"actions.py", "finishing.py"}  # a new document; one that was opened just now


def test_documents_are_found_without_a_list_that_leaks():
    callers = {
        path.name
        for path in WORKBENCH.rglob("*.py")
        if path.parent.name != "tests" and re.search(r"\.listDocuments\(", path.read_text())
    }
    assert callers == RARE

# SPDX-License-Identifier: LGPL-2.1-or-later
"""Reading of part files, in a thread if a dialog waits; notes go to the report view."""

from __future__ import annotations

import os
from pathlib import Path

import FreeCAD

from freecad.sheetmorph import reporting
from freecad.sheetmorph.bridge import kernel


def read_file(path: str | os.PathLike, mesh: dict | None = None):
    """Return the part file (`sheetmorph.read_part`) of a path; `mesh` has mesh sizes for CAD.

    Notes on the file, such as unreadable faces or healed shapes, are printed to the report view.
    Raises ValueError or OSError if it cannot be read.
    """
    path, package = Path(path), kernel.load()
    file = reporting.waited_for(lambda told: package.read_part(path, mesh, told))
    for note in [*file.missing, *file.notes]:
        FreeCAD.Console.PrintMessage(f"SheetMorph: {path.name}: {note}\n")
    return file

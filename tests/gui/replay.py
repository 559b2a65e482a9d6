# SPDX-License-Identifier: LGPL-2.1-or-later
"""Runs a recorded macro in a FreeCAD without a window and stores the deformed positions."""

import os
import sys
import traceback

import FreeCAD as App
import numpy as np


def replay() -> None:
    """The macro makes one document with one morph; its parts are stored one after the other."""
    path = os.environ["SHEETMORPH_MACRO"]
    with open(path, encoding="utf-8") as file:
        exec(compile(file.read(), path, "exec"), {"__name__": "__main__"})  # noqa: S102
    from freecad.sheetmorph.bridge import conversion
    from freecad.sheetmorph.objects import model

    parts = [o for o in App.ActiveDocument.Objects if model.kind(o) == model.PART]
    points = [conversion.read_mesh(part.Mesh)[0] for part in parts]
    np.save(os.environ["SHEETMORPH_REPLAYED"], np.concatenate(points))
    # FreeCAD 1.1 dies at its end while a document whose mesh Python has seen is open.
    App.closeDocument(App.ActiveDocument.Name)


# FreeCAD ends with status 0 whatever a script raises.
try:
    replay()
except Exception:  # noqa: B902
    traceback.print_exc()
    sys.exit(1)

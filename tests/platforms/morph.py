# SPDX-License-Identifier: LGPL-2.1-or-later
"""Run by `freecadcmd`: moves the handle of an example and says how far each part went.

MORPH_RECIPE names the recipe, MORPH_ANSWER the file that gets the line.
"""

import os

import FreeCAD
import numpy as np
from freecad.sheetmorph import api, objects, paths

document = FreeCAD.newDocument()
assembly = api.import_recipe(document, os.environ["MORPH_RECIPE"])
document.recompute()
moved = {}
for part in objects.parts(assembly):
    rest = api.rest_mesh(part)[0]
    moved[part.Label] = float(np.linalg.norm(api.deform(assembly)[part.Name] - rest, axis=1).max())
FreeCAD.closeDocument(document.Name)
assert len(moved) == 3 and all(1.0 < way < 100.0 for way in moved.values()), moved
with open(os.environ["MORPH_ANSWER"], "w", encoding="utf-8") as file:
    words = ", ".join(f"{label} {way:.2f} mm" for label, way in moved.items())
    file.write(f"{FreeCAD.Version()[0]}.{FreeCAD.Version()[1]}: {words}, {paths.__file__}\n")

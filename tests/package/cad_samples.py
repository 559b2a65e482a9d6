# SPDX-License-Identifier: LGPL-2.1-or-later
"""CAD files for tests, made by FreeCAD in a process of its own."""

from __future__ import annotations

import os
import shutil
import subprocess
from pathlib import Path

import pytest

_HEAD = """
import os
import FreeCAD
import Import
import Part
from FreeCAD import Vector

folder = os.environ["CAD_FOLDER"]
"""
_TAIL = """
open(os.path.join(folder, "done"), "w").close()
os._exit(0)
"""
# A plate of 60 x 40 x 2 mm with holes of radius 3 mm at (15, 20) and 5 mm at (40, 20), and two
# pins of radius 3 mm, 8 mm long, the first in the smaller hole; and a turned plate of 120 x 60 x
# 3 mm with a slot of 32 x 8 mm and rectangles of 30 x 20 mm, corners of 4 mm, and of 16 x 10 mm;
# and a sheet of 2 mm, 50 mm wide, bent by 90 degrees with an inner radius of 3 mm, turned.
_SCRIPT = """
plate = Part.makeBox(60, 40, 2)
for x, radius in ((15, 3), (40, 5)):
    plate = plate.cut(Part.makeCylinder(radius, 4, Vector(x, 20, -1)))
pin = Part.makeCylinder(3, 8)
document = FreeCAD.newDocument("samples")
shown = []
for label, shape, place in (
    ("plate", plate, Vector()),
    ("pin", pin, Vector(15, 20, -3)),
    ("pin b", pin, Vector(15, 60, 0)),
):
    feature = document.addObject("Part::Feature", "Part")
    feature.Label = label
    feature.Shape = shape
    feature.Placement.Base = place
    shown.append(feature)
document.recompute()
Import.export(shown, os.path.join(folder, "fixture.step"))
plate.exportIges(os.path.join(folder, "plate.igs"))
plate.exportBrep(os.path.join(folder, "plate.brep"))
slot = Part.makeBox(24, 8, 5, Vector(20, 26, -1))
for x in (20, 44):
    slot = slot.fuse(Part.makeCylinder(4, 5, Vector(x, 30, -1)))
box = Part.makeBox(30, 20, 5, Vector(60, 20, -1))
upright = [e for e in box.Edges if abs(e.tangentAt(e.FirstParameter).z) > 0.9]
turned = Part.makeBox(120, 60, 3)
for tool in (
    slot.removeSplitter(),
    box.makeFillet(4, upright),
    Part.makeBox(10, 16, 5, Vector(100, 22, -1)),
):
    turned = turned.cut(tool)
turned.rotate(Vector(0, 0, 0), Vector(1, 2, 3), 25)
turned.exportStep(os.path.join(folder, "openings.step"))
s = 0.5 ** 0.5
ends = [Vector(0, 0, 2), Vector(30, 0, 2), Vector(33, 0, 5), Vector(33, 0, 35)]
ends += [Vector(35, 0, 35), Vector(35, 0, 5), Vector(30, 0, 0), Vector(0, 0, 0)]
sides = [Part.LineSegment(ends[k], ends[k + 1]) for k in (0, 2, 3, 4, 6)]
sides.append(Part.LineSegment(ends[7], ends[0]))
for radius, k in ((3, 1), (5, 5)):
    middle = Vector(30 + radius * s, 0, 5 - radius * s)
    sides.append(Part.Arc(ends[k], middle, ends[k + 1]))
edges = Part.__sortEdges__([side.toShape() for side in sides])
bent = Part.Face(Part.Wire(edges)).extrude(Vector(0, 50, 0))
bent.rotate(Vector(0, 0, 0), Vector(1, 2, 3), 25)
bent.exportStep(os.path.join(folder, "bend.step"))
"""


def make_cad_samples(folder: Path) -> Path:
    """fixture.step (plate, the same pin twice), plate.igs, plate.brep,
    openings.step, bend.step; skips without FreeCAD."""
    return made_by_freecad(_SCRIPT, folder)


def made_by_freecad(script: str, folder: Path) -> Path:
    """A folder with the files that a script writes into `folder`; skips without FreeCAD."""
    program = shutil.which("freecadcmd")
    if program is None:
        pytest.skip("freecadcmd, which makes the CAD files, is not installed")
    file = folder / "make_files.py"
    file.write_text(_HEAD + script + _TAIL, "utf-8")
    settings = {**os.environ, "FREECAD_USER_HOME": str(folder), "CAD_FOLDER": str(folder)}
    for name in ("PYTHONPATH", "LD_PRELOAD"):  # FreeCAD does not start with sanitizers
        settings.pop(name, None)
    command = [program, str(file)]
    subprocess.run(command, env=settings, stdin=subprocess.DEVNULL, capture_output=True)
    assert (folder / "done").is_file(), "FreeCAD did not make the CAD files"
    return folder

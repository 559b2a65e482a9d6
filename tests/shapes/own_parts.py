# SPDX-License-Identifier: LGPL-2.1-or-later
"""Parts that are hard to carry, as STEP files, made by FreeCAD in a process of its own."""

from __future__ import annotations

import os
import shutil
import subprocess
from pathlib import Path

import pytest

# A tube with a seam; a ball cut flat with a pole; a plate with a countersunk hole; a block with
# fillets; a plate with two holes.
_SCRIPT = """
import os
import FreeCAD
import Part
from FreeCAD import Vector

folder = os.environ["OWN_PARTS"]
plate = Part.makeBox(120, 60, 3)
for x in (35, 85):
    plate = plate.cut(Part.makeCylinder(5, 5, Vector(x, 30, -1)))
cone = Part.makeCone(0, 6, 6, Vector(60, 30, -3))
block = Part.makeBox(80, 40, 10)
shapes = {
    "tube": Part.makeCylinder(10, 80).cut(Part.makeCylinder(8, 80)),
    "ball": Part.makeSphere(20).cut(Part.makeBox(60, 60, 30, Vector(-30, -30, -38))),
    "countersunk": Part.makeBox(120, 60, 3).cut(cone),
    "fillets": block.makeFillet(3, block.Edges),
    "washers": plate,
}
for name, shape in shapes.items():
    shape.exportStep(os.path.join(folder, name + ".step"))
open(os.path.join(folder, "done"), "w").close()
os._exit(0)
"""


def make_own_parts(folder: Path) -> Path:
    """The parts as files in a folder; skips without FreeCAD."""
    program = shutil.which("freecadcmd")
    if program is None:
        pytest.skip("freecadcmd, which makes the CAD files, is not installed")
    script = folder / "make_parts.py"
    script.write_text(_SCRIPT, "utf-8")
    settings = {**os.environ, "FREECAD_USER_HOME": str(folder), "OWN_PARTS": str(folder)}
    settings.pop("PYTHONPATH", None)
    command = [program, str(script)]
    subprocess.run(command, env=settings, stdin=subprocess.DEVNULL, capture_output=True)
    assert (folder / "done").is_file(), "FreeCAD did not make the CAD files"
    return folder

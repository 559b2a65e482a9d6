# SPDX-License-Identifier: LGPL-2.1-or-later
"""CAD files for tests, made by FreeCAD in a process of its own."""

from __future__ import annotations

import os
import shutil
import subprocess
from pathlib import Path

import pytest

# A plate of 60 x 40 x 2 mm with holes of radius 3 mm at (15, 20) and 5 mm at (40, 20), and two
# pins of radius 3 mm, 8 mm long, the first in the smaller hole.
_SCRIPT = """
import os
import FreeCAD
import Import
import Part
from FreeCAD import Vector

folder = os.environ["CAD_SAMPLES"]
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
open(os.path.join(folder, "done"), "w").close()
os._exit(0)
"""


def make_cad_samples(folder: Path) -> Path:
    """fixture.step (plate, the same pin twice), plate.igs, plate.brep; skips without FreeCAD."""
    program = shutil.which("freecadcmd")
    if program is None:
        pytest.skip("freecadcmd, which makes the CAD files, is not installed")
    script = folder / "make_samples.py"
    script.write_text(_SCRIPT, "utf-8")
    settings = {**os.environ, "FREECAD_USER_HOME": str(folder), "CAD_SAMPLES": str(folder)}
    settings.pop("PYTHONPATH", None)
    subprocess.run(
        [program, str(script)], env=settings, stdin=subprocess.DEVNULL, capture_output=True
    )
    assert (folder / "done").is_file(), "FreeCAD did not make the CAD files"
    return folder

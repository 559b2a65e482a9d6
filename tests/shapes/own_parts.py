# SPDX-License-Identifier: LGPL-2.1-or-later
"""Parts that are hard to carry, as STEP files, made by FreeCAD in a process of its own."""

from __future__ import annotations

import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[1] / "package"))
from cad_samples import made_by_freecad  # noqa: E402

# A tube with a seam; a ball cut flat with a pole; a plate with a countersunk hole; a block with
# fillets; a plate with two holes.
_SCRIPT = """
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
"""


def make_own_parts(folder: Path) -> Path:
    """The parts as files in a folder; skips without FreeCAD."""
    return made_by_freecad(_SCRIPT, folder)

# SPDX-License-Identifier: LGPL-2.1-or-later
"""What FreeCAD makes of a written CAD file: validity, a mesh, a boolean cut, a drawing."""

from __future__ import annotations

import json
import os
import shutil
import subprocess
from pathlib import Path

# Of every solid: whether it is valid and closed, whether its mesh is watertight and free of self
# intersections, whether a box over one half of it cuts off a valid rest of less volume; and the
# radii of its round holes with those of the circles in drawings along their axes.
_SCRIPT = """
import json
import os
import Mesh
import Part
import TechDraw
from FreeCAD import Vector

with open(os.environ["SHEETMORPH_ASKED"], encoding="utf-8") as file:
    asked = json.load(file)


def rest_of(solid):
    box = solid.BoundBox
    half = Part.makeBox(0.5 * box.XLength + 1, box.YLength + 2, box.ZLength + 2)
    half.translate(Vector(box.XMin - 1, box.YMin - 1, box.ZMin - 1))
    return solid.cut(half)


def holes_in(solid):
    walls = [f for f in solid.Faces if isinstance(f.Surface, Part.Cylinder)]
    return [f.Surface for f in walls if any(edge.isClosed() for edge in f.Edges)]


def drawn(solid, wall):
    groups = TechDraw.projectEx(solid, wall.Axis)
    curves = [edge.Curve for group in groups for edge in group.Edges]
    return sorted({round(one.Radius, 9) for one in curves if isinstance(one, Part.Circle)})


told = []
for solid in Part.read(asked["file"]).Solids:
    mesh = Mesh.Mesh(solid.tessellate(asked["deflection"]))
    rest = rest_of(solid)
    holes = holes_in(solid)[: asked["drawings"]]
    told.append(
        {
            "is_valid": solid.isValid() and solid.isClosed(),
            "is_watertight": mesh.isSolid(),
            "has_intersections": mesh.hasSelfIntersections(),
            "is_cut": rest.isValid() and 0.0 < rest.Volume < solid.Volume,
            "holes": [[wall.Radius, drawn(solid, wall)] for wall in holes],
        }
    )
with open(asked["out"], "w", encoding="utf-8") as file:
    json.dump(told, file)
os._exit(0)
"""


def read_in_freecad(path: Path, deflection: float, drawings: int) -> list[dict]:
    """One dict a solid of a CAD file; at most so many of its holes are drawn."""
    folder = path.parent / f"{path.stem} in FreeCAD"
    folder.mkdir()
    script, asked, out = (folder / name for name in ("read.py", "asked.json", "told.json"))
    script.write_text(_SCRIPT, "utf-8")
    wanted = {"file": str(path), "out": str(out), "deflection": deflection, "drawings": drawings}
    asked.write_text(json.dumps(wanted), "utf-8")
    settings = {**os.environ, "FREECAD_USER_HOME": str(folder), "SHEETMORPH_ASKED": str(asked)}
    settings.pop("PYTHONPATH", None)
    program = shutil.which("freecadcmd")
    assert program is not None, "freecadcmd is not installed"
    done = subprocess.run(
        [program, str(script)], env=settings, stdin=subprocess.DEVNULL, capture_output=True
    )
    assert out.is_file(), done.stderr.decode(errors="replace")[-2000:]
    return json.loads(out.read_text("utf-8"))

# SPDX-License-Identifier: LGPL-2.1-or-later
"""What FreeCAD makes of a written CAD file: validity, a mesh, a boolean cut, a drawing."""

from __future__ import annotations

import json
import os
import shutil
import subprocess
from pathlib import Path
from typing import NamedTuple

DEFLECTION = 0.1  # mm, with 30 degrees what FreeCAD's *Create mesh from shape* offers
UNCERTAINTY = 0.0005  # mm, the edge tolerance, which a written STEP file states

# Of every solid: whether it is valid and closed, whether its mesh is watertight, how many of its
# triangles cross and how deep; what volume a box over one half of it cuts off, and what the mesh
# says it should; the radii of its round holes with those of circles in drawings along their axes.
_SCRIPT = """
import json
import math
import os
import MeshPart
import Part
import TechDraw
import numpy as np
from FreeCAD import Vector

with open(os.environ["SHEETMORPH_ASKED"], encoding="utf-8") as file:
    asked = json.load(file)


def mesh_of(shape):
    return MeshPart.meshFromShape(
        Shape=shape, LinearDeflection=asked["deflection"], AngularDeflection=math.radians(30)
    )


def corners_of(mesh):
    points, facets = mesh.Topology
    return np.array([(p.x, p.y, p.z) for p in points])[np.array(facets)]


def depth_of(one, other):
    normal = np.cross(other[1] - other[0], other[2] - other[0])
    length = np.linalg.norm(normal)
    if length == 0.0:
        return 0.0
    heights = (one - other[0]) @ (normal / length)
    return max(0.0, min(heights.max(), -heights.min()))


def crossings_of(mesh):
    if not mesh.hasSelfIntersections():
        return 0, 0.0
    pairs = {tuple(sorted(pair[:2])) for pair in mesh.getSelfIntersections()}
    at = corners_of(mesh)
    depths = [min(depth_of(at[a], at[b]), depth_of(at[b], at[a])) for a, b in pairs]
    return len(pairs), max(depths)


def volume_beyond(mesh, x):
    # The sum over its triangles of the integral of max(height above the plane, 0) times the
    # normal's x: the field vanishes on the plane, so no lid is needed.
    at = corners_of(mesh)
    areas = 0.5 * np.cross(at[:, 1] - at[:, 0], at[:, 2] - at[:, 0])[:, 0]
    heights = np.sort(at[:, :, 0] - x, axis=1)
    low, middle, high = heights.T
    means = np.where(low >= 0.0, heights.mean(axis=1), 0.0)
    one = (high > 0.0) & (middle <= 0.0)
    means[one] = high[one] ** 3 / (3.0 * ((high - low) * (high - middle))[one])
    two = (middle > 0.0) & (low < 0.0)
    below = -low[two] ** 3 / (3.0 * ((high - low) * (middle - low))[two])
    means[two] = heights[two].mean(axis=1) + below
    return float(areas @ means)


def cut(solid, mesh):
    box = solid.BoundBox
    middle = box.XMin + asked["cut_at"] * box.XLength
    half = Part.makeBox(middle - box.XMin + 1, box.YLength + 2, box.ZLength + 2)
    half.translate(Vector(box.XMin - 1, box.YMin - 1, box.ZMin - 1))
    rest = solid.cut(half, asked["uncertainty"])
    rest_mesh = mesh_of(rest)
    volumes = (rest_mesh.Volume, volume_beyond(mesh, middle), mesh.Volume)
    return rest.isValid() and rest.isClosed(), volumes


def holes_in(solid):
    walls = [f for f in solid.Faces if isinstance(f.Surface, Part.Cylinder)]
    return [f.Surface for f in walls if any(edge.isClosed() for edge in f.Edges)]


def drawn(solid, wall):
    groups = TechDraw.projectEx(solid, wall.Axis)
    curves = [edge.Curve for group in groups for edge in group.Edges]
    return sorted({round(one.Radius, 9) for one in curves if isinstance(one, Part.Circle)})


told = []
for solid in Part.read(asked["file"]).Solids:
    mesh = mesh_of(solid)
    crossings, depth = crossings_of(mesh)
    is_cut, volumes = cut(solid, mesh)
    holes = holes_in(solid)[: asked["drawings"]]
    told.append(
        {
            "is_valid": solid.isValid() and solid.isClosed(),
            "is_watertight": mesh.isSolid(),
            "crossings": crossings,
            "depth": depth,
            "is_cut": is_cut,
            "cut_volumes": volumes,
            "holes": [[wall.Radius, drawn(solid, wall)] for wall in holes],
        }
    )
with open(asked["out"], "w", encoding="utf-8") as file:
    json.dump(told, file)
os._exit(0)
"""


class Cut(NamedTuple):
    """How a solid is cut. at: of its extent in x; uncertainty: mm, 0 for a plain cut."""

    at: float = 0.5
    uncertainty: float = UNCERTAINTY


def read_in_freecad(path: Path, folder: Path, drawings: int, cut: Cut = Cut()) -> list[dict]:
    """One dict a solid of a CAD file; at most so many of its holes are drawn.

    folder: where FreeCAD may write.
    """
    folder.mkdir()
    script, asked, out = (folder / name for name in ("read.py", "asked.json", "told.json"))
    script.write_text(_SCRIPT, "utf-8")
    wanted = {"file": str(path), "out": str(out), "drawings": drawings}
    wanted |= {"deflection": DEFLECTION, "cut_at": cut.at, "uncertainty": cut.uncertainty}
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

# SPDX-License-Identifier: LGPL-2.1-or-later
"""The blank of a part as sketches."""

from __future__ import annotations

import FreeCAD
import numpy as np

from freecad.sheetmorph.api.checks import number, require_kind
from freecad.sheetmorph.bridge import kernel, solving
from freecad.sheetmorph.bridge.rest import read_rest
from freecad.sheetmorph.objects import assembly_of, model

# Between the assembly and its blanks, a share of their size.
_GAP = 0.1


def flatten(part, thickness: float | None = None, limit: float = 1.0) -> list:
    """Lay the deformed part flat: return a sketch a piece, its outline, holes and bend lines.

    Bend lines are construction lines. thickness: mm, of an open sheet, for the allowances of bends;
    the part's own if left out. limit: percent that 99 % of the area may be stretched by. It is
    kinematic, no forming simulation. Raises ValueError, RuntimeError for what cannot be laid flat.
    """
    require_kind(part, model.PART, "part")
    rest = read_rest(part)
    positions = solving.deform(assembly_of(part))[part.Name]
    package = kernel.load()
    told = part.SheetThickness.Value if thickness is None else number(thickness, "thickness")
    patterns = kernel.flat().patterns_of(
        package.PartMesh(positions, rest.triangles, name=part.Label),
        thickness=told or None,
        limit=number(limit, "limit") / 100.0,
    )
    for line in [line for pattern in patterns for line in kernel.flat().table_of(pattern)]:
        FreeCAD.Console.PrintMessage(f"SheetMorph: {line}\n")
    place, made = _beside(part), []
    for pattern in patterns:
        low, high = pattern.flat[:, :2].min(axis=0), pattern.flat[:, :2].max(axis=0)
        made.append(_sketch(part, pattern))
        made[-1].Placement.Base = place - FreeCAD.Vector(*low, 0.0)
        place.x += _GAP * float(np.linalg.norm(high - low)) + float(high[0] - low[0])
    return made


def _beside(part) -> FreeCAD.Vector:
    """Where the first blank has its lower left corner: right of all parts, none hides it."""
    boxes = [entry.Mesh.BoundBox for entry in model.parts(assembly_of(part))]
    whole = FreeCAD.BoundBox()
    for box in boxes:
        whole.add(box)
    return FreeCAD.Vector(whole.XMax + _GAP * whole.DiagonalLength, whole.YMin, 0.0)


def _sketch(part, pattern):
    import Part

    sketch = part.Document.addObject("Sketcher::SketchObject", "Blank")
    sketch.Label = f"{pattern.name} blank"
    lines = _polygon(pattern.flat[pattern.corners(pattern.outline)])
    for rim, circle in zip(pattern.holes, pattern.circles):
        if circle is None:
            lines += _polygon(pattern.flat[pattern.corners(rim)])
        else:
            upwards = FreeCAD.Vector(0, 0, 1)
            lines.append(Part.Circle(FreeCAD.Vector(*circle[0]), upwards, circle[1]))
    sketch.addGeometry(lines, False)
    bends = [Part.LineSegment(*(FreeCAD.Vector(*end) for end in line)) for line in pattern.lines]
    if bends:
        sketch.addGeometry(bends, True)
    return sketch


def _polygon(places: np.ndarray) -> list:
    import Part

    ends = [FreeCAD.Vector(*place) for place in places.tolist()]
    return [Part.LineSegment(a, b) for a, b in zip(ends, [*ends[1:], ends[0]])]

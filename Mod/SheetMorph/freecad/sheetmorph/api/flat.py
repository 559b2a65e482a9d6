# SPDX-License-Identifier: LGPL-2.1-or-later
"""The blank of a part as sketches."""

from __future__ import annotations

import FreeCAD
import numpy as np

from freecad.sheetmorph.api.checks import number, require_kind
from freecad.sheetmorph.bridge import kernel, solving
from freecad.sheetmorph.bridge.rest import read_rest
from freecad.sheetmorph.objects import assembly_of, model
from freecad.sheetmorph.objects.properties import number_of

# Distance between the assembly and its blanks, as a share of their size.
_GAP = 0.1


def flatten(
    part, thickness: float | None = None, limit: float = 1.0, at_rest: bool = False
) -> list:
    """Flatten the deformed part and return one sketch per piece, with its outline and holes.

    Bend lines are in a separate dashed sketch. The pattern is kinematic, without a forming
    simulation.

    Parameters
    ----------
    part : object
        The part.
    thickness : float, optional
        Thickness of an open sheet for the bend allowances, mm; by default that of the part.
    limit : float
        Largest stretch of 99 % of the area, percent.
    at_rest : bool
        Also return the blank of the part at rest, if the part has moved.

    Raises
    ------
    ValueError, RuntimeError
        If the part cannot be flattened.
    """
    require_kind(part, model.PART, "part")
    rest = read_rest(part)
    positions = solving.deform(assembly_of(part))[part.Name]
    own = number_of(part, "SheetThickness")
    chosen = own if thickness is None else number(thickness, "thickness")
    shapes = [(part.Label, positions)]
    if at_rest and not np.array_equal(positions, rest.points):
        shapes.append((f"{part.Label} at rest", rest.points))
    place, made = _beside(part), []
    for label, shape in shapes:
        for pattern in kernel.flat().patterns_of(
            kernel.load().PartMesh(shape, rest.triangles, name=label),
            thickness=chosen or None,
            limit=number(limit, "limit") / 100.0,
        ):
            for line in kernel.flat().table_of(pattern):
                FreeCAD.Console.PrintMessage(f"SheetMorph: {line}\n")
            low, high = pattern.flat[:, :2].min(axis=0), pattern.flat[:, :2].max(axis=0)
            made.append(_sketch(part, pattern, place - FreeCAD.Vector(*low, 0.0)))
            place.x += _GAP * float(np.linalg.norm(high - low)) + float(high[0] - low[0])
    return made


def _beside(part) -> FreeCAD.Vector:
    """Return the lower left corner of the first blank, to the right of all parts."""
    boxes = [entry.Mesh.BoundBox for entry in model.parts(assembly_of(part))]
    whole = FreeCAD.BoundBox()
    for box in boxes:
        whole.add(box)
    return FreeCAD.Vector(whole.XMax + _GAP * whole.DiagonalLength, whole.YMin, 0.0)


def _sketch(part, pattern, place):
    import Part

    lines = _polygon(pattern.flat[pattern.corners(pattern.outline)])
    for rim, circle in zip(pattern.holes, pattern.circles):
        if circle is None:
            lines += _polygon(pattern.flat[pattern.corners(rim)])
        else:
            upwards = FreeCAD.Vector(0, 0, 1)
            lines.append(Part.Circle(FreeCAD.Vector(*circle[0]), upwards, circle[1]))
    sketch = _drawn(part, f"{pattern.name} blank", lines, place)
    bends = [Part.LineSegment(*(FreeCAD.Vector(*end) for end in line)) for line in pattern.lines]
    if bends:
        bent = _drawn(part, f"{pattern.name} bend lines", bends, place)
        if FreeCAD.GuiUp:
            bent.ViewObject.DrawStyle = "Dashed"
    return sketch


def _drawn(part, label: str, lines: list, place):
    sketch = part.Document.addObject("Sketcher::SketchObject", "Blank")
    sketch.Label = label
    sketch.addGeometry(lines, False)
    sketch.Placement.Base = place
    return sketch


def _polygon(places: np.ndarray) -> list:
    import Part

    ends = [FreeCAD.Vector(*place) for place in places.tolist()]
    return [Part.LineSegment(a, b) for a, b in zip(ends, [*ends[1:], ends[0]])]

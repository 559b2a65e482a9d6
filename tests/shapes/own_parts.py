# SPDX-License-Identifier: LGPL-2.1-or-later
"""Parts that are hard to carry, as STEP files, made by FreeCAD in a process of its own."""

from __future__ import annotations

import re
import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[1] / "package"))
from cad_samples import made_by_freecad  # noqa: E402

# A tube with a seam; a ball cut flat with a pole; a plate with a countersunk hole; a block with
# fillets; a plate with two holes; a threaded rod; a plate with a threaded stud,
# and one with a threaded hole; the countersunk plate in inches; a frame of two instances of
# one bracket.
_SCRIPT = """
from FreeCAD import Placement, Rotation


def thread(inner, outer, pitch, start, height):
    corners = [(inner, -0.44), (outer, -0.06), (outer, 0.06), (inner, 0.44), (inner, -0.44)]
    profile = Part.makePolygon([Vector(x, 0, start + pitch * z) for x, z in corners])
    helix = Part.makeHelix(pitch, height, outer)
    helix.translate(Vector(0, 0, start))
    return Part.Wire(helix.Edges).makePipeShell([profile], True, True)


def threaded(plate, hole, tap):
    # Cut in a ring first: a cut in the plate at once leaves planes in pieces.
    ring = Part.makeCylinder(hole, plate.BoundBox.ZLength)
    return plate.cut(ring).fuse(ring.cut(tap)).removeSplitter()


tap = Part.makeCylinder(3.42, 16, Vector(0, 0, -5)).fuse(thread(3.3, 4.2, 1.25, -2.63, 11.13))
stud = Part.makeCylinder(2.5, 11).fuse(thread(2.35, 3, 1, 1, 8))
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
    "rod": Part.makeCylinder(4, 14).fuse(thread(3.8, 5, 2, 2, 10)).removeSplitter(),
    "stud": Part.makeBox(120, 60, 3, Vector(-60, -30, -3)).fuse(stud).removeSplitter(),
    "threaded": threaded(Part.makeBox(120, 60, 6, Vector(-60, -30, 0)), 5.2, tap),
}
for name, shape in shapes.items():
    assert shape.isValid(), name
    shape.exportStep(os.path.join(folder, name + ".step"))
document = FreeCAD.newDocument("instances")
bracket = document.addObject("Part::Feature", "bracket")
bracket.Shape = plate
frame = document.addObject("App::Part", "frame")
turned = Placement(Vector(0, 80, 10), Rotation(Vector(1, 0, 0), 90))
for label, place in (("left", Placement()), ("right", turned)):
    link = document.addObject("App::Link", "Link")
    link.setLink(bracket)
    link.Label, link.LinkPlacement = label, place
    frame.addObject(link)
document.recompute()
Import.export([frame], os.path.join(folder, "frame.step"))
Part.setStaticValue("write.step.unit", "INCH")
shapes["countersunk"].exportStep(os.path.join(folder, "inches.step"))
"""
# What colours a face in a STEP file, and the ids that it refers to.
_COLOUR = """\
#{0}=COLOUR_RGB('',{red},{green},{blue});
#{1}=FILL_AREA_STYLE_COLOUR('',#{0});
#{2}=FILL_AREA_STYLE('',(#{1}));
#{3}=SURFACE_STYLE_FILL_AREA(#{2});
#{4}=SURFACE_SIDE_STYLE('',(#{3}));
#{5}=SURFACE_STYLE_USAGE(.BOTH.,#{4});
#{6}=PRESENTATION_STYLE_ASSIGNMENT((#{5}));
#{7}=STYLED_ITEM('color',(#{6}),#{face});
#{8}=MECHANICAL_DESIGN_GEOMETRIC_PRESENTATION_REPRESENTATION('',(#{7}),#{context});
"""


def with_a_named_and_coloured_face(path: Path, number: int, name: str, colour: tuple) -> None:
    """Names and colours (r, g, b of 0..1) one face, counted from 0, of a STEP file."""
    text = path.read_text("utf-8")
    faces = list(re.finditer(r"#(\d+) = ADVANCED_FACE\(''", text))
    context = re.findall(r"#(\d+) = \( GEOMETRIC_REPRESENTATION_CONTEXT\(3\)", text)[0]
    face = faces[number]
    first = max(int(one) for one in re.findall(r"#(\d+) =", text)) + 1
    told = dict(zip(("red", "green", "blue"), colour), face=face[1], context=context)
    styled = _COLOUR.format(*range(first, first + 9), **told)
    text = text[: face.end() - 1] + f"{name}'" + text[face.end() :]
    end = text.rindex("ENDSEC;")
    path.write_text(text[:end] + styled + text[end:], "utf-8")


def make_own_parts(folder: Path) -> Path:
    """The parts as files in a folder; skips without FreeCAD."""
    made_by_freecad(_SCRIPT, folder)
    with_a_named_and_coloured_face(folder / "washers.step", 0, "left end", (1.0, 0.5, 0.0))
    return folder

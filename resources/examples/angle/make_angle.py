# SPDX-License-Identifier: LGPL-2.1-or-later
"""Make angle.step, a bent plate with four holes: freecadcmd resources/examples/angle/make_angle.py

The plate is 2 mm thick. One flange is 120 x 60 mm, the other 120 x 40 mm.
"""

from pathlib import Path

import FreeCAD
import Part

RADIUS, THICKNESS = 4.0, 2.0  # mm, of the bend inside and of the plate
HERE = Path(__file__).resolve().parent if "__file__" in globals() else Path.cwd()


def angle() -> Part.Shape:
    """Return the bent plate as a solid."""
    vector = FreeCAD.Vector
    outer = RADIUS + THICKNESS
    flat = Part.makeBox(60 - outer, 120, THICKNESS, vector(outer, 0, 0))
    upright = Part.makeBox(THICKNESS, 120, 40 - outer, vector(0, 0, outer))
    bend = Part.makeCylinder(outer, 120, vector(outer, 0, outer), vector(0, 1, 0), 360)
    bend = bend.cut(Part.makeCylinder(RADIUS, 120, vector(outer, 0, outer), vector(0, 1, 0)))
    bend = bend.common(Part.makeBox(outer, 120, outer))
    shape = flat.fuse([bend, upright]).removeSplitter()
    for place, along in (
        (vector(35, 25, -5), vector(0, 0, 1)),
        (vector(35, 95, -5), vector(0, 0, 1)),
        (vector(-5, 25, 25), vector(1, 0, 0)),
        (vector(-5, 95, 25), vector(1, 0, 0)),
    ):
        shape = shape.cut(Part.makeCylinder(5, 20, place, along))
    return shape


angle().exportStep(str(HERE / "angle.step"))

# SPDX-License-Identifier: LGPL-2.1-or-later
"""What differs between FreeCAD 0.20, 1.0 and 1.1, in one place; of Qt, `qt.py` knows it.

Asked for by what is there, never by the number of a version: a FreeCAD that somebody built answers
for itself.
"""

from pivy import coin

DRAGGERS = ("SoFCCSysDragger", "SoTransformDragger")
"""FreeCAD's dragger of six arrows and arcs, until 1.0 and since 1.1; the fields are the same."""


def dragger_type() -> coin.SoType:
    """The type of FreeCAD's own dragger."""
    for name in DRAGGERS:
        found = coin.SoType.fromName(name)
        if not found.isBad():
            return found
    raise RuntimeError("this FreeCAD has no dragger that SheetMorph knows: " + ", ".join(DRAGGERS))

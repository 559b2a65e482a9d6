# SPDX-License-Identifier: LGPL-2.1-or-later
"""A laser-cut box, a STEP file of ten solids: finger-jointed plates 3 mm thick and four gussets."""

from __future__ import annotations

from pathlib import Path

import numpy as np
from selection import read_meshes, region

FILE = "06-laser-cut-box/box_sides.step"
FRONT = "box_sides/side_short_B"
LONG = tuple(f"box_sides/{n}" for n in ("box_base", "box_top", "side_long", "side_long 2"))
EDGE = 4.0  # mm


def box(data: Path) -> dict:
    """The whole box: its back end stays, its front plate turns by 12 degrees about its length."""
    entries = [{"file": str(data / FILE), "split": True, "thin": "auto", "remesh": {"edge": EDGE}}]
    meshes = read_meshes(entries, data)
    back = meshes["box_sides/side_short"].points[:, 0].max()
    ends = [region(meshes, p, meshes[p].points[:, 0] <= back, name=f"end of {p}") for p in LONG]
    whole = np.ones(len(meshes[FRONT].points), dtype=bool)
    turn = {"axis": [1, 0, 0], "degrees": 12.0}
    return {
        "sheetmorph": 1,
        "parts": entries,
        "primary": FRONT,
        "fixed": ends,
        "handles": [region(meshes, FRONT, whole, name="front")],
        "features": "auto",
        "contacts": {"auto": {"type": "tied"}},
        "pose": {"front": {"rotation": turn}},
    }

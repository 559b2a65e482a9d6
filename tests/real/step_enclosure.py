# SPDX-License-Identifier: LGPL-2.1-or-later
"""A laser's enclosure, one STEP file of 38 solids: bent sheets 1 mm thick, bolted and riveted."""

from __future__ import annotations

from pathlib import Path

from selection import read_meshes, region
from sheetmorph.finding import FindOptions, FindPart, find

FILE = "03-laser4diy-enclosure/Enclosure_v3_v9.step"
STEM = "Enclosure_v3_v9/"
MAIN = f"{STEM}MainEnclosure.MainSheet"
PANELS = (MAIN, f"{STEM}MainEnclosure.CompartmentLeftSheet", f"{STEM}Enclosure v3 v9.BracketLeft")
BOLTED = (
    *(f"{STEM}MainEnclosure.{name}" for name in ("BigShim", "labyrinth")),
    *(f"{STEM}Enclosure v3 v9.{name}" for name in ("Shim1", "Shim3")),
    *(f"{STEM}CornerBracket{name}" for name in ("", " 4", "(Mirror)", "(Mirror) 4")),
)
EDGE = 10.0  # mm
GAP = 0.3  # mm; between sheets that are bolted together


def enclosure(data: Path) -> dict:
    """Three panels and what is bolted to them: the right side stays, the left end turns 6 degrees.

    The lid, the laser's chamber and what else hangs on the right side stay where they are.
    """
    meshing = {"edge": 1.5 * EDGE, "deflection": 0.3, "angle": 45}
    entries = [
        {
            "file": str(data / FILE),
            "split": True,
            "thin": "auto",
            "mesh": meshing,
            "remesh": {"edge": EDGE},
        }
    ]
    meshes = read_meshes(entries, data)
    parts = [FindPart(name, mesh) for name, mesh in meshes.items()]
    found = find(parts, FindOptions(gap=GAP, kinds=("round hole", "slotted hole")))
    joined = {*PANELS, *BOLTED}
    contacts = [
        {**entry, "type": "rigid" if entry["kind"] == "bolt" else "tied"}
        for entry in found.contacts
        if {entry["a"]["part"], entry["b"]["part"]} <= joined
    ]
    x = meshes[MAIN].points[:, 0]
    turn = {"axis": [1, 0, 0], "degrees": 6.0}
    return {
        "sheetmorph": 1,
        "parts": entries,
        "primary": MAIN,
        "fixed": [region(meshes, MAIN, x > 270.0, name="right side")],
        "handles": [region(meshes, MAIN, x < 10.0, name="left end")],
        "features": found.features,
        "contacts": contacts,
        "pose": {"left end": {"rotation": turn}},
    }

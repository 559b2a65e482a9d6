# SPDX-License-Identifier: LGPL-2.1-or-later
"""How wide a twisted strip is in its middle; prints a table of resources/docs/accuracy.md.

    PYTHONPATH=build/Mod/SheetMorph /usr/bin/python3 tests/benchmarks/far_turns.py
"""

from __future__ import annotations

import numpy as np

import sheetmorph

TURNS = (30, 60, 90, 120, 180, 270, 400)  # degrees
LENGTH, WIDTH, ALONG, ACROSS = 100.0, 25.0, 40, 10  # mm and numbers of elements


def strip() -> sheetmorph.PartMesh:
    """Return a flat strip of right triangles."""
    sides = np.linspace(0, LENGTH, ALONG + 1), np.linspace(0, WIDTH, ACROSS + 1)
    x, y = np.meshgrid(*sides, indexing="ij")
    points = np.stack([x.ravel(), y.ravel(), np.zeros(x.size)], axis=1)
    row = ACROSS + 1
    corner = np.array([row * i + j for i in range(ALONG) for j in range(ACROSS)])[:, None]
    triangles = np.concatenate([corner + [0, row, row + 1], corner + [0, row + 1, 1]])
    return sheetmorph.PartMesh(points, triangles, name="strip")


def widths(energy: str) -> list[float]:
    """Return the distance of the sides in the middle, mm, for each turn of one end."""
    mesh = strip()
    x = mesh.points[:, 0]
    ends = [np.flatnonzero(x == place).tolist() for place in (0.0, LENGTH)]
    recipe = {
        "sheetmorph": 1,
        "energy": energy,
        "parts": [{"name": "strip"}],
        "fixed": [{"part": "strip", "vertices": ends[0]}],
        "handles": [{"name": "tip", "part": "strip", "vertices": ends[1]}],
    }
    session = sheetmorph.Session(recipe, {"strip": mesh})
    middle = np.flatnonzero(np.isclose(x, 0.5 * LENGTH))
    found = []
    for degrees in TURNS:
        pose = {"tip": {"rotation": {"axis": [1, 0, 0], "degrees": degrees}}}
        across = session.deform(pose).positions["strip"][middle[[0, -1]]]
        found.append(float(np.linalg.norm(across[1] - across[0])))
    return found


if __name__ == "__main__":
    print("| turn | " + " | ".join(f"{degrees}°" for degrees in TURNS) + " |")
    print("|---" * (len(TURNS) + 1) + "|")
    for name in ("neumann", "natural"):
        print(f"| `{name}` | " + " | ".join(f"{width:.1f}" for width in widths(name)) + " |")

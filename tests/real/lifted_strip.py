# SPDX-License-Identifier: LGPL-2.1-or-later
"""A strip with three holes, one end lifted: what free features gain: lifted_strip.py

Prints the bending (rad^2) and the height of the long edge (mm) with rotation `interpolated`, as in
the paper, and `free`. take_pictures.py takes the picture of both.
"""

from __future__ import annotations

import sys
from pathlib import Path

import numpy as np

sys.path.insert(0, str(Path(__file__).resolve().parents[1] / "package"))

from plates import Plate, plate, write_plate  # noqa: E402

LIFT = 60.0  # mm, of a strip of 300 by 100 mm


def lifted_strip() -> tuple[Plate, dict]:
    """The strip and its recipe, which names no rotation; holes of 40 mm."""
    strip = plate(holes=3, cells=10, scale=5.0, start=0.0)
    holes = [
        {"name": f"hole{k}", "part": "strip", "vertices": rim} for k, rim in enumerate(strip.rims)
    ]
    return strip, {
        "sheetmorph": 1,
        "parts": [{"name": "strip", "file": "strip.obj"}],
        "fixed": [{"name": "root", "part": "strip", "vertices": strip.left}],
        "handles": [{"name": "tip", "part": "strip", "vertices": strip.right}],
        "features": holes,
        "pose": {"tip": {"translation": [0.0, 0.0, LIFT]}},
    }


def written_strip(folder: Path) -> dict:
    """Writes the mesh into a folder; returns the recipe, with the path of the mesh."""
    strip, recipe = lifted_strip()
    recipe["parts"][0]["file"] = str(write_plate(strip, folder / "strip.obj", "obj"))
    return recipe


def main() -> None:
    """A line of figures a rotation."""
    import sheetmorph
    from against_cgal import bending

    strip, recipe = lifted_strip()
    start, length = strip.points[:, 0].min(), np.ptp(strip.points[:, 0])
    edge = np.flatnonzero(strip.points[:, 1] < strip.points[:, 1].min() + 1e-9)
    edge = edge[np.argsort(strip.points[edge, 0])]
    shares = (strip.points[edge, 0] - start) / length
    for rotation in ("interpolated", "free"):
        for feature in recipe["features"]:
            feature["rotation"] = rotation
        mesh = sheetmorph.PartMesh(strip.points, strip.triangles, name="strip")
        shape = sheetmorph.Session(recipe, {"strip": mesh}).deform().positions["strip"]
        heights = np.interp((0.125, 0.25, 0.375, 0.5), shares, shape[edge, 2])
        bent = bending(shape, strip.points, strip.triangles)
        print(f"{rotation}: bending {bent:.3g}; edge", *(f"{height:.1f}" for height in heights))


if __name__ == "__main__":
    main()

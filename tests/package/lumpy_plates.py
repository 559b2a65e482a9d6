# SPDX-License-Identifier: LGPL-2.1-or-later
"""A plate that is not thin everywhere: a boss, a rib and a welded nut stand on it."""

from __future__ import annotations

from pathlib import Path

import numpy as np

from plates import Plate, write_plate
from sheet_meshes import circle, flat, inside, polygon, rounded

THICKNESS = 2.0
LUMPS = {
    "boss": (circle((60, 30), 10, 24), 12.0),
    "rib": (rounded((60, 100), (5, 60), 2, 2.5), 10.0),
    "nut": (polygon([(34, 60), (27, 72), (13, 72), (6, 60), (13, 48), (27, 48)], 3.0), 8.0),
}
HOLES = [circle((20, 60), 4, 24), circle((30, 110), 8, 32), circle((90, 60), 8, 32)]


def lumpy_plate() -> tuple[np.ndarray, np.ndarray]:
    """Points (n, 3), mm, and triangles of a plate of 120 by 160 by 2 mm with holes, one through the
    nut."""
    outline = polygon([(0, 0), (120, 0), (120, 160), (0, 160)], 4.0)
    places, triangles = flat(outline, HOLES, 4.0, [loop for loop, _ in LUMPS.values()])
    centres = places[triangles].mean(axis=1)
    rise = np.zeros(len(triangles))
    for loop, height in LUMPS.values():
        rise[inside(loop, centres)] = height
    return raised(places, triangles, rise)


def raised(places: np.ndarray, triangles: np.ndarray, rise: np.ndarray) -> tuple:
    """(n, 3) points and (m, 3) triangles of a plate, every triangle of its top raised so much."""
    number: dict[tuple[int, float], int] = {}

    def at(vertex: int, height: float) -> int:
        return number.setdefault((vertex, height), len(number))

    faces, sides = [], {}
    for corners, height in zip(triangles.tolist(), (THICKNESS + rise).tolist()):
        faces.append([at(v, height) for v in corners])
        faces.append([at(v, 0.0) for v in reversed(corners)])
        sides |= {(a, b): height for a, b in zip(corners, corners[1:] + corners[:1])}
    for (a, b), high in sides.items():
        low = sides.get((b, a), 0.0)
        if high > low:
            faces.append([at(b, high), at(a, high), at(a, low)])
            faces.append([at(b, high), at(a, low), at(b, low)])
    points = np.array([[*places[vertex], height] for vertex, height in number])
    return points, np.array(faces, dtype=np.int32)


def written_plate(folder: Path) -> dict:
    """Writes it into a folder; a recipe that bends and twists it, no feature marked."""
    from bending import bent_and_twisted

    points, triangles = lumpy_plate()
    plate = Plate(points, triangles, *(np.flatnonzero(end).tolist() for end in ends(points)))
    return {
        "sheetmorph": 1,
        "parts": [
            {
                "name": "plate",
                "file": str(write_plate(plate, folder / "plate.obj", "obj")),
                "thin": "auto",
            }
        ],
        "fixed": [{"part": "plate", "vertices": plate.left}],
        "handles": [{"name": "end", "part": "plate", "vertices": plate.right}],
        "pose": {"end": bent_and_twisted(144.0, 40.0, 20.0)},
    }


def ends(points: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Masks (n,) of the twentieth of the length that is held, and of that which is moved."""
    return points[:, 1] < 8.0, points[:, 1] > 152.0

# SPDX-License-Identifier: LGPL-2.1-or-later
"""Measures a real part: the main sheet of set 03, from STEP, a thin solid with 190 free holes.

    PYTHONPATH=build/Mod/SheetMorph /usr/bin/python3 tests/benchmarks/real_part.py

The data are not part of the repository; without them nothing is measured.
"""

from __future__ import annotations

import os
import statistics
from dataclasses import dataclass
from pathlib import Path

import numpy as np

from assemblies import seconds
from tables import markdown

SHARED = Path(os.environ.get("SHEETMORPH_SHARED", Path(__file__).resolve().parents[3] / "shared"))
FILE = SHARED / "data" / "03-laser4diy-enclosure" / "Enclosure_v3_v9.step"
SIZES = {"edge": 13.0, "deflection": 0.2, "angle": 15}
ENDS = 0.03  # of the length: the strips that are held and dragged
FRAMES = 30


@dataclass
class RealPart:
    """What one part took, seconds."""

    vertices: int
    holes: int
    set_up: float
    first_frame: float
    learning: float
    frame: float
    exact: float


def main_sheet() -> tuple[np.ndarray, np.ndarray, list[list[int]]]:
    """Points, triangles and the holes' vertices of the largest sheet in the file."""
    from sheetmorph import read_part
    from sheetmorph.files.cad_file import exact_features

    parts = read_part(FILE, SIZES).model.parts
    part = next(part for part in parts if part.name.endswith("MainSheet"))
    holes = [f["vertices"] for f in exact_features(part) if f["kind"] == "round hole"]
    return np.asarray(part.points), np.asarray(part.triangles), holes


def recipe(points: np.ndarray, holes: list[list[int]]) -> dict:
    """One end held, the other dragged, every hole free to turn."""
    along = (points[:, 0] - points[:, 0].min()) / np.ptp(points[:, 0])
    is_free = np.ones(len(points), dtype=bool)
    is_free[[vertex for hole in holes for vertex in hole]] = False

    def region(name: str, is_inside: np.ndarray) -> dict:
        vertices = np.flatnonzero(is_inside & is_free).tolist()
        return {"part": "sheet", "name": name, "vertices": vertices}

    return {
        "sheetmorph": 1,
        "parts": [{"name": "sheet", "file": "sheet.obj", "thin": "auto"}],
        "primary": "sheet",
        "propagation": {"type": "single"},
        "fixed": [region("end", along < ENDS)],
        "handles": [region("pull", along > 1.0 - ENDS)],
        "features": [
            {"part": "sheet", "name": f"hole {k}", "vertices": hole, "rotation": "free"}
            for k, hole in enumerate(holes)
        ],
    }


def pose(step: int) -> dict:
    """One of ten, up to 15 mm and 6 degrees."""
    turn = {"axis": [0, 1, 0], "degrees": 0.6 * step}
    return {"pull": {"translation": [0, 0, 1.5 * step], "rotation": turn}}


def timed() -> RealPart | None:
    """The part pre-processed and dragged; nothing where the file is not at hand."""
    if not FILE.is_file():
        return None
    from sheetmorph import PartMesh, Session

    points, triangles, holes = main_sheet()
    made: list[Session] = []
    set_up = seconds(
        lambda: made.append(Session(recipe(points, holes), {"sheet": PartMesh(points, triangles)}))
    )
    session = made[0]
    exact = statistics.median(seconds(lambda: session.deform(pose(3))) for _ in range(5))
    drags: list = []
    first = seconds(
        lambda: drags.append(session.begin_drag(["pull"], pose(1))) or drags[0].deform(pose(1))
    )
    learning = seconds(drags[0].wait)
    steps = [1 + k % 10 for k in range(FRAMES)]
    frame = statistics.median(seconds(lambda k=k: drags[0].deform(pose(k))) for k in steps)
    return RealPart(len(points), len(holes), set_up, first, learning, frame, exact)


def table(part: RealPart | None) -> str:
    """One row of Markdown, or nothing."""
    if part is None:
        return ""
    head = [
        "real part",
        "vertices",
        "free holes",
        "set-up",
        "first frame",
        "response fields in the background",
    ]
    times = (part.set_up, part.first_frame, part.learning, part.frame, part.exact)
    cells = ["main sheet of set 03, thin solid", f"{part.vertices:,}", str(part.holes)]
    cells += [f"{1e3 * t:.3g} ms" for t in times]
    return markdown(head + ["frame of a drag", "exact frame"], [cells])


if __name__ == "__main__":
    print(table(timed()) or f"{FILE} is not at hand")

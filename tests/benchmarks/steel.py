# SPDX-License-Identifier: LGPL-2.1-or-later
"""Times of the steel answer beside the linear one: a strip rolled up by 180 degrees.

PYTHONPATH=build/Mod/SheetMorph python3 tests/benchmarks/steel.py [VERTICES ...]
"""

from __future__ import annotations

import math
import sys
import time

import numpy as np

import sheetmorph

LENGTH = 100.0


def strip(vertices: int) -> tuple[np.ndarray, np.ndarray, list[int], list[int]]:
    """A flat strip four times as long as wide: points, triangles, ids of both ends."""
    across = max(2, round(math.sqrt(vertices) / 2.0))
    along = 4 * across
    x, y = np.meshgrid(
        np.linspace(0, LENGTH, along + 1), np.linspace(0, LENGTH / 4.0, across + 1), indexing="ij"
    )
    points = np.column_stack([x.ravel(), y.ravel(), np.zeros(x.size)])
    a = (np.arange(along)[:, None] * (across + 1) + np.arange(across)).ravel()
    b, c, d = a + across + 1, a + across + 2, a + 1
    triangles = np.vstack([np.column_stack([a, b, c]), np.column_stack([a, c, d])])
    last = along * (across + 1)
    ends = list(range(across + 1)), list(range(last, last + across + 1))
    return points, triangles.astype(np.int32), *ends


def main() -> None:
    print("| vertices | energy | set-up | exact answer | processor | off the circle |")
    print("| --- | --- | --- | --- | --- | --- |")
    radius = LENGTH / math.pi
    pose = {
        "translation": [-LENGTH, 0, 2.0 * radius],
        "rotation": {"axis": [0, -1, 0], "degrees": 180},
    }
    for wanted in map(int, sys.argv[1:] or ("5000", "20000", "100000")):
        points, triangles, low, high = strip(wanted)
        angle = points[:, 0] / radius
        circle = np.column_stack(
            [radius * np.sin(angle), points[:, 1], radius * (1.0 - np.cos(angle))]
        )
        for energy in ("neumann", "steel"):
            recipe = {
                "sheetmorph": 1,
                "parts": [{"name": "strip", "file": "strip.obj", "thickness": 1.0}],
                "energy": energy,
                "fixed": [{"part": "strip", "vertices": low}],
                "handles": [{"part": "strip", "name": "tip", "vertices": high}],
            }
            times = [(time.perf_counter(), time.process_time())]
            mesh = sheetmorph.PartMesh(points, triangles)
            session = sheetmorph.Session(recipe, {"strip": mesh})
            times.append((time.perf_counter(), time.process_time()))
            shape = session.deform({"tip": pose}).positions["strip"]
            times.append((time.perf_counter(), time.process_time()))
            off = np.linalg.norm(shape - circle, axis=1).max() / LENGTH
            (a, _), (b, used), (c, more) = times
            print(
                f"| {len(points):,} | {energy} | {b - a:.2f} s | {c - b:.2f} s | "
                f"{more - used:.2f} s | {100 * off:.2f} % |",
                flush=True,
            )


if __name__ == "__main__":
    main()

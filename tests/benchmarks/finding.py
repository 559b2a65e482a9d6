# SPDX-License-Identifier: LGPL-2.1-or-later
"""Measures how long features and contacts take to find: the frame, and 500,000 facets.

    PYTHONPATH=build/Mod/SheetMorph /usr/bin/python3 tests/benchmarks/finding.py

Prints a table of resources/docs/benchmarks.md. Times are medians of 5; run it when nothing else
does.
"""

from __future__ import annotations

import statistics

import numpy as np

from assemblies import load, row, seconds
from sheetmorph import PartMesh
from sheetmorph.finding import FindPart, find

RUNS = 5
PIECES = 7  # of every edge; rows and columns of frames


def divided(mesh: PartMesh, pieces: int) -> PartMesh:
    """The mesh with every edge in so many pieces."""
    steps = [(i, j) for i in range(pieces + 1) for j in range(pieces + 1 - i)]
    number = {step: k for k, step in enumerate(steps)}
    shares = np.array([(pieces - i - j, i, j) for i, j in steps]) / pieces
    points = np.einsum("sk,tkd->tsd", shares, np.asarray(mesh.points)[mesh.triangles])
    cells = [((i, j), (i + 1, j), (i, j + 1)) for i, j in steps if i + j < pieces]
    cells += [((i + 1, j), (i + 1, j + 1), (i, j + 1)) for i, j in steps if i + j < pieces - 1]
    local = np.array([[number[corner] for corner in cell] for cell in cells])
    first = len(steps) * np.arange(len(points))
    triangles = (local[None] + first[:, None, None]).reshape(-1, 3)
    flat = points.reshape(-1, 3)
    _, kept, place = np.unique(np.round(flat, 6), axis=0, return_index=True, return_inverse=True)
    return PartMesh(flat[kept], place.ravel()[triangles])


def assemblies() -> dict[str, list[FindPart]]:
    """The frame as it is, finely meshed, and many of it."""
    _, meshes = load("welded_frame")
    spread = np.ptp(np.vstack([mesh.points for mesh in meshes.values()]), axis=0)
    places = [(i, j) for i in range(PIECES) for j in range(PIECES)]
    return {
        "welded frame": [FindPart(name, mesh) for name, mesh in meshes.items()],
        "the same, every triangle in 49": [
            FindPart(name, divided(mesh, PIECES)) for name, mesh in meshes.items()
        ],
        "49 of it side by side": [
            FindPart(f"{name} {i} {j}", PartMesh(mesh.points + shift, mesh.triangles))
            for i, j in places
            for shift in [1.2 * spread * [i, j, 0]]
            for name, mesh in meshes.items()
        ],
    }


def timed(name: str, parts: list[FindPart]) -> str:
    """A row of the table."""
    found = find(parts)
    facets = sum(len(part.mesh.triangles) for part in parts)
    took = statistics.median(seconds(lambda: find(parts)) for _ in range(RUNS))
    counts = [len(parts), facets, len(found.features), len(found.contacts)]
    return row([name, *(f"{count:,}" for count in counts), f"{took:.2f} s"])


def main() -> None:
    """Prints the table."""
    print(row(["assembly", "parts", "facets", "features", "contacts", "features and contacts"]))
    print(row(["---"] * 6))
    for name, parts in assemblies().items():
        print(timed(name, parts), flush=True)


if __name__ == "__main__":
    main()

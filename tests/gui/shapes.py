# SPDX-License-Identifier: LGPL-2.1-or-later
"""A small sheet for the tests: 120 x 60 mm, two round holes, a flange up at both ends."""

import numpy as np

HOLES = ((40.0, 30.0, 10.0), (80.0, 30.0, 12.0))  # x, y, radius
LENGTH, WIDTH, FLANGE, STEP = 120.0, 60.0, 20.0, 2.5


def sheet() -> tuple[np.ndarray, np.ndarray]:
    """Points (n, 3) mm and triangles (m, 3)."""
    along = np.arange(-FLANGE, LENGTH + FLANGE + STEP / 2, STEP)
    across = np.arange(0.0, WIDTH + STEP / 2, STEP)
    x, y = (grid.ravel() for grid in np.meshgrid(along, across, indexing="ij"))
    points = np.stack([x, y, np.zeros_like(x)], axis=1)
    triangles = grid_triangles(len(along), len(across))
    for hole in HOLES:
        triangles = cut(points, triangles, hole)
    used = np.unique(triangles)
    number = np.full(len(points), -1)
    number[used] = np.arange(len(used))
    return folded(points[used]), number[triangles].astype(np.int32)


def grid_triangles(rows: int, columns: int) -> np.ndarray:
    """Two triangles a cell."""
    first = (np.arange(rows - 1)[:, None] * columns + np.arange(columns - 1)).ravel()
    a, b, c, d = first, first + columns, first + columns + 1, first + 1
    return np.concatenate([np.stack([a, b, c], 1), np.stack([a, c, d], 1)])


def cut(points: np.ndarray, triangles: np.ndarray, hole) -> np.ndarray:
    """Takes the triangles in a hole away and moves what is at its rim onto the circle."""
    centre, radius = np.array(hole[:2]), hole[2]
    distance = np.linalg.norm(points[:, :2] - centre, axis=1)
    kept = triangles[(distance[triangles] >= radius - STEP / 2).all(axis=1)]
    removed = np.setdiff1d(triangles, kept)
    rim = np.intersect1d(triangles[np.isin(triangles, removed).any(axis=1)], kept)
    points[rim, :2] = centre + (points[rim, :2] - centre) / distance[rim, None] * radius
    return kept


def folded(points: np.ndarray) -> np.ndarray:
    """Folds both ends up."""
    result = points.copy()
    for beyond, edge in ((-points[:, 0], 0.0), (points[:, 0] - LENGTH, LENGTH)):
        end = beyond > 0.0
        result[end, 2] = beyond[end]
        result[end, 0] = edge
    return result


def strip(y: float, length: float) -> tuple[np.ndarray, np.ndarray]:
    """A flat strip 1 mm above the sheet, between its holes, ``length`` along y."""
    x, y = np.arange(52.0, 67.0, 2.0), y + np.arange(0.0, length + STEP / 2, STEP)
    grid = np.meshgrid(x, y, indexing="ij")
    points = np.stack([grid[0].ravel(), grid[1].ravel(), np.ones(grid[0].size)], axis=1)
    return points, grid_triangles(len(x), len(y)).astype(np.int32)


def write_ply(path: str, shape=None) -> None:
    """Writes a shape, else the sheet, as a text PLY."""
    points, triangles = shape or sheet()
    lines = ["ply", "format ascii 1.0", f"element vertex {len(points)}"]
    lines += [f"property float {c}" for c in "xyz"]
    lines += [f"element face {len(triangles)}", "property list uchar int vertex_indices"]
    lines += ["end_header"]
    lines += [" ".join(map(repr, row)) for row in points.tolist()]
    lines += ["3 " + " ".join(map(str, row)) for row in triangles.tolist()]
    with open(path, "w", encoding="ascii") as file:
        file.write("\n".join(lines) + "\n")

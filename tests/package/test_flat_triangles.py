# SPDX-License-Identifier: LGPL-2.1-or-later
"""No preparation leaves a triangle without area, and none tears a mesh apart for that."""

from __future__ import annotations

import numpy as np
import pytest

from plates import plate
from sheetmorph import PartMesh, _core
from sheetmorph.files.prepared_mesh import Wanted, prepared_mesh

SEEDS = range(12)
FLAT = 1e-5
WAYS = (
    Wanted(weld=0.0),
    Wanted(weld=1e-6),
    Wanted(weld=1e-3),
    Wanted(edge=2.0),
    Wanted(weld=1e-4, edge=3.0),
    Wanted(weld=1e-4, edge=3.0, rims="circle"),
)


def heights(points: np.ndarray, triangles: np.ndarray) -> np.ndarray:
    """The least height of triangles over their longest side."""
    corners = points[triangles]
    sides = np.linalg.norm(corners - np.roll(corners, 1, axis=1), axis=2)
    doubled = np.linalg.norm(
        np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0]), axis=1
    )
    return doubled / np.maximum(sides.max(axis=1), 1e-300) ** 2


def pressed(draw, points: np.ndarray, triangles: np.ndarray, kept) -> np.ndarray:
    """The mesh with a corner of some triangles on the opposite side, nearly or exactly."""
    points, used = points.copy(), np.zeros(len(points), bool)
    used[kept] = True
    for triangle in draw.permutation(triangles)[:30]:
        if used[triangle].any():
            continue
        used[triangle] = True
        a, b, c = triangle
        along = draw.choice([0.0, 1e-9, draw.uniform(0.2, 0.8)])
        place = (1.0 - along) * points[a] + along * points[b]
        height = 0.0 if draw.random() < 0.5 else 10.0 ** draw.uniform(-16.0, -1.0)
        points[c] = place + height * (points[c] - place)
    return points


def spoiled(seed: int) -> tuple[np.ndarray, np.ndarray]:
    """A plate with flat triangles, some T-junctions, in single precision or cut apart."""
    draw, part = np.random.default_rng(seed), plate()
    points = pressed(draw, part.points, part.triangles, [*part.left, *part.right, *part.rims[0]])
    triangles = part.triangles
    if seed % 2:
        some = triangles[draw.integers(0, len(triangles), 10)]
        middles = 0.5 * (points[some[:, 0]] + points[some[:, 1]])
        new = len(points) + np.arange(len(some))
        triangles = np.vstack([triangles, np.column_stack([some[:, 0], new, some[:, 1]])])
        points = np.vstack([points, middles])
    if seed % 3 == 0:
        points = points.astype(np.float32).astype(float)
    if seed % 4 == 3:
        points, triangles = points[triangles].reshape(-1, 3), np.arange(triangles.size)
    return points, draw.permutation(triangles.reshape(-1, 3)).astype(np.int32)


@pytest.mark.parametrize("seed", SEEDS)
def test_no_triangle_without_area_stays(seed: int):
    points, triangles = spoiled(seed)
    assert (heights(points, triangles) <= FLAT).any()
    for wanted in WAYS:
        made, _ = prepared_mesh(_core, PartMesh(points, triangles), wanted)
        assert heights(made.points, made.triangles).min() > FLAT, wanted
        area = 0.5 * np.linalg.norm(cross(points, triangles), axis=1).sum()
        kept = 0.5 * np.linalg.norm(cross(made.points, made.triangles), axis=1).sum()
        assert kept == pytest.approx(area, rel=0.02), wanted


def cross(points: np.ndarray, triangles: np.ndarray) -> np.ndarray:
    first, second, third = (points[corner] for corner in triangles.T)
    return np.cross(second - first, third - first)


def box(cells: int) -> tuple[np.ndarray, np.ndarray]:
    """A closed box of squares cut into triangles, its vertices merged."""
    found, corners = [], []
    grid = np.arange(cells)
    for axis in range(3):
        for side in (0.0, float(cells)):
            for i in grid:
                for j in grid:
                    square = [(i, j), (i + 1, j), (i + 1, j + 1), (i, j + 1)]
                    places = [np.insert(np.array(uv, float), axis, side) for uv in square]
                    order = (0, 1, 2, 0, 2, 3) if side else (0, 2, 1, 0, 3, 2)
                    found += [places[k] for k in order]
    points, corners = np.unique(np.array(found), axis=0, return_inverse=True)
    return points, corners.reshape(-1, 3).astype(np.int32)


@pytest.mark.parametrize("seed", SEEDS)
def test_a_closed_mesh_stays_closed(seed: int):
    points, triangles = box(8)
    on_edges = np.flatnonzero(((points == 0.0) | (points == 8.0)).sum(axis=1) > 1)
    points = pressed(np.random.default_rng(seed), points, triangles, on_edges)
    made, _ = prepared_mesh(_core, PartMesh(points, triangles), Wanted(weld=0.0))
    sides = np.sort(np.vstack([made.triangles[:, [k, (k + 1) % 3]] for k in range(3)]), axis=1)
    _, counts = np.unique(sides, axis=0, return_counts=True)
    assert (counts == 2).all() and heights(made.points, made.triangles).min() > FLAT

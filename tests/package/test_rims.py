# SPDX-License-Identifier: LGPL-2.1-or-later
"""What a rim is: `find` and a size agree on it, and the border around a sheet is no hole."""

from __future__ import annotations

import numpy as np
import pytest

from sheet_meshes import circle, divided, flat, lifted, polygon, rounded
from sheetmorph import PartMesh
from sheetmorph.finding import find
from sheetmorph.finding.findings import FindPart
from sheetmorph.finding.options import HOLES
from sheetmorph.base.kernel import load_kernel

SHAPES = {"round hole": "hole", "slotted hole": "slot"}


def features_of(points: np.ndarray, triangles: np.ndarray) -> list[dict]:
    """The holes that are found on a mesh."""
    mesh = PartMesh(points, triangles.astype(np.int32), name="sheet")
    found = find([FindPart("sheet", mesh)], with_contacts=False).features
    return [entry for entry in found if entry["kind"] in HOLES]


def as_written(rng, points: np.ndarray) -> np.ndarray:
    """Coordinates as a file keeps them: in double or single precision, or in five digits."""
    how = rng.integers(3)
    if how == 0:
        return points
    if how == 1:
        return points.astype(np.float32).astype(float)
    return np.array([float(f"{x:.5g}") for x in points.ravel()]).reshape(points.shape)


def random_rim(rng) -> np.ndarray:
    """A closed rim around (60, 45): a circle of 5 to 60 corners, a slot or an ellipse."""
    size, count = rng.uniform(4.0, 15.0), int(rng.integers(5, 61))
    angles = 2.0 * np.pi * (np.arange(count) + rng.uniform()) / count
    form = rng.choice(["circle", "between arc and chord", "ellipse", "slot"])
    if form == "slot":
        length = size * rng.uniform(2.0, 4.0)
        return rounded((60, 45), (length, 2 * size), size, rng.uniform(0.1, 0.9) * size)
    radius = np.full(count, size)
    if form == "between arc and chord":
        radius *= rng.uniform(np.cos(np.pi / count), 1.0, count)
    stretch = rng.uniform(1.0, 1.5) if form == "ellipse" else 1.0
    return np.column_stack([stretch * np.cos(angles), np.sin(angles)]) * radius[:, None] + (60, 45)


@pytest.mark.parametrize("seed", range(60))
def test_find_and_size_agree_on_a_rim_and_the_size_is_the_one_requested(seed: int):
    rng, core = np.random.default_rng(seed), load_kernel()
    rim = random_rim(rng)
    step = max(6.0, float(np.linalg.norm(rim - np.roll(rim, 1, axis=0), axis=1).max()))
    outline = polygon([(-30, -30), (150, -30), (150, 120), (-30, 120)], step)
    plane, triangles = flat(outline, [rim], step)
    points = as_written(rng, lifted(plane, 20.0))
    (entry,) = features_of(points, triangles)
    ids = np.array(entry["vertices"])
    assert len(ids) == len(rim)
    shape = core.feature_shape(points, triangles, ids)
    assert (shape.kind if shape else None) == SHAPES.get(entry["kind"])
    if shape is None:
        return
    measured = 2.0 * entry["radius"] if shape.kind == "hole" else entry["length"]
    assert shape.size == pytest.approx(measured, rel=1e-6, abs=4.0 * entry["residual"])
    wanted = max(1.15 * shape.size, 1.01 * shape.smallest)
    moved = points.copy()
    moved[ids] = shape.resized(points[ids], wanted)
    again = core.feature_shape(moved, triangles, ids)
    assert again.kind == shape.kind
    assert again.size == pytest.approx(wanted, rel=1e-6)


@pytest.mark.parametrize(
    ("count", "between"), [(6, 0), (7, 0), (8, 0), (12, 0), (8, 1), (8, 3), (9, 2), (12, 1)]
)
def test_a_coarse_round_hole_is_round_however_often_its_sides_are_cut(count: int, between: int):
    rng = np.random.default_rng(count)
    uneven = rng.uniform(np.cos(np.pi / count), 1.0, (count, 1))
    if between:
        uneven = 1.0
    corners = (60, 45) + uneven * circle((0, 0), 4.0, count)
    shares = np.arange(between + 1)[:, None] / (between + 1)
    following = np.roll(corners, -1, axis=0)
    rim = np.concatenate([a + shares * (b - a) for a, b in zip(corners, following)])
    plane, triangles = flat(polygon([(0, 0), (120, 0), (120, 90), (0, 90)], 9.0), [rim], 6.0)
    points = lifted(plane)
    (entry,) = features_of(points, triangles)
    shape = load_kernel().feature_shape(points, triangles, np.array(entry["vertices"]))
    assert (entry["kind"], shape.kind) == ("round hole", "hole")
    rows = np.array(entry["vertices"])
    grown = shape.resized(points[rows], 9.2)
    away = np.linalg.norm(grown - shape.centre, axis=1)
    np.testing.assert_allclose(away, 4.6, atol=1e-9)


def dished(plane: np.ndarray, rng) -> np.ndarray:
    """A flat sheet around the origin bent into a dish: floor, wall, and perhaps a lip inwards."""
    runs = [rng.uniform(30.0, 40.0), rng.uniform(10.0, 20.0), rng.uniform(6.0, 12.0)]
    turns = [0.0, rng.uniform(0.3, 1.5), rng.uniform(0.0, 3.1)]
    away = np.linalg.norm(plane, axis=1)
    direction = plane / np.maximum(away, 1e-12)[:, None]
    radius, height, begin = np.zeros(len(plane)), np.zeros(len(plane)), 0.0
    for run, turn in zip(runs, turns):
        part = np.clip(away - begin, 0.0, run if turn is not turns[-1] else np.inf)
        radius, height = radius + part * np.cos(turn), height + part * np.sin(turn)
        begin += run
    return np.column_stack([direction * radius[:, None], height])


def rolled(plane: np.ndarray, rng) -> np.ndarray:
    """A flat sheet rolled about y, by three quarters of a turn at most."""
    radius = np.ptp(plane[:, 0]) / rng.uniform(0.5, 4.7)
    angle = plane[:, 0] / radius
    return np.column_stack([radius * np.sin(angle), plane[:, 1], radius * (1 - np.cos(angle))])


def random_outline(rng) -> np.ndarray:
    """The outer border of a sheet around the origin: a disc, a rectangle, an L, a star, a slot."""
    form = rng.integers(5)
    if form == 0:
        return circle((0, 0), 55.0, 60)
    if form == 1:
        return polygon([(-60, -50), (60, -50), (60, 50), (-60, 50)], 5.0)
    if form == 2:
        return polygon([(-60, -50), (60, -50), (60, 0), (30, 0), (30, 50), (-60, 50)], 5.0)
    if form == 3:
        angles = np.pi * np.arange(16) / 8
        radii = np.where(np.arange(16) % 2, 55.0, 45.0)
        return divided(np.column_stack([np.cos(angles), np.sin(angles)]) * radii[:, None], 5.0)
    return rounded((0, 0), (130, 90), 45.0, 5.0)


@pytest.mark.parametrize("seed", range(40))
def test_an_outer_border_is_no_hole_and_every_inner_loop_is_one(seed: int):
    rng = np.random.default_rng(seed)
    outline = random_outline(rng)
    places = rng.permutation([(-20.0, -15.0), (-20.0, 15.0), (5.0, -15.0), (5.0, 15.0)])
    loops = []
    for x, y in places[: rng.integers(0, 5)]:
        form = rng.integers(3)
        if form == 0:
            loops.append(circle((x, y), rng.uniform(3.0, 8.0), int(rng.integers(8, 30))))
        elif form == 1:
            loops.append(rounded((x, y), (14, 8), 4.0, 1.5))
        else:
            loops.append(polygon([(x - 6, y - 5), (x + 6, y - 5), (x, y + 7)], 2.0))
    plane, triangles = flat(outline, loops, 4.0)
    bend = (dished, rolled, lambda points, _: lifted(points))[seed % 3]
    found = features_of(bend(plane, rng), triangles)
    first = len(outline)
    inner = []
    for loop in loops:
        inner.append(set(range(first, first + len(loop))))
        first += len(loop)
    assert not any(set(range(len(outline))) & set(entry["vertices"]) for entry in found)
    assert all(any(loop <= set(entry["vertices"]) for entry in found) for loop in inner)

# SPDX-License-Identifier: LGPL-2.1-or-later
"""Contacts of few vertices, in line or nearly on one another, as touching pieces of a file have."""
from typing import Any

import numpy as np
import pytest

import sheetmorph

SIDE = 9


def sheet(generator: np.random.Generator, height: float) -> np.ndarray:
    x, y = np.meshgrid(np.linspace(0.0, 80.0, SIDE), np.linspace(0.0, 80.0, SIDE), indexing="ij")
    points = np.stack([x.ravel(), y.ravel(), np.full(x.size, height)], axis=1)
    return points + generator.normal(scale=0.4, size=points.shape)


def triangles() -> np.ndarray:
    cells = np.array([SIDE * i + j for i in range(SIDE - 1) for j in range(SIDE - 1)])
    return np.concatenate([cells[:, None] + [0, SIDE, SIDE + 1], cells[:, None] + [0, SIDE + 1, 1]])


def drawn_pair(seed: int) -> tuple[dict[str, Any], dict[str, sheetmorph.PartMesh]]:
    """Two sheets that touch in a region of any extent, from 10 mm down to a billionth of it."""
    generator = np.random.default_rng(seed)
    count = int(generator.integers(1, 5))
    sides = [40 + generator.choice([0, 1, 9, 10, -9, -1], count, replace=False) for _ in "ab"]
    extent = 10.0 ** generator.uniform(-9.0, 1.0)
    is_in_line = generator.random() < 0.5
    points = [sheet(generator, 0.0), sheet(generator, 5.0)]
    centre = points[0][40]
    for part, side in zip(points, sides):
        arms = generator.normal(size=(count, 3)) * extent
        if is_in_line:
            arms[:, 1:] = 0.0
        part[side] = centre + arms
    recipe = {
        "sheetmorph": 1,
        "parts": [{"name": "p"}, {"name": "q"}],
        "primary": "p",
        "contacts": [
            {
                "name": "touch",
                "a": {"part": "p", "vertices": sides[0].tolist()},
                "b": {"part": "q", "vertices": sides[1].tolist()},
            }
        ],
        "fixed": [{"part": "p", "vertices": list(range(SIDE))}],
        "handles": [
            {"name": "h", "part": "p", "vertices": list(range(SIDE**2 - SIDE, SIDE**2))}
        ],
        "pose": {"h": {"translation": [0, 0, 15], "rotation": {"axis": [0, 1, 0], "degrees": 20}}},
    }
    meshes = {n: sheetmorph.PartMesh(p, triangles()) for n, p in zip("pq", points)}
    return recipe, meshes


@pytest.mark.parametrize("propagation", ["local", "whole"])
def test_contacts_of_any_extent_are_solved(propagation: str) -> None:
    for seed in range(40):
        recipe, meshes = drawn_pair(seed)
        session = sheetmorph.Session({**recipe, "propagation": {"type": propagation}}, meshes)
        positions = session.deform().positions
        assert all(np.isfinite(part).all() for part in positions.values()), seed
        # The second part goes along where it touches, and does not leap.
        a, b = recipe["contacts"][0]["a"]["vertices"], recipe["contacts"][0]["b"]["vertices"]
        lift = positions["p"][a].mean(axis=0) - meshes["p"].points[a].mean(axis=0)
        moved = positions["q"][b].mean(axis=0) - meshes["q"].points[b].mean(axis=0)
        assert np.linalg.norm(moved - lift) < 6.0, seed
        assert np.abs(positions["q"] - meshes["q"].points).max() < 200.0, seed


def test_a_contact_that_determines_nothing_is_named() -> None:
    recipe, meshes = drawn_pair(1)
    recipe["propagation"] = {"type": "local", "smoothness": 1e-12}
    with pytest.raises((sheetmorph.RecipeError, sheetmorph.KernelError)) as refused:
        sheetmorph.Session(recipe, meshes)
    message = str(refused.value)
    assert "touch" in message and "p" in message and "q" in message
    assert "smoothness" in message and "positive definite" not in message

# SPDX-License-Identifier: LGPL-2.1-or-later
"""How the elements of a sheet are oriented changes no answer: a deck need not be rebuilt for it."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from sheetmorph import PartMesh, Session


def plate(height: float) -> PartMesh:
    """A bent plate of 60 x 20 mm in squares of 5 mm."""
    grid = [(x, y) for x in np.arange(0.0, 61.0, 5.0) for y in np.arange(0.0, 21.0, 5.0)]
    points = np.array([(x, y, height + 0.002 * (x - 30.0) ** 2) for x, y in grid])
    corners = [5 * i + j for i in range(12) for j in range(4)]
    squares = np.array([(k, k + 5, k + 6, k + 1) for k in corners])
    return PartMesh(points, np.concatenate([squares[:, :3], squares[:, [0, 2, 3]]]))


@pytest.mark.parametrize("keys", [{}, {"energy": "steel"}, {"refine": True}])
@pytest.mark.parametrize("contacts", ["tied", "control mesh", "rigid"])
def test_flipped_triangles_change_no_answer(keys: dict, contacts: str):
    meshes = {"low": plate(0.0), "high": plate(1.5)}
    noise = np.random.default_rng(7)
    flipped = {}
    for name, mesh in meshes.items():
        triangles = mesh.triangles.copy()
        rows = noise.random(len(triangles)) < 0.5
        triangles[rows] = triangles[rows][:, [0, 2, 1]]
        flipped[name] = replace(mesh, triangles=triangles)
    row = [2 + 5 * k for k in range(3, 6)]
    recipe = {
        "sheetmorph": 1,
        "parts": [{"name": name} for name in meshes],
        "primary": "low",
        "fixed": [{"part": "low", "vertices": list(range(5))}],
        "handles": [{"name": "end", "part": "low", "vertices": list(range(60, 65))}],
        "contacts": [
            {
                "type": contacts,
                "a": {"part": "low", "vertices": row},
                "b": {"part": "high", "vertices": row},
            }
        ],
        "pose": {"end": {"translation": [0, 0, 6]}},
        **keys,
    }
    one, other = (Session(recipe, parts).deform().positions for parts in (meshes, flipped))
    for name in meshes:
        assert np.abs(one[name] - meshes[name].points).max() > 1.0
        assert np.abs(one[name] - other[name]).max() < 1e-9

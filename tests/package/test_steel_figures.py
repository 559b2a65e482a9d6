# SPDX-License-Identifier: LGPL-2.1-or-later
"""How much the steel sheet stretches, and the plates that somebody else has rolled up."""

from __future__ import annotations

import os
import sys
from pathlib import Path

import numpy as np
import pytest

import sheetmorph
from sheetmorph.checking import prepare, with_ids

from strips import LENGTH, flat_strip

sys.path.insert(0, str(Path(__file__).parents[1] / "real"))
SHARED = Path(os.environ.get("SHEETMORPH_SHARED", Path(__file__).parents[2].parent / "shared"))
DATA = SHARED / "data"
ROLLS = DATA / "08-isometric-roll-reference"
ALONG, ACROSS = 80, 20


def edge_strains(rest: np.ndarray, now: np.ndarray, triangles: np.ndarray) -> np.ndarray:
    """Of every edge once, in percent."""
    sides = np.sort(np.vstack([triangles[:, [k, (k + 1) % 3]] for k in range(3)]), axis=1)
    a, b = np.unique(sides, axis=0).T
    lengths = np.linalg.norm(now[a] - now[b], axis=1) / np.linalg.norm(rest[a] - rest[b], axis=1)
    return 100.0 * np.abs(lengths - 1.0)


def rolled(degrees: float) -> dict:
    angle = np.radians(degrees)
    radius = LENGTH / angle
    return {
        "translation": [radius * np.sin(angle) - LENGTH, 0, radius * (1 - np.cos(angle))],
        "rotation": {"axis": [0, -1, 0], "degrees": degrees},
    }


# Root mean square and largest, with what a half more in the last digit would be.
@pytest.mark.parametrize(
    "pose, mean, largest",
    [
        ({"translation": [0, 0, 30]}, 2.95, 6.05),
        ({"rotation": {"axis": [1, 0, 0], "degrees": 180}}, 2.35, 7.55),
        (rolled(90), 0.045, 0.155),
        (rolled(180), 0.065, 0.285),
    ],
    ids=["lift 30", "twist 180", "bend 90", "bend 180"],
)
def test_strips_stretch_no_more_than_their_pose_demands(pose: dict, mean: float, largest: float):
    points, triangles = flat_strip(ALONG, ACROSS)
    recipe = {
        "sheetmorph": 1,
        "parts": [{"name": "strip", "file": "strip.obj", "thickness": 1.0}],
        "energy": "steel",
        "fixed": [{"part": "strip", "vertices": np.flatnonzero(points[:, 0] == 0).tolist()}],
        "handles": [
            {
                "part": "strip",
                "name": "tip",
                "vertices": np.flatnonzero(points[:, 0] == LENGTH).tolist(),
            }
        ],
    }
    session = sheetmorph.Session(recipe, {"strip": sheetmorph.PartMesh(points, triangles)})
    result = session.deform({"tip": pose})
    assert not result.unsettled
    strain = edge_strains(points, result.positions["strip"], triangles)
    assert np.sqrt((strain**2).mean()) < mean
    assert strain.max() < largest


@pytest.mark.skipif(not DATA.is_dir(), reason="the deck of the support is not here")
def test_a_bracket_of_a_real_support_stretches_by_less_than_half_a_percent():
    support = pytest.importorskip("riveted_support")
    parts = prepare({**support.bracket_alone(DATA), "energy": "steel"}, DATA)
    recipe = with_ids(parts)
    for entry in recipe["parts"]:
        entry["thickness"] = 2.0
    result = sheetmorph.Session(recipe, parts.meshes).deform()
    assert not result.unsettled
    mesh = parts.meshes[support.BRACKET]
    strain = edge_strains(
        np.asarray(mesh.points), result.positions[support.BRACKET], np.asarray(mesh.triangles)
    )
    assert np.sqrt((strain**2).mean()) < 0.45
    assert strain.max() < 4.75


@pytest.mark.skipif(not ROLLS.is_dir(), reason="the rolled reference plates are not here")
@pytest.mark.parametrize("poisson", [0.0, 0.3])
@pytest.mark.parametrize("name, along", [("A", 0), ("B", 1)])
def test_a_plate_rolls_up_as_its_reference(name: str, along: int, poisson: float):
    """Held in its middle, both ends turned by 180 degrees until they meet; 1 mm long."""
    plate = sheetmorph.read_part(ROLLS / "plate4SD.ply").mesh
    wanted = np.asarray(sheetmorph.read_part(ROLLS / f"plate4SD_rolled{name}.ply").mesh.points)
    rest = np.asarray(plate.points)
    ids = {x: np.flatnonzero(np.abs(rest[:, along] - x) < 1e-9).tolist() for x in (0.0, 0.5, 1.0)}
    pose = {
        end: {
            "translation": (wanted[ids[x][0]] - rest[ids[x][0]]).tolist(),
            "rotation": {"axis": [[0, -1, 0], [1, 0, 0]][along], "degrees": degrees},
        }
        for end, x, degrees in (("low", 0.0, -180), ("high", 1.0, 180))
    }
    recipe = {
        "sheetmorph": 1,
        "parts": [{"name": "p", "file": "p.ply", "thickness": 0.01, "poisson": poisson}],
        "energy": "steel",
        "fixed": [{"part": "p", "vertices": ids[0.5]}],
        "handles": [
            {"part": "p", "name": "low", "vertices": ids[0.0]},
            {"part": "p", "name": "high", "vertices": ids[1.0]},
        ],
    }
    result = sheetmorph.Session(recipe, {"p": plate}).deform(pose)
    assert not result.unsettled
    assert np.linalg.norm(result.positions["p"] - wanted, axis=1).max() < 1e-3

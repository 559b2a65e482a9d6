# SPDX-License-Identifier: LGPL-2.1-or-later
"""Handles that turn by more than half a turn, and by more than a whole one."""
from typing import Any

import numpy as np
import pytest

import sheetmorph

ENERGIES = ["neumann", "natural", "paper", "steel"]
ALONG, ACROSS, LENGTH, WIDTH = 61, 5, 300.0, 10.0


def strip(along: int = ALONG) -> sheetmorph.PartMesh:
    x, y = np.meshgrid(
        np.linspace(0.0, LENGTH, along), np.linspace(-WIDTH / 2, WIDTH / 2, ACROSS), indexing="ij"
    )
    corners = np.array([ACROSS * i + j for i in range(along - 1) for j in range(ACROSS - 1)])
    triangles = np.concatenate(
        [corners[:, None] + [0, ACROSS, ACROSS + 1], corners[:, None] + [0, ACROSS + 1, 1]]
    )
    points = np.stack([x.ravel(), y.ravel(), np.zeros(x.size)], axis=1)
    return sheetmorph.PartMesh(points, triangles)


def recipe(energy: str, degrees: float, along: int = ALONG) -> dict[str, Any]:
    end = along * ACROSS
    return {
        "sheetmorph": 1,
        "energy": energy,
        "parts": [{"name": "p", "thickness": 0.5}],
        "fixed": [{"part": "p", "vertices": list(range(ACROSS))}],
        "handles": [{"name": "h", "part": "p", "vertices": list(range(end - ACROSS, end))}],
        "pose": {"h": {"rotation": {"axis": [1, 0, 0], "degrees": degrees}}},
    }


def twist(positions: np.ndarray, along: int = ALONG) -> tuple[np.ndarray, float]:
    """Unwrapped degrees of the cross direction along a strip, and its least width of its own."""
    places = positions.reshape(along, ACROSS, 3)
    cross = places[:, -1] - places[:, 0]
    angles = np.unwrap(np.arctan2(cross[:, 2], cross[:, 1]))
    return np.degrees(angles - angles[0]), float(np.linalg.norm(cross, axis=1).min() / WIDTH)


@pytest.mark.parametrize("energy", ENERGIES)
def test_whole_turns_of_a_handle_are_kept(energy: str) -> None:
    for degrees in (90, 170, 190, 300, 360, 400, 720):
        answer = sheetmorph.Session(recipe(energy, degrees), {"p": strip()}).deform()
        angles, width = twist(answer.positions["p"])
        assert angles[-1] == pytest.approx(degrees, abs=1e-6)
        assert angles[ALONG // 2] == pytest.approx(degrees / 2, abs=2.0)
        assert width > (0.8 if energy == "natural" else 0.7)
        assert not [one for one in answer.report()["warnings"] if "lost" in one]


def two_parts(energy: str, propagation: str, degrees: float) -> dict[str, Any]:
    # The last fifteenth of the strip carries the second part along.
    shared = list(range(ACROSS * (ALONG - 5), ACROSS * ALONG))
    whole = recipe(energy, degrees)
    whole["parts"] = [{"name": "p"}, {"name": "q"}]
    whole["primary"] = "p"
    whole["propagation"] = {"type": propagation}
    whole["contacts"] = [
        {
            "name": "w",
            "a": {"part": "p", "vertices": shared},
            "b": {"part": "q", "vertices": list(range(ACROSS * 5))},
        }
    ]
    return whole


@pytest.mark.parametrize("propagation", ["local", "single", "whole"])
@pytest.mark.parametrize("energy", ["neumann", "natural", "paper"])
def test_a_second_part_does_not_change_how_the_first_one_twists(
    energy: str, propagation: str
) -> None:
    first = strip()
    second = sheetmorph.PartMesh(
        first.points + [LENGTH * (ALONG - 5) / (ALONG - 1), 0.0, 1.0], first.triangles
    )
    for degrees in (90, 190, 360, 720):
        session = sheetmorph.Session(
            two_parts(energy, propagation, degrees), {"p": first, "q": second}
        )
        answer = session.deform()
        positions = answer.positions
        angles, width = twist(positions["p"])
        assert angles[-1] == pytest.approx(degrees, abs=1e-6)
        assert width > 0.7
        angles, width = twist(positions["q"])
        # One control mesh around everything is too coarse to twist a second part evenly: a warning.
        assert width > 0.7 or (propagation == "single" and answer.report()["warnings"])
        assert abs(angles[-1]) < (90.0 if propagation == "single" else 60.0)


@pytest.mark.parametrize("energy", ["neumann", "natural", "paper"])
def test_a_mesh_that_is_too_coarse_for_whole_turns_is_a_warning(energy: str) -> None:
    session = sheetmorph.Session(recipe(energy, 720.0, along=4), {"p": strip(4)})
    (warning,) = [one for one in session.deform().report()["warnings"] if "lost" in one]
    assert 'the handle "h" (720 degrees)' in warning and "remesh" in warning
    small = sheetmorph.Session(recipe(energy, 90.0, along=4), {"p": strip(4)})
    assert not [one for one in small.deform().report()["warnings"] if "lost" in one]

# SPDX-License-Identifier: LGPL-2.1-or-later
"""Parts solved as a whole: what is held on any part holds, and motion goes both ways."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

from sheetmorph import PartMesh, RecipeError, Session

LENGTH, WIDTH, REACH, HEIGHT, GAP = 600.0, 80.0, 80.0, 120.0, 1.5


def sheet(lengths: np.ndarray, place: Any) -> PartMesh:
    """A strip along some lengths, WIDTH wide, its middle line placed by `place(length)`."""
    across = np.linspace(0.0, WIDTH, 9)
    points = np.array([[x, y, z] for x, z in map(place, lengths) for y in across])
    rows = np.arange(len(lengths) - 1)[:, None] * 9 + np.arange(8)
    a, b = rows.ravel(), rows.ravel() + 9
    triangles = np.concatenate([np.column_stack([a, b, b + 1]), np.column_stack([a, b + 1, a + 1])])
    return PartMesh(points, triangles)


def box_at(start: float, way: float) -> PartMesh:
    """A crash box: a flange below the beam, from its end inwards, and a wall that stands on it."""
    lengths = np.linspace(0.0, REACH + HEIGHT, 21)

    def place(length: float) -> tuple[float, float]:
        inwards = start + way * (REACH - length)
        wall = REACH - length
        return (inwards, -GAP) if length <= REACH else (start, wall - GAP)

    return sheet(lengths, place)


def vertices(mesh: PartMesh, chosen: np.ndarray) -> list[int]:
    return np.flatnonzero(chosen).tolist()


def welds(kind: str, meshes: dict[str, PartMesh]) -> list[dict[str, Any]]:
    """The flange of each box on its end of the beam."""
    x = meshes["beam"].points[:, 0]
    found = []
    for name, near in (("left", x <= REACH + 1e-6), ("right", x >= LENGTH - REACH - 1e-6)):
        flange = meshes[name].points[:, 2] > -GAP - 1e-6
        found.append({
            "name": f"weld {name}", "type": kind,
            "a": {"part": "beam", "vertices": vertices(meshes["beam"], near)},
            "b": {"part": name, "vertices": vertices(meshes[name], flange)},
        })  # fmt: skip
    return found


def bumper(
    kind: str, way: str, primary: str = "beam"
) -> tuple[dict[str, Any], dict[str, PartMesh]]:
    """A beam on two crash boxes that are held at their feet; its middle is pushed in."""
    beam = sheet(np.linspace(0.0, LENGTH, 61), lambda x: (x, 0.0))
    meshes = {"beam": beam, "left": box_at(0.0, 1.0), "right": box_at(LENGTH, -1.0)}
    feet = {
        name: vertices(meshes[name], meshes[name].points[:, 2] < 1e-6 - GAP - HEIGHT)
        for name in ("left", "right")
    }
    x, y = beam.points[:, 0], beam.points[:, 1]
    patch = (np.abs(x - 200.0) < 15.0) & (np.abs(y - WIDTH / 2) < 15.0)
    middle = {"name": "middle", "part": "beam", "vertices": vertices(beam, x == 300.0)}
    recipe = {
        "sheetmorph": 1,
        "parts": [{"name": name} for name in meshes],
        "primary": primary,
        "fixed": [{"part": name, "vertices": foot} for name, foot in feet.items()],
        "handles": [middle],
        "features": [{"name": "patch", "part": "beam", "vertices": vertices(beam, patch)}],
        "contacts": welds(kind, meshes),
        "propagation": {"type": way},
        "pose": {"middle": {"translation": [0, 0, -90]}},
    }
    return recipe, meshes


def strains(report: dict[str, Any]) -> dict[str, float]:
    return {part["name"]: part["quality"]["worst_strain"] for part in report["parts"]}


@pytest.mark.parametrize("kind", ["tied", "control mesh", "rigid"])
def test_crash_boxes_that_are_held_hold_the_beam(kind: str):
    local = Session(*bumper(kind, "local")).deform().report()
    assert any('set the propagation to "whole"' in text for text in local["warnings"])
    recipe, meshes = bumper(kind, "whole")
    result = Session(recipe, meshes).deform()
    report = result.report()
    assert report["warnings"] == []
    assert max(strains(report).values()) < 0.3 < 0.5 * max(strains(local).values())
    ends = result.positions["beam"][meshes["beam"].points[:, 0] < 1e-6]
    assert np.abs(ends - meshes["beam"].points[meshes["beam"].points[:, 0] < 1e-6]).max() < 40.0
    for entry in recipe["fixed"]:
        rest = meshes[entry["part"]].points[entry["vertices"]]
        assert np.array_equal(result.positions[entry["part"]][entry["vertices"]], rest)
    assert report["certificate"]["passed"]
    # Beside its side a sheet bends; that the driven side stands on the other is tested in C++.
    assert max(contact["gap_change"] for contact in report["contacts"]) < 0.2


def test_any_part_may_be_the_primary():
    shapes = [
        Session(*bumper("tied", "whole", primary)).deform().positions
        for primary in ("beam", "left", "right")
    ]
    for other in shapes[1:]:
        for name, points in shapes[0].items():
            assert np.abs(other[name] - points).max() < 1e-9


def test_what_has_no_effect_is_noted_and_what_cannot_be_is_refused():
    recipe, meshes = bumper("tied", "whole")
    recipe["parts"][1]["mode"] = 2
    recipe["regions"] = [{"part": "left", "vertices": [0], "role": "follower"}]
    notes = Session(recipe, meshes).deform().report()["notes"]
    assert sum("solves all parts together" in text for text in notes) == 2
    recipe, meshes = bumper("tied", "whole")
    recipe["energy"] = "steel"
    with pytest.raises(RecipeError, match="'whole' supports neither the energy 'steel'"):
        Session(recipe, meshes)

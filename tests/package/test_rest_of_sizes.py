# SPDX-License-Identifier: LGPL-2.1-or-later
"""What strains compare with: the shape at rest with the sizes of the pose, on any mesh."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from freecad.sheetmorph.tools.live_values import Stretch, legend_of

from plates import plate, recipe_of
from sheetmorph import PartMesh, Session
from sheetmorph.cli import main
from sheetmorph.measuring.strain import PrincipalStretches

LEAST = 0.05  # percent: the map marks no place below
SEEDS = range(6)


def session(part: Any, energy: str, **features: Any) -> Session:
    recipe = recipe_of(part, "plate.obj")
    recipe["energy"] = energy
    recipe["parts"][0]["thickness"] = 1.0
    for name, changes in features.items():
        next(f for f in recipe["features"] if f["name"] == name).update(changes)
    return Session(recipe, {"plate": PartMesh(part.points, part.triangles)})


def map_of(found: Any, exact: bool = True) -> float:
    """The largest value of the stretch map, percent."""
    mesh = found.session.meshes["plate"]
    valuer = Stretch(PrincipalStretches, {"plate": (mesh.points, mesh.triangles)})
    valuer.start_from(found.session.rest_shape(found.sizes, exact).positions)
    positions = {"plate": found.positions["plate"]}
    return legend_of(valuer, positions, valuer(positions)).extreme


@pytest.mark.parametrize("energy", ["neumann", "steel", "natural"])
@pytest.mark.parametrize("diameter", [6.0, 10.0])
def test_a_new_size_is_no_stretch(energy: str, diameter: float):
    """Whoever sets it, recipe or pose; exact and while dragging; each figure says the same."""
    for given, pose in ((diameter, {}), (8.0, {"hole1": {"size": diameter}})):
        model = session(plate(), energy, hole1={"size": given})
        for exact in (True, False):
            assert map_of(model.deform(pose, exact=exact), exact) < LEAST
        part = model.deform(pose).report()["parts"][0]
        assert part["quality"]["worst_strain"] < 1e-3 * LEAST
        assert part["stretch"] is None or part["stretch"]["largest"] < 1e-2 * LEAST


def test_a_size_hides_no_stretch_of_the_motion():
    """Far from the hole the figures are those of the same motion without the size."""
    model, moved = session(plate(), "neumann", hole1={"size": 8.0}), {
        "tip": {"translation": [6.0, 0.0, 0.0]}
    }
    plain = model.deform(moved).report()["parts"][0]["quality"]["worst_strain"]
    sized = model.deform({**moved, "hole1": {"size": 8.4}}).report()["parts"][0]["quality"]
    assert sized["worst_strain"] == pytest.approx(plain, rel=0.2) and plain > 0.05


def with_slivers(seed: int) -> Any:
    """The plate with some triangles pressed to almost nothing, and one to nothing."""
    made, draw = plate(), np.random.default_rng(seed)
    used = np.zeros(len(made.points), bool)
    used[[*made.left, *made.right, *sum(made.rims, [])]] = True
    for triangle in draw.permutation(made.triangles)[:40]:
        if used[triangle].any():
            continue
        used[triangle] = True
        a, b, c = triangle
        middle = 0.5 * (made.points[a] + made.points[b])
        height = 0.0 if not used.sum() % 5 else 10.0 ** draw.uniform(-16.0, -1.0)
        made.points[c] = middle + height * (made.points[c] - middle)
    return made


@pytest.mark.parametrize("seed", SEEDS)
def test_the_map_is_empty_at_rest_whatever_the_mesh(seed: int):
    part = with_slivers(seed)
    mesh = {"plate": (part.points, part.triangles)}
    valuer = Stretch(PrincipalStretches, mesh)
    assert legend_of(valuer, {"plate": part.points}, valuer({"plate": part.points})).extreme < LEAST
    # Positions that are as exact as those of a frame, or a file of single precision.
    rounded = {"plate": part.points.astype(np.float32).astype(float)}
    assert np.isfinite(valuer(rounded)["plate"]).all()
    stretches = PrincipalStretches(part.points, part.triangles)(part.points)
    assert np.nanmax(np.abs(stretches - 1.0)) < 1e-4 and np.isnan(stretches).any()


def test_the_table_of_a_run_shows_no_strain_for_a_size(
    folder: Path, capsys: pytest.CaptureFixture[str]
):
    recipe = json.loads((folder / "recipe.json").read_text())
    recipe["features"][1]["size"] = 10.0
    recipe["pose"] = {}
    (folder / "recipe.json").write_text(json.dumps(recipe))
    assert main(["run", "recipe.json", "-o", "out"]) == 0
    row = next(line for line in capsys.readouterr().out.splitlines() if line.startswith("plate"))
    assert float(row.split("%")[0].split()[-1]) < LEAST

# SPDX-License-Identifier: LGPL-2.1-or-later
"""Slopes of studies against differences of exact answers with longer steps, extrapolated."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from sheetmorph.study import Evaluator
from study_samples import write_recipe, write_study

FRAME = Path(__file__).resolve().parents[2] / "resources" / "examples" / "welded_frame"
PARAMETERS = {
    "lift": {"path": "pose.tip.translation[2]", "range": [0, 30]},
    "turn": {"path": "pose.tip.rotation.degrees", "range": [-40, 0]},
    "lean": {"path": "pose.tip.rotation.axis[0]", "range": [0, 0.5]},
    "wide": {"path": "features.hole0.size", "range": [7, 9]},
    "sheet": {"range": [1, 2]},
}
AT = {"lift": 10.0, "turn": -20.0, "lean": 0.2, "wide": 8.2, "sheet": 1.5}


def require_slopes(evaluator: Evaluator, at: dict[str, float], reach: float = 1e-6) -> None:
    """The slopes are those of central differences of second order, extrapolated to fourth."""
    found = evaluator.position_gradients(at)
    for k, (name, (low, high)) in enumerate(zip(evaluator.names, evaluator.bounds)):
        step = 2e-3 * (high - low)
        for part, slopes in found.items():

            def difference(h: float) -> np.ndarray:
                beyond, before = (evaluator.positions({**at, name: at[name] + s}) for s in (h, -h))
                return (beyond[part] - before[part]) / (2.0 * h)

            wanted = (4.0 * difference(0.5 * step) - difference(step)) / 3.0
            scale = max(1.0, np.abs(wanted).max())
            assert np.abs(slopes[:, :, k] - wanted).max() <= reach * scale, (name, part)


def changed_recipe(folder: Path, **keys: Any) -> None:
    recipe = json.loads(write_recipe(folder).read_text())
    recipe["pose"]["tip"]["rotation"]["axis"] = [0.2, 1, 0]
    (folder / "recipe.json").write_text(json.dumps({**recipe, **keys}))


@pytest.mark.parametrize("energy", ["paper", "neumann", "natural"])
@pytest.mark.parametrize("rotation", ["free", "interpolated"])
def test_slopes_are_those_of_differences(tmp_path: Path, energy: str, rotation: str):
    changed_recipe(tmp_path, energy=energy)
    recipe = json.loads((tmp_path / "recipe.json").read_text())
    for feature in recipe["features"]:
        feature["rotation"] = rotation
    (tmp_path / "recipe.json").write_text(json.dumps(recipe))
    require_slopes(Evaluator(write_study(tmp_path, parameters=PARAMETERS)), AT)


def test_slopes_with_points_bound_features_and_a_free_handle(tmp_path: Path):
    recipe = json.loads(write_recipe(tmp_path).read_text())
    del recipe["poses"]
    recipe["handles"][0]["rotation"] = "free"
    recipe["pose"] = {"tip": {"translation": [0, 0, 12]}}
    recipe["features"][0]["rotation"] = {"axis": [0, 1, 0], "degrees": 5}
    recipe["features"][1]["motion"] = {"type": "plane", "normal": [0, 1, 0]}
    point = {"name": "nail", "part": "plate", "triangle": 3, "barycentric": [0.2, 0.3, 0.5]}
    recipe["points"] = [{**point, "target": place_of(tmp_path, recipe, point)}]
    (tmp_path / "recipe.json").write_text(json.dumps(recipe))
    parameters = {
        "lift": PARAMETERS["lift"],
        "tilt": {"path": "pose.hole0.rotation.degrees", "range": [0, 10]},
        "nail": {"path": "points.nail.target[2]", "range": [-1, 3]},
        "wide": PARAMETERS["wide"],
    }
    recipe["pose"]["hole0"] = {"rotation": {"axis": [0, 1, 0], "degrees": 5}}
    (tmp_path / "recipe.json").write_text(json.dumps(recipe))
    evaluator = Evaluator(write_study(tmp_path, parameters=parameters))
    require_slopes(evaluator, {"lift": 8.0, "tilt": 4.0, "nail": 0.5, "wide": 8.1})


def place_of(folder: Path, recipe: dict[str, Any], point: dict[str, Any]) -> list[float]:
    """Where a point of the plate is at rest."""
    import sheetmorph

    mesh = sheetmorph.read_part(folder / recipe["parts"][0]["file"]).mesh
    corners = mesh.points[mesh.triangles[point["triangle"]]]
    return (np.array(point["barycentric"]) @ corners).tolist()


@pytest.mark.parametrize("contact", ["control mesh", "tied", "rigid"])
def test_slopes_go_through_contacts(tmp_path: Path, contact: str):
    recipe = json.loads((FRAME / "recipe.json").read_text())
    for part in recipe["parts"]:
        part["file"] = str(FRAME / part["file"])
    for entry in recipe["contacts"]:
        entry["type"] = contact
    (tmp_path / "recipe.json").write_text(json.dumps(recipe))
    place = "pose.front end"
    parameters = {
        "z": {"path": f"{place}.translation[2]", "range": [0, 60]},
        "turn": {"path": f"{place}.rotation.degrees", "range": [-9, 9]},
    }
    measure = {
        "gap": {"distance": ["front end", {"part": "seat plate", "vertex": 5}]},
        "area": {"area": ["rail left", "seat plate"]},
    }
    path = tmp_path / "study.json"
    study = {"sheetmorph_study": 1, "recipe": "recipe.json", "parameters": parameters}
    path.write_text(json.dumps({**study, "sampling": {"count": 4}, "measure": measure}))
    evaluator = Evaluator(path)
    at = {"z": 30.0, "turn": 4.0}
    require_slopes(evaluator, at)
    slopes = evaluator.gradient(at)
    for k, (name, step) in enumerate((("z", 0.05), ("turn", 0.01))):
        beyond, before = (evaluator.array({**at, name: at[name] + s}) for s in (step, -step))
        wanted = (beyond - before) / (2.0 * step)
        assert slopes[:, k] == pytest.approx(wanted, rel=1e-4, abs=1e-5)


def test_slopes_of_refined_answers_and_of_what_needs_another_pre_processing(tmp_path: Path):
    changed_recipe(tmp_path, refine=True, propagation={"type": "local", "smoothness": 0.05})
    parameters = {
        "lift": PARAMETERS["lift"],
        "smooth": {"path": "propagation.smoothness", "range": [0.01, 0.1]},
        "sheet": PARAMETERS["sheet"],
    }
    evaluator = Evaluator(write_study(tmp_path, parameters=parameters))
    found = evaluator.position_gradients({"lift": 5.0, "smooth": 0.05, "sheet": 1.0})["plate"]
    assert np.abs(found[:, :, 0]).max() == pytest.approx(1.0, abs=0.2)
    assert not found[:, :, 1:].any()


def test_slopes_under_steel_are_those_of_longer_steps(tmp_path: Path):
    changed_recipe(tmp_path, energy="steel")
    path = write_study(tmp_path, parameters={"lift": PARAMETERS["lift"]})
    require_slopes(Evaluator(path), {"lift": 6.0}, reach=1e-4)


@pytest.mark.parametrize("figure", ["stretch", "displacement", "angle", "fold"])
def test_figures_have_slopes(tmp_path: Path, figure: str):
    measure = {"worst": {"worst": figure}, "of part": {"worst": figure, "part": "plate"}}
    path = write_study(tmp_path, parameters={"lift": PARAMETERS["lift"]}, measure=measure)
    evaluator = Evaluator(path)
    slopes = evaluator.gradient({"lift": 6.3})
    step = 1e-3
    beyond, before = (evaluator.array({"lift": 6.3 + s}) for s in (step, -step))
    assert slopes[:, 0] == pytest.approx((beyond - before) / (2.0 * step), rel=1e-4, abs=1e-7)
    assert abs(slopes[0, 0]) > 1e-6


def test_what_stays_has_no_slope(tmp_path: Path):
    measure = {"holes": {"worst": "edge error"}}
    path = write_study(tmp_path, parameters={"lift": PARAMETERS["lift"]}, measure=measure)
    assert abs(Evaluator(path).gradient({"lift": 6.3})[0, 0]) < 1e-6

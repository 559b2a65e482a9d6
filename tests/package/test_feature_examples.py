# SPDX-License-Identifier: LGPL-2.1-or-later
"""Motions and sizes of form features on the examples, and on real parts where they are at hand."""

from __future__ import annotations

import json
import sys
from pathlib import Path

import numpy as np
import pytest

from sheetmorph import Result, Session, _core, read_part

sys.path.insert(0, str(Path(__file__).resolve().parents[1] / "real"))

import recipes  # noqa: E402
import selection  # noqa: E402

EXAMPLES = Path(__file__).resolve().parents[2] / "resources" / "examples"
needs_data = pytest.mark.skipif(recipes.data_folder() is None, reason=recipes.ABSENT)
CASES = [
    "door_mirror",
    "body_panels",
    "welded_frame",
    pytest.param("bracket", marks=needs_data),
    pytest.param("shelf", marks=needs_data),
]
DIRECTION = np.array([0.6, 0.0, 0.8])
MOTIONS = {
    "fixed": {},
    "translation": {},
    "plane": {"normal": DIRECTION.tolist()},
    "line": {"direction": DIRECTION.tolist()},
    "axis": {"direction": DIRECTION.tolist()},
}


def made(name: str) -> tuple[dict, dict]:
    """The recipe of an example or a real part, and its meshes by name."""
    if name not in recipes.MAKERS:
        recipe = json.loads((EXAMPLES / name / "recipe.json").read_text(encoding="utf-8"))
        files = {part["name"]: EXAMPLES / name / part["file"] for part in recipe["parts"]}
        return recipe, {part: read_part(file).mesh for part, file in files.items()}
    recipe = recipes.make(name)
    return recipe, selection.read_meshes(recipe["parts"], recipes.data_folder())


def holes_of(recipe: dict, meshes: dict, *, away: bool = True) -> list[tuple[dict, object]]:
    """Round holes among the form features, with their shapes; `away`: from what drives them."""
    driven = {
        (side["part"], vertex)
        for contact in recipe.get("contacts", [])
        for side in (contact["a"], contact["b"])
        for vertex in side["vertices"]
    }
    for entry in [*recipe["fixed"], *recipe["handles"]]:
        driven |= {(entry["part"], vertex) for vertex in entry.get("vertices", [])}
    found = []
    for entry in recipe["features"]:
        mesh = meshes[entry["part"]]
        indices, _ = mesh.find(entry["vertices"])
        shape = _core.feature_shape(mesh.points, mesh.triangles, indices)
        is_away = not any((entry["part"], vertex) in driven for vertex in entry["vertices"])
        if shape is not None and shape.kind == "hole" and (is_away or not away):
            found.append((entry, shape))
    return found


def result_of(recipe: dict, meshes: dict) -> Result:
    """The result in the recipe's own pose, after the certificate has been looked at."""
    result = Session(recipe, meshes).deform()
    assert result.report()["certificate"]["passed"]
    return result


def circle_of(points: np.ndarray) -> tuple[float, float]:
    """Radius and worst distance of points (k, 3) from the circle through them."""
    arms = points - points.mean(axis=0)
    frame = np.linalg.svd(arms, full_matrices=False)[2]
    flat = arms @ frame[:2].T
    terms = np.column_stack([2.0 * flat, np.ones(len(flat))])
    fit = np.linalg.lstsq(terms, (flat**2).sum(axis=1), rcond=None)[0]
    radius = np.sqrt(fit[2] + fit[:2] @ fit[:2])
    off = np.hypot(np.linalg.norm(flat - fit[:2], axis=1) - radius, arms @ frame[2])
    return float(radius), float(np.abs(off).max())


def motion_errors(kind: str, feature: object, point: np.ndarray) -> list[np.ndarray]:
    """What should be zero for a feature that keeps a motion."""
    shift, turn = feature.translation, feature.rotation
    arm = feature.centre - point
    return {
        "fixed": [shift, turn - np.eye(3)],
        "translation": [turn - np.eye(3)],
        "plane": [shift @ DIRECTION, turn @ DIRECTION - DIRECTION],
        "line": [np.cross(shift, DIRECTION)],
        "axis": [turn @ DIRECTION - DIRECTION, arm + shift - turn @ arm],
    }[kind]


@pytest.mark.parametrize("kind", MOTIONS)
@pytest.mark.parametrize("name", CASES)
def test_every_motion_is_met_to_rounding(name: str, kind: str):
    recipe, meshes = made(name)
    on_primary = [
        entry for entry, _ in holes_of(recipe, meshes) if entry["part"] == recipe["primary"]
    ]
    chosen = (on_primary or [entry for entry, _ in holes_of(recipe, meshes)])[0]
    mesh = meshes[chosen["part"]]
    centre = mesh.points[mesh.find(chosen["vertices"])[0]].mean(axis=0)
    point = centre + (3.0, -7.0, 2.0)
    chosen["rotation"] = "free"
    chosen["motion"] = {"type": kind, **MOTIONS[kind]}
    if kind == "axis":
        chosen["motion"]["point"] = point.tolist()
    result = result_of(recipe, meshes)
    feature = next(entry for entry in result.features if entry.name == chosen["name"])
    worst = max(np.abs(error).max() for error in motion_errors(kind, feature, point))
    assert worst < 1e-12 * result.session.size


@pytest.mark.parametrize("name", ["body_panels", "welded_frame"])
def test_ten_holes_get_new_diameters_exactly(name: str):
    recipe, meshes = made(name)
    holes = holes_of(recipe, meshes, away=False)
    chosen = [holes[k] for k in np.linspace(0, len(holes) - 1, 10).astype(int)]
    wanted = {}
    for (entry, shape), factor in zip(chosen, np.linspace(0.8, 1.5, 10)):
        entry["size"] = float(factor * shape.size)
        wanted[entry["name"]] = entry["size"], shape
    result = result_of(recipe, meshes)
    assert sum(part["quality"]["flipped"] for part in result.report()["parts"]) == 0
    sized = [feature for feature in result.features if feature.size is not None]
    assert len(sized) == len(wanted) == 10
    for feature in sized:
        diameter, shape = wanted[feature.name]
        vertices = result.session.feature_vertices(feature.name)
        arms = meshes[feature.part].points[vertices] - shape.centre
        rim = vertices[np.linalg.norm(arms, axis=1) < 0.51 * shape.size]  # without its washer
        radius, off = circle_of(result.positions[feature.part][rim])
        assert abs(2.0 * radius - diameter) < 1e-9
        assert off < 1e-9

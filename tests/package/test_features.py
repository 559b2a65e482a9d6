# SPDX-License-Identifier: LGPL-2.1-or-later
"""Form features as recipes declare them: rotations, motions, sizes, groups, pairs, symmetry."""

from __future__ import annotations

import json
from pathlib import Path

import jsonschema
import numpy as np
import pytest

from plates import Plate, plate, recipe_of, save_recipe, write_plate
from sheetmorph import PartMesh, RecipeError, Result, Session, run
from sheetmorph.reporting.report import report_schema

EXACT = 1e-10
MOVED = {"tip": {"translation": [1.0, 2.0, 12.0], "rotation": {"axis": [0, 1, 0], "degrees": -25}}}
MOTIONS = {
    "fixed": {"type": "fixed"},
    "translation": {"type": "translation"},
    "plane": {"type": "plane", "normal": [0, 0, 2]},
    "line": {"type": "line", "direction": [0, 1, 1]},
    "axis": {"type": "axis", "point": [20, 0, 3], "direction": [0, 1, 0]},
}


def deformed(part: Plate, hole1: dict | None = None, **entries: object) -> Result:
    """The result of a plate's recipe whose middle hole has more entries."""
    recipe = {**recipe_of(part, "plate.obj"), "pose": MOVED, **entries}
    recipe["features"][1].update(hole1 or {})
    jsonschema.validate(recipe, json.loads(json.dumps(_schema())))
    return Session(recipe, {"plate": PartMesh(part.points, part.triangles)}).deform()


def _schema() -> dict:
    from sheetmorph.recipe.structure import schema

    return schema()


def circle_of(result: Result, rim: list[int]) -> tuple[float, float]:
    """Radius of a rim about its centroid, and how far from it a vertex is at most."""
    rim_points = result.positions["plate"][rim]
    radii = np.linalg.norm(rim_points - rim_points.mean(axis=0), axis=1)
    return float(radii.mean()), float(np.ptp(radii))


def test_holes_turn_freely_by_default_and_tilt_with_the_sheet():
    part = plate()
    lifted = {"tip": {"translation": [0, 0, 12.0]}}
    free = deformed(part, pose=lifted)
    assert [f.rotation_type for f in free.features] == ["free"] * 3
    tilts = [np.degrees(np.arccos(f.rotation[2, 2])) for f in free.features]
    assert min(tilts) > 5.0
    recipe = recipe_of(part, "plate.obj")
    interpolated = [{**entry, "rotation": "interpolated"} for entry in recipe["features"]]
    flat = deformed(part, pose=lifted, features=interpolated)
    assert max(abs(f.rotation[2, 2] - 1.0) for f in flat.features) < 1e-12


@pytest.mark.parametrize("kind", MOTIONS)
def test_a_feature_keeps_its_motion(kind: str):
    feature = deformed(plate(), {"motion": MOTIONS[kind]}).features[1]
    shift, rotation = feature.translation, feature.rotation
    axis = np.array(MOTIONS[kind].get("direction", MOTIONS[kind].get("normal", [0, 0, 1])), float)
    axis /= np.linalg.norm(axis)
    point = feature.centre if kind == "plane" else np.array([20.0, 0.0, 3.0])
    errors = {
        "fixed": [shift, rotation - np.eye(3)],
        "translation": [rotation - np.eye(3)],
        "plane": [shift @ axis, rotation @ axis - axis],
        "line": [np.cross(shift, axis)],
        "axis": [
            rotation @ axis - axis,
            feature.centre + shift - point - rotation @ (feature.centre - point),
        ],
    }
    assert max(np.abs(error).max() for error in errors[kind]) < 1e-12 * 60
    assert feature.motion == kind
    assert feature.edge_error < EXACT
    if kind != "fixed":
        assert np.abs(shift).max() + np.abs(rotation - np.eye(3)).max() > 0.01


def test_a_motion_that_contradicts_its_handle_is_named():
    part = plate()
    with pytest.raises(RecipeError, match="hole1"):
        deformed(
            part,
            {"motion": {"type": "fixed"}},
            handles=[{"name": "tip", "part": "plate", "vertices": part.rims[1]}],
        )


@pytest.mark.parametrize("diameter", [6.4, 8.0, 10.0, 12.0])
def test_a_diameter_is_set_exactly(diameter: float):
    part = plate()
    result = deformed(part, {"size": diameter})
    radius, spread = circle_of(result, part.rims[1])
    assert abs(radius - diameter / 2.0) < EXACT and spread < EXACT
    feature = result.features[1]
    assert (feature.kind, feature.size) == ("hole", diameter)
    assert feature.outline_error < EXACT and feature.edge_error < EXACT
    quality = result.report()["parts"][0]["quality"]
    assert quality["flipped"] == 0 and quality["after"]["degenerate"] == 0


def test_a_pose_sets_the_size_over_the_recipe():
    part = plate()
    result = deformed(part, {"size": 9.0}, pose={**MOVED, "hole1": {"size": 11.0}})
    assert abs(circle_of(result, part.rims[1])[0] - 5.5) < EXACT


def test_too_large_a_size_names_the_largest_that_can_be():
    with pytest.raises(RecipeError, match=r"hole1.*largest|hole1.*at most") as caught:
        deformed(plate(), {"size": 60.0})
    assert "mm" in str(caught.value)


@pytest.mark.parametrize(
    "what, kind", [("fixed region", "fixed"), ("handle", "handles"), ("feature", "features")]
)
@pytest.mark.parametrize("with_rim", [False, True])
def test_a_size_that_something_stops_names_what_it_is(what: str, kind: str, with_rim: bool):
    """Around the hole, or around and on its rim; a size that fits is set all the same."""
    part = plate()
    centre = part.points[part.rims[1]].mean(axis=0)
    near = np.flatnonzero(np.linalg.norm(part.points - centre, axis=1) < 7.5).tolist()
    held = near if with_rim else [vertex for vertex in near if vertex not in part.rims[1]]
    recipe = recipe_of(part, "plate.obj")
    recipe["features"][1]["size"] = 10.0
    recipe[kind].append({"name": "Base", "part": "plate", "vertices": held})
    session = Session(recipe, {"plate": PartMesh(part.points, part.triangles)})
    session.deform({})
    with pytest.raises(RecipeError) as caught:
        session.deform({"hole1": {"size": 14.0}})
    assert f"{what} 'Base' holds the sheet around it" in str(caught.value)
    assert "largest possible" in str(caught.value)


def test_a_size_of_other_vertices_is_refused():
    part = plate()
    with pytest.raises(RecipeError, match="not a hole, slot or cylinder"):
        deformed(part, {"size": 9.0, "vertices": part.rims[1][:10]})


def test_groups_pairs_and_free_handles():
    part = plate()
    grouped = deformed(part, groups=[{"name": "row", "features": ["hole0", "hole1"]}])
    first, second = grouped.features[:2]
    assert np.abs(first.rotation - second.rotation).max() < 1e-12
    distant = deformed(part, distance=[{"features": ["hole0", "hole2"]}])
    ends = [distant.features[k].centre + distant.features[k].translation for k in (0, 2)]
    assert abs(np.linalg.norm(ends[1] - ends[0]) - 40.0) < EXACT
    handles = recipe_of(part, "plate.obj")["handles"]
    handles[0]["rotation"] = "free"
    lifted = deformed(part, handles=handles, pose={"tip": {"translation": [0, 0, 12.0]}})
    tip = lifted.positions["plate"][part.right]
    assert np.abs(tip.mean(axis=0) - part.points[part.right].mean(axis=0) - [0, 0, 12]).max() < 1e-9
    assert lifted.features[2].rotation[2, 2] < 0.99


def test_a_handle_picked_as_a_point_may_turn_freely():
    part = plate()
    corner = next(k for k, t in enumerate(part.triangles) if set(t.tolist()) & set(part.right[:1]))
    place = {"part": "plate", "triangle": corner, "barycentric": [0.2, 0.3, 0.5]}
    handle = {"name": "tip", **place, "rotation": "free"}
    lifted = {"tip": {"translation": [0, 0, 5.0]}}
    result = deformed(part, handles=[handle], pose=lifted)
    moved = (result.positions["plate"] - part.points)[part.triangles[corner]]
    assert np.abs(np.array([0.2, 0.3, 0.5]) @ moved - [0, 0, 5.0]).max() < EXACT
    held = {**handle}
    del held["rotation"]
    other = deformed(part, handles=[held], pose=lifted)
    assert result.features[2].rotation[2, 2] < other.features[2].rotation[2, 2] + 1e-12


def test_bolted_holes_of_two_parts_stay_in_line(tmp_path: Path):
    part = plate()
    recipe = recipe_of(part, "plate.obj")
    recipe["parts"].append({"name": "lid", "file": "lid.obj"})
    recipe["primary"] = "plate"
    recipe["fixed"].append({"part": "lid", "vertices": part.left})
    recipe["features"].append({"name": "bolt", "part": "lid", "vertices": part.rims[2]})
    recipe["coaxial"] = [{"features": ["bolt", "hole2"]}]
    write_plate(part, tmp_path / "plate.obj", "obj")
    part.points[:, 2] += 3.0
    write_plate(part, tmp_path / "lid.obj", "obj")
    report = run(save_recipe(recipe, tmp_path), tmp_path / "out")
    assert report["certificate"]["passed"] and report["levels"] == {"plate": 0, "lid": 1}
    leader, bolt = report["features"][2:4]
    axis = np.array(leader["rotation"])[:, 2]
    way = np.add(bolt["centre"], bolt["translation"]) - np.add(
        leader["centre"], leader["translation"]
    )
    assert np.abs(np.cross(way, axis)).max() < EXACT
    assert np.abs(np.array(bolt["rotation"])[:, 2] - axis).max() < EXACT
    assert np.linalg.norm(bolt["translation"]) > 1.0


def test_a_plane_of_symmetry_moves_both_sides():
    part = plate()
    middle = [k for k, p in enumerate(part.points) if abs(p[0] - 20.0) < 2.0 and p[1] < -9.9]
    result = deformed(
        part,
        {"size": 9.0},
        fixed=[{"part": "plate", "vertices": middle}],
        symmetry={"point": [20, 0, 0], "normal": [2, 0, 0]},
    )
    points = result.positions["plate"]
    places = {tuple(np.round(p, 6) + 0.0): k for k, p in enumerate(part.points)}
    mirrored = [places[tuple(np.round([40.0 - p[0], *p[1:]], 6) + 0.0)] for p in part.points]
    flipped = points[mirrored] * [-1, 1, 1] + [40, 0, 0]
    assert np.abs(points[part.left] - flipped[part.left]).max() < 1e-9
    assert abs(points[part.left][:, 2].mean() - 12.0) < 1e-6
    report = result.report()
    assert report["symmetry"] == {"point": [20.0, 0.0, 0.0], "normal": [2.0, 0.0, 0.0]}


def test_what_the_other_side_lacks_is_added_and_certified():
    part = plate()
    recipe = recipe_of(part, "plate.obj")
    recipe["features"] = [{**recipe["features"][0], "size": 9.0}]
    recipe["fixed"][0]["vertices"] = part.rims[1]
    recipe["symmetry"] = {"point": [20, 0, 0], "normal": [1, 0, 0]}
    session = Session(recipe, {"plate": PartMesh(part.points, part.triangles)})
    result = session.deform()
    report = result.report()
    assert [entry["name"] for entry in report["features"]] == ["hole0", "hole0 (mirrored)"]
    assert report["certificate"]["passed"]
    for rim in (part.rims[0], part.rims[2]):
        assert abs(circle_of(result, rim)[0] - 4.5) < EXACT


def test_another_size_takes_the_factor_over():
    part = plate()
    recipe = recipe_of(part, "plate.obj")
    meshes = {"plate": PartMesh(part.points, part.triangles)}
    recipe["features"][0]["size"] = 9.0
    first = Session(recipe, meshes)
    recipe["features"][0]["size"] = 10.0
    again = Session(recipe, meshes, previous=first)
    assert "part plate" in first.timings and "part plate" not in again.timings
    assert abs(circle_of(again.deform(), part.rims[0])[0] - 5.0) < EXACT


def test_the_report_tells_rotation_motion_and_size(tmp_path: Path):
    part = plate()
    write_plate(part, tmp_path / "plate.obj", "obj")
    recipe = recipe_of(part, "plate.obj")
    recipe["features"][0].update({"size": 7.0, "rotation": "interpolated"})
    recipe["features"][2]["motion"] = {"type": "line", "direction": [0, 0, 1]}
    report = run(save_recipe(recipe, tmp_path), tmp_path / "out")
    jsonschema.Draft202012Validator(report_schema()).validate(report)
    first, second, third = report["features"]
    assert report["certificate"]["passed"]
    assert (first["rotation_type"], first["kind"], first["size"]) == ("interpolated", "hole", 7.0)
    assert first["outline_error"] < report["tolerance"]
    assert first["file_edge_error"] < 1e-9
    assert (second["size"], second["outline_error"], second["kind"]) == (None, None, None)
    assert third["motion"] == "line"

# SPDX-License-Identifier: LGPL-2.1-or-later
"""Recipes with thin solids: the key, what it does, and what the report tells."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

import jsonschema
import numpy as np
import pytest

from sheetmorph import PartMesh, RecipeError, Session, _core, run
from sheetmorph.cli import main
from sheetmorph.reporting.report import report_schema
from thin_plates import ThinPlate, thin_plate

PLATE = thin_plate()


def recipe_of(plate: ThinPlate, thin: Any, **entries: Any) -> dict[str, Any]:
    """A recipe of the plate: one end held, the other lifted and turned, the holes features."""
    part = {"name": "plate", "file": "plate.obj", **({} if thin is None else {"thin": thin})}
    return {
        "sheetmorph": 1,
        "parts": [part],
        "fixed": [{"part": "plate", "vertices": plate.left}],
        "handles": [{"name": "tip", "part": "plate", "vertices": plate.right}],
        "features": [{"part": "plate", "vertices": rim} for rim in plate.rims],
        "pose": {
            "tip": {"translation": [-1, 0, 12], "rotation": {"axis": [0, 1, 0], "degrees": -25}}
        },
        **entries,
    }


def mesh_of(plate: ThinPlate) -> dict[str, PartMesh]:
    """The plate as the only part."""
    return {"plate": PartMesh(plate.points, plate.triangles)}


@pytest.mark.parametrize("thin", ["auto", {"thickness": 1.0}, {"thickness": 1}])
def test_a_thin_solid_keeps_its_thickness_and_the_report_says_so(thin: Any):
    result = Session(recipe_of(PLATE, thin), mesh_of(PLATE)).deform()
    report = result.report()
    jsonschema.Draft202012Validator(report_schema()).validate(report)
    entry = report["parts"][0]["thin"]
    assert entry["thickness"] == pytest.approx(1.0)
    assert entry["holes"] == 3 and entry["lumps"] == []
    assert entry["rest"]["least"] == pytest.approx(1.0) == entry["rest"]["most"]
    assert entry["largest_change"] < 0.005
    assert entry["largest_change_at_walls"] < 0.02
    assert report["certificate"]["passed"]


def test_a_hole_moves_as_one_though_one_rim_is_the_feature():
    result = Session(recipe_of(PLATE, "auto"), mesh_of(PLATE)).deform()
    hole = result.features[1]
    rim = np.array(PLATE.rims[1])
    both = np.concatenate([rim, rim + PLATE.count])
    moved = hole.centre + hole.translation + (PLATE.points[both] - hole.centre) @ hole.rotation.T
    assert np.abs(moved - result.positions["plate"][both]).max() < 1e-12


def test_without_the_key_a_closed_mesh_deforms_as_the_surface_it_is():
    left_out = Session(recipe_of(PLATE, None), mesh_of(PLATE)).deform()
    refused = Session(recipe_of(PLATE, False), mesh_of(PLATE)).deform()
    assert np.array_equal(left_out.positions["plate"], refused.positions["plate"])
    assert left_out.report()["parts"][0]["thin"] is None
    thin = Session(recipe_of(PLATE, "auto"), mesh_of(PLATE)).deform()
    assert not np.array_equal(left_out.positions["plate"], thin.positions["plate"])


def test_held_and_handle_vertices_are_met_bitwise_on_both_skins():
    result = Session(recipe_of(PLATE, "auto"), mesh_of(PLATE)).deform()
    positions = result.positions["plate"]
    assert np.array_equal(positions[PLATE.left], PLATE.points[PLATE.left])


def test_what_is_no_thin_solid_is_told():
    upper = PLATE.triangles[(PLATE.triangles < PLATE.count).all(axis=1)]
    sheet = PartMesh(PLATE.points[: PLATE.count], upper)
    entries = {
        "fixed": [{"part": "plate", "vertices": [0]}],
        "handles": [{"name": "tip", "part": "plate", "vertices": [1]}],
        "features": [],
    }
    automatic = Session(recipe_of(PLATE, "auto", **entries), {"plate": sheet})
    report = automatic.deform().report()
    (note,) = [text for text in report["notes"] if text not in report["warnings"]]
    assert note.startswith('thin "auto" of "plate" has no effect')
    with pytest.raises(RecipeError, match="it is not a thin solid: its surface is not closed"):
        Session(recipe_of(PLATE, {"thickness": 1.0}, **entries), {"plate": sheet})


@pytest.mark.parametrize(
    "thin, told",
    [
        (True, 'true is not valid; give "auto" (the default of CAD files), false (the default of'),
        ("yes", '"yes" is not valid; give "auto" (the default of CAD files), false'),
        ({"thickness": 0}, "0 is not valid"),
        ({"thickness": -2.0}, "-2.0 is not valid"),
        ({"thick": 2.0}, "thickness"),
        ({}, 'the key "thickness" is missing'),
    ],
)
def test_a_key_that_makes_no_sense_is_a_fault(thin: Any, told: str):
    with pytest.raises(RecipeError) as caught:
        Session(recipe_of(PLATE, thin), mesh_of(PLATE))
    (fault,) = caught.value.faults
    assert fault.where.startswith("parts[plate].thin") or "parts" in fault.where
    assert told in f"{fault.what}; {fault.todo}"


def test_a_recipe_file_runs_on_the_command_line(tmp_path: Path):
    points = [f"v {x!r} {y!r} {z!r}" for x, y, z in PLATE.points.tolist()]
    faces = [f"f {a + 1} {b + 1} {c + 1}" for a, b, c in PLATE.triangles.tolist()]
    (tmp_path / "plate.obj").write_text("\n".join(points + faces) + "\n", "utf-8")
    (tmp_path / "recipe.json").write_text(json.dumps(recipe_of(PLATE, "auto")), "utf-8")
    out, report = tmp_path / "out", tmp_path / "report.json"
    arguments = ["run", str(tmp_path / "recipe.json"), "-o", str(out), "--report", str(report)]
    assert main(arguments) == 0
    told = json.loads(report.read_text("utf-8"))["parts"][0]["thin"]
    assert told["holes"] == 3
    assert run(tmp_path / "recipe.json", tmp_path / "again")["parts"][0]["thin"] == told


def sized_recipe(size: float | None, pose: dict[str, Any] | None) -> dict[str, Any]:
    """The plate, the hole in its middle 8 mm at rest with a size."""
    recipe = recipe_of(PLATE, "auto")
    recipe["features"][1]["name"] = "middle"
    if size is not None:
        recipe["features"][1]["size"] = size
    return recipe if pose is None else {**recipe, "pose": pose}


@pytest.mark.parametrize("pose", [{}, None], ids=["flat", "bent"])
def test_a_hole_takes_a_size_through_both_skins_and_the_wall(pose: dict[str, Any] | None):
    result = Session(sized_recipe(12.0, pose), mesh_of(PLATE)).deform()
    points = result.positions["plate"]
    report = result.report()
    assert report["certificate"]["passed"]
    thin = report["parts"][0]["thin"]
    assert thin["largest_change"] < 0.01 and thin["largest_change_at_walls"] < 0.02
    assert thin["self_intersections"] == {"rest": 0, "deformed": 0}
    rim = np.array(PLATE.rims[1])
    circles = [_core.fit_circle(points[ids]) for ids in (rim, rim + PLATE.count)]
    for circle, ids in zip(circles, (rim, rim + PLATE.count)):
        away = np.linalg.norm(points[ids] - circle.centre, axis=1)
        assert np.abs(away - 6.0).max() < 1e-9
    axis = np.asarray(circles[0].axis)
    between = np.asarray(circles[0].centre) - np.asarray(circles[1].centre)
    assert np.linalg.norm(np.cross(axis, between)) < 1e-9  # the wall stands straight
    assert np.linalg.norm(between) == pytest.approx(1.0, abs=1e-9)
    for rims in (PLATE.rims[0], PLATE.rims[2]):  # the others stay as they are
        away = _core.fit_circle(points[rims])
        assert away.radius == pytest.approx(4.0, abs=1e-9)


def test_a_size_in_the_pose_of_a_thin_part_is_that_of_the_recipe():
    as_given = Session(sized_recipe(12.0, None), mesh_of(PLATE)).deform()
    session = Session(sized_recipe(8.0, None), mesh_of(PLATE))
    pose = {**recipe_of(PLATE, "auto")["pose"], "middle": {"size": 12.0}}
    in_pose = session.deform(pose)
    assert np.allclose(in_pose.positions["plate"], as_given.positions["plate"], atol=1e-9)
    drag = session.begin_drag(["tip"], pose)
    drag.wait()
    assert np.allclose(drag.deform(pose).positions["plate"], in_pose.positions["plate"], atol=1e-4)


def test_a_size_that_a_thin_sheet_has_no_room_for_is_refused():
    with pytest.raises(RecipeError, match="possible|largest|room"):
        Session(sized_recipe(40.0, {}), mesh_of(PLATE)).deform()


def test_a_thickness_that_changes_much_is_a_warning_with_its_place(
    monkeypatch: pytest.MonkeyPatch,
):
    result = Session(recipe_of(PLATE, "auto"), mesh_of(PLATE)).deform()
    report = result.report()
    assert not [text for text in report["warnings"] if "thickness" in text]
    entry = report["parts"][0]["thin"]
    worst = entry["worst"]
    change = max(entry["largest_change"], entry["largest_change_at_walls"])
    assert abs(worst["deformed"] / worst["rest"] - 1.0) == pytest.approx(change)
    away = np.linalg.norm(result.positions["plate"] - worst["place"], axis=1)
    assert away.min() < 1e-9
    monkeypatch.setattr("sheetmorph.reporting.cautions._THINNED", 0.5 * change)
    (warning,) = [text for text in result.report()["warnings"] if "thickness" in text]
    place = ", ".join(f"{x:.4g}" for x in worst["place"])
    assert warning.startswith('the thickness of "plate" changes by ')
    assert f"({place})" in warning and f"to {worst['deformed']:.3g} mm" in warning

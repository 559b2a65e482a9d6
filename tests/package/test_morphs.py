# SPDX-License-Identifier: LGPL-2.1-or-later
"""From recipe to deformed files, every format, with the kernel."""

from __future__ import annotations

import json
from pathlib import Path

import jsonschema
import numpy as np
import pytest

from plates import FORMATS, Plate, plate, recipe_of, save_recipe, write_plate
from sheetmorph import PartMesh, RecipeError, Session, read_part, run
from sheetmorph.reporting.report import report_schema


def session_of(part: Plate, **entries: object) -> Session:
    """The session of a plate's recipe with some entries exchanged."""
    recipe = {**recipe_of(part, "plate.obj"), **entries}
    return Session(recipe, {"plate": PartMesh(part.points, part.triangles)})


def run_plate(part: Plate, kind: str, folder: Path) -> tuple[dict, np.ndarray]:
    """The report and the positions in the written file of a plate in one of FORMATS."""
    name = "plate." + kind.split(".")[-1]
    path = write_plate(part, folder / name, kind)
    mesh = read_part(path).mesh
    order = [int(np.linalg.norm(mesh.points - p, axis=1).argmin()) for p in part.points]
    ids = np.array(mesh.file_ids(order))
    recipe = save_recipe(recipe_of(part, name, ids), folder)
    report = run(recipe, folder / "out", report=folder / "report.json")
    return report, read_part(folder / "out" / name).mesh.points[order]


@pytest.mark.parametrize("kind", FORMATS)
def test_holes_stay_round_in_every_format(kind: str, tmp_path: Path):
    part = plate()
    report, stored = run_plate(part, kind, tmp_path)
    assert report["certificate"] == {"passed": True, "failures": []}
    rounding = {"double": 1e-12, "float32": 1e-5, "8 characters": 2e-4, "16 characters": 1e-11}
    file = report["parts"][0]["file"]
    assert file["error"] <= rounding[file["precision"]]
    for feature, rim in zip(report["features"], part.rims):
        assert feature["edge_error"] <= report["tolerance"] < 1e-9
        assert feature["file_edge_error"] <= 3.0 * max(file["error"], 1e-12)
        radii = np.linalg.norm(stored[rim] - stored[rim].mean(axis=0), axis=1)
        assert radii == pytest.approx(4.0, abs=1e-3)


@pytest.mark.parametrize("kind", FORMATS)
def test_the_report_keeps_to_its_schema(kind: str, tmp_path: Path):
    report, _ = run_plate(plate(holes=1), kind, tmp_path)
    jsonschema.Draft202012Validator.check_schema(report_schema())
    jsonschema.Draft202012Validator(report_schema()).validate(report)
    written = json.loads((tmp_path / "report.json").read_text())
    assert {**written, "timings": 0} == {**json.loads(json.dumps(report)), "timings": 0}


def test_the_report_of_a_result_in_memory_has_no_file_figures():
    report = session_of(plate(holes=1)).deform().report()
    jsonschema.Draft202012Validator(report_schema()).validate(report)
    assert report["parts"][0]["file"] is None
    assert report["features"][0]["file_edge_error"] is None


def test_fixed_and_handle_vertices_are_where_the_recipe_puts_them():
    part = plate()
    session = session_of(part, pose={"tip": {"translation": [1.0, 2.0, 3.0]}})
    positions = session.deform().positions["plate"]
    assert np.array_equal(positions[part.left], part.points[part.left])
    assert np.array_equal(positions[part.right], part.points[part.right] + [1.0, 2.0, 3.0])


def test_no_motion_gives_the_rest_shape():
    part = plate()
    positions = session_of(part, pose={}).deform().positions["plate"]
    assert np.abs(positions - part.points).max() < 1e-10


def test_a_model_in_metres_gives_the_same_shape_as_in_millimetres():
    part, small = plate(), plate(scale=1e-3)
    recipe = recipe_of(small, "plate.obj")
    recipe["pose"]["tip"]["translation"] = [0.0, 0.0, 0.012]
    in_metres = Session(recipe, {"plate": PartMesh(small.points, small.triangles)}).deform()
    in_mm = session_of(part).deform()
    error = np.abs(in_metres.positions["plate"] * 1e3 - in_mm.positions["plate"]).max()
    assert error < 1e-9
    assert in_metres.report()["certificate"]["passed"]


def test_a_handle_turns_about_its_pivot_and_a_pose_may_move_it():
    part = plate()
    turn = {"axis": [0, 0, 2], "degrees": 90}
    handle = {"name": "tip", "part": "plate", "vertices": part.right, "pivot": [50.0, 0, 0]}
    session = session_of(part, handles=[handle], pose={})
    about_own = session.deform({"tip": {"rotation": turn}}).positions["plate"][part.right]
    about_origin = session.deform({"tip": {"rotation": turn, "pivot": [0, 0, 0]}})
    rest = part.points[part.right]
    turned = np.stack([-rest[:, 1], rest[:, 0], rest[:, 2]], axis=1)
    assert about_origin.positions["plate"][part.right] == pytest.approx(turned, abs=1e-12)
    assert about_own == pytest.approx(turned + [50.0, -50.0, 0], abs=1e-12)


def test_a_whole_turn_of_a_handle_is_kept():
    part = plate()
    turn = {"axis": [1, 0, 0], "degrees": 360}
    twisted = session_of(part, features=[], pose={"tip": {"rotation": turn}}).deform()
    middle = twisted.positions["plate"][part.rims[1]]
    assert np.abs(middle - part.points[part.rims[1]]).max() > 0.5


def test_a_prescribed_feature_turns_as_it_is_told_and_a_pose_overrides_it():
    part = plate()
    rotation = {"axis": [0, 0, 1], "degrees": 30}
    feature = {"name": "h", "part": "plate", "vertices": part.rims[1], "rotation": rotation}
    session = session_of(part, features=[feature], pose={})
    cosines = [
        session.deform(pose).features[0].rotation[0, 0]
        for pose in (None, {"h": {"rotation": {"axis": [0, 0, 1], "degrees": 60}}})
    ]
    assert cosines == pytest.approx([np.cos(np.pi / 6), 0.5], abs=1e-12)


def test_points_go_to_their_targets_and_stay_without_one():
    part = plate()
    points = [
        {"part": "plate", "triangle": 200, "barycentric": [0.2, 0.3, 0.5], "name": "pin"},
        {"part": "plate", "triangle": 60, "barycentric": [1, 0, 0]},
    ]
    session = session_of(part, points=points, features=[], pose={"pin": {"target": [20, 0, 5]}})
    positions = session.deform().positions["plate"]
    pin = np.array([0.2, 0.3, 0.5]) @ positions[part.triangles[200]]
    assert pin == pytest.approx([20, 0, 5], abs=1e-9)
    still = part.triangles[60][0]
    assert positions[still] == pytest.approx(part.points[still], abs=1e-9)


def test_a_handle_may_be_a_point_on_a_triangle():
    part = plate()
    handle = {"name": "tip", "part": "plate", "triangle": 400, "barycentric": [0.5, 0.25, 0.25]}
    motion = {"tip": {"translation": [0, 0, 4.0]}}
    session = session_of(part, handles=[handle], features=[], pose=motion)
    weights, corners = np.array([0.5, 0.25, 0.25]), part.triangles[400]
    moved = weights @ session.deform().positions["plate"][corners]
    assert moved == pytest.approx(weights @ part.points[corners] + [0, 0, 4.0], abs=1e-9)


def test_parts_nothing_reaches_stay_and_are_listed():
    part = plate(holes=1)
    other = PartMesh(part.points + [0, 0, 5.0], part.triangles)
    recipe = recipe_of(part, "plate.obj")
    recipe |= {"parts": [{"name": "plate"}, {"name": "lid"}], "primary": "plate"}
    session = Session(recipe, {"plate": PartMesh(part.points, part.triangles), "lid": other})
    result = session.deform()
    assert session.unreached == ["lid"]
    assert np.array_equal(result.positions["lid"], other.points)
    assert [entry["is_reached"] for entry in result.report()["parts"]] == [True, False]


def test_kernel_faults_name_node_ids_of_a_deck(tmp_path: Path):
    part = plate(holes=1)
    ids = np.arange(len(part.points)) + 101
    recipe = recipe_of(part, "plate.nas", ids)
    recipe |= {"handles": [*recipe["handles"], {**recipe["handles"][0], "name": "twin"}]}
    mesh = PartMesh(part.points, part.triangles, ids)
    with pytest.raises(RecipeError) as caught:
        Session(recipe, {"plate": mesh})
    fault = caught.value.faults[0]
    assert fault.where == "part 'plate'"
    assert str(ids[part.right[0]]) in fault.what
    assert fault.todo


def test_a_session_checks_recipe_meshes_and_poses():
    part = plate(holes=1)
    with pytest.raises(RecipeError, match="no mesh is given for the part"):
        Session(recipe_of(part, "plate.obj"), {})
    session = session_of(part)
    with pytest.raises(RecipeError, match="pose.tup: there is no handle"):
        session.deform({"tup": {}})
    with pytest.raises(RecipeError, match="pose.tip.translation: it has 2 entries"):
        session.deform({"tip": {"translation": [1, 2]}})
    with pytest.raises(RecipeError, match="pose.tip.size: .size. has no meaning"):
        session.deform({"tip": {"size": 2.0}})


def test_progress_is_reported_and_can_cancel():
    part = plate()
    meshes = {"plate": PartMesh(part.points, part.triangles)}
    told: list[float] = []
    Session(recipe_of(part, "plate.obj"), meshes, lambda share, _: told.append(share) is None)
    assert told and all(0.0 <= share <= 1.0 for share in told)
    with pytest.raises(RuntimeError, match="cancelled"):
        Session(recipe_of(part, "plate.obj"), meshes, lambda share, _: False)


def test_the_quick_way_is_near_the_exact_one():
    session = session_of(plate())
    quick = session.deform(exact=False).positions["plate"]
    exact = session.deform(exact=True).positions["plate"]
    assert np.abs(quick - exact).max() < 1e-6 * session.size

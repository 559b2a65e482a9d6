# SPDX-License-Identifier: LGPL-2.1-or-later
"""Recipes made in Python: arrays, tuples, numbers of numpy and masks, in memory or in a file."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import sheetmorph as sm
from plates import plate, write_plate
from sheetmorph import PartMesh, RecipeError, Session
from sheetmorph.recipe import read_json
from sheetmorph.study import Evaluator

STRIP = plate(holes=2)
MESH = PartMesh(np.array(STRIP.points, dtype=float), np.array(STRIP.triangles))
LIFT = {"tip": {"translation": [0.0, 0.0, 5.0]}}


def recipe(fixed: Any, tip: Any, pose: Any = LIFT) -> dict[str, Any]:
    return {
        "sheetmorph": 1,
        "parts": [{"name": "plate"}],
        "fixed": [{"part": "plate", "vertices": fixed}],
        "handles": [{"name": "tip", "part": "plate", "vertices": tip}],
        "pose": pose,
    }


def ends() -> tuple[np.ndarray, np.ndarray]:
    """Masks of the vertices at both ends."""
    x = MESH.points[:, 0]
    return x < x.min() + 1.0, x > x.max() - 1.0


def moved(recipe: dict[str, Any]) -> np.ndarray:
    return Session(recipe, {"plate": MESH}).deform().positions["plate"]


def plain_answer() -> np.ndarray:
    return moved(recipe(*(np.flatnonzero(mask).tolist() for mask in ends())))


@pytest.mark.parametrize(
    "of",
    [
        np.flatnonzero,
        lambda mask: mask,
        lambda mask: tuple(np.flatnonzero(mask).tolist()),
        lambda mask: list(np.flatnonzero(mask)),
        lambda mask: np.flatnonzero(mask).astype(np.uint16),
    ],
)
def test_a_session_takes_what_numpy_gives(of):
    fixed, tip = map(of, ends())
    pose = {"tip": {"translation": np.array([0, 0, 5])}}
    assert np.array_equal(moved(recipe(fixed, tip, pose)), plain_answer())


def test_a_pose_takes_arrays_and_its_report_is_plain():
    session = Session(recipe(*ends()), {"plate": MESH})
    pose = {"tip": {"translation": (0.0, np.float32(0.0), np.int64(5))}}
    result = session.deform(pose)
    assert result.report()["pose"] == LIFT
    drag = session.begin_drag(["tip"], pose)
    assert np.allclose(drag.deform(pose).positions["plate"], result.positions["plate"], atol=1e-4)


def test_a_mask_gives_the_node_ids_of_a_deck():
    mesh = PartMesh(MESH.points, MESH.triangles, ids=np.arange(len(MESH.points)) + 100)
    session = Session(recipe(*ends()), {"plate": mesh})
    fixed = next(entry for entry in session.model.of_kind("fixed"))
    assert min(fixed.vertices) >= 100


def test_a_mask_of_another_length_is_a_fault_with_a_place():
    with pytest.raises(RecipeError, match=r"fixed\[0\].vertices: the mask has 3 entries") as told:
        Session(recipe(np.ones(3, bool), [1]), {"plate": MESH})
    assert "give an entry for each vertex" in str(told.value)


def test_a_mask_without_a_mesh_is_refused(folder: Path):
    data = {"sheetmorph": 1, "parts": []}
    with pytest.raises(RecipeError, match="a mask belongs to no part"):
        sm.validate({**data, "fixed": [{"part": "plate", "vertices": np.ones(3, bool)}]}, folder)


def test_the_recipe_that_was_passed_is_not_changed():
    fixed, tip = ends()
    given = recipe(fixed, tip)
    moved(given)
    assert given["fixed"][0]["vertices"] is fixed and given["handles"][0]["vertices"] is tip


# -- Morph: entries are checked when they are given


@pytest.fixture
def morph(tmp_path: Path) -> sm.Morph:
    return sm.open_files(write_plate(STRIP, tmp_path / "strip.obj", "obj"))


def test_a_morph_takes_masks_and_arrays(morph: sm.Morph, tmp_path: Path):
    fixed, tip = ends()
    morph.fix(fixed).handle(np.flatnonzero(tip), "tip")
    morph.move("tip", np.array([0.0, 0.0, 5.0]), axis=np.array([0, 1, 0]), degrees=np.float64(3))
    assert morph.deform().positions["strip"].max() > 5.0
    morph.save(tmp_path / "recipe.json")
    assert sm.check(tmp_path / "recipe.json") == []


@pytest.mark.parametrize(
    ("where", "said"),
    [
        ([0, 9999], r"fixed\[0\].vertices: .*9999"),
        (np.ones(3, bool), "the mask has 3 entries"),
        (sm.half_space([0, 0, 0], [0, 0, 0]), "the normal has no length"),
        ({"box": [[0, 0, 0]]}, r"fixed\[0\].where"),
    ],
)
def test_fix_refuses_a_wrong_region_at_once(morph: sm.Morph, where, said: str):
    with pytest.raises(RecipeError, match=said):
        morph.fix(where)
    assert "fixed" not in morph.recipe


@pytest.mark.parametrize(
    ("name", "keys", "said"),
    [
        ("top", {"translation": [0, 0, 1]}, 'there is no handle, feature or point "top"'),
        ("tip", {"translation": [0, 0]}, r"pose.tip.translation"),
        ("tip", {"translation": [0, 0, np.nan]}, r"pose.tip.translation"),
        ("tip", {"axis": [0, 0, 1]}, r"pose.tip.rotation"),
        ("tip", {"wrong": 1}, "wrong"),
    ],
)
def test_move_refuses_a_wrong_motion_at_once(morph: sm.Morph, name: str, keys, said: str):
    morph.handle(ends()[1], "tip")
    with pytest.raises(RecipeError, match=said):
        morph.move(name, **keys)
    assert "pose" not in morph.recipe


def test_a_motion_may_come_before_its_handle(morph: sm.Morph):
    fixed, tip = ends()
    morph.move("tip", [0, 0, 5]).fix(fixed).handle(tip, "tip")
    assert morph.deform().positions["strip"][:, 2].max() > 4.9


# -- a dict or a path alike


def test_run_check_and_resolve_take_a_dict_or_a_path_alike(folder: Path):
    data = recipe_in(folder)
    assert sm.check(data) == sm.check("recipe.json") == []
    assert sm.resolve(data) == sm.resolve("recipe.json")
    from_dict, from_file = (sm.run(one, out) for one, out in ((data, "a"), ("recipe.json", "b")))
    assert from_dict["parts"] == from_file["parts"]
    assert Path("a/plate.obj").read_bytes() == Path("b/plate.obj").read_bytes()


def recipe_in(folder: Path) -> dict[str, Any]:
    found: dict[str, Any] = read_json(folder / "recipe.json")
    return found


def test_a_fault_of_a_recipe_in_memory_names_no_file(folder: Path):
    with pytest.raises(RecipeError, match=r"^<recipe>, energy: "):
        sm.run({**recipe_in(folder), "energy": "wrong"}, "out")
    assert not Path("out").exists()


def test_an_evaluator_takes_a_dict_or_a_path_alike(folder: Path):
    study = {
        "sheetmorph_study": 1,
        "recipe": "recipe.json",
        "parameters": {"lift": {"path": "pose.tip.translation[2]", "range": [0, 8], "steps": 2}},
    }
    Path("study.json").write_text(json.dumps(study), "utf-8")
    one, other = Evaluator(study), Evaluator("study.json")
    assert one([3.0]) == other([3.0]) and one.names == ["lift"]
    assert folder / "study.json" not in one.files_read

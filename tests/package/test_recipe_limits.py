# SPDX-License-Identifier: LGPL-2.1-or-later
"""Values of sound form that no kernel can take, and settings that have no effect."""

from __future__ import annotations

import numpy as np
import pytest

from plates import plate, recipe_of, save_recipe, write_plate
from sheetmorph import PartMesh, RecipeError, Session, validate
from sheetmorph.cli import main
from test_assembly_recipes import meshes, two_plates, with_type

PART = plate()
MESHES = {"plate": PartMesh(PART.points, PART.triangles)}


def recipe(**entries: object) -> dict:
    """The plate's recipe with entries exchanged."""
    return {**recipe_of(PART, "plate.obj"), **entries}


def faults(wanted: dict, given: dict[str, PartMesh] | None = None) -> list[str]:
    """What a session refuses, as people read it."""
    with pytest.raises(RecipeError) as caught:
        Session(wanted, given or MESHES)
    lines = [str(fault) for fault in caught.value.faults]
    assert all(line.isprintable() for line in lines)
    return lines


def moved(**motion: object) -> dict:
    """The plate's recipe with another motion of its handle."""
    return recipe(pose={"tip": motion})


@pytest.mark.parametrize(
    ("wanted", "message"),
    [
        (recipe(propagation={"smoothness": 1e-13}), "a number from 1e-12 to 1e6"),
        (recipe(propagation={"smoothness": -1}), "a number from 1e-12 to 1e6"),
        (recipe(propagation={"smoothness": 1e7}), "a number from 1e-12 to 1e6"),
        (recipe(propagation={"smoothness": float("inf")}), "finite number"),
        (moved(translation=[0, 0, 2e12]), "a length in mm, from -1e12 to 1e12"),
        (moved(pivot=[0, -2e12, 0]), "a length in mm, from -1e12 to 1e12"),
        (moved(rotation={"axis": [0, 1, 0], "degrees": 1e7}), "an angle in degrees, from -1e6"),
        (recipe(handles=[{"name": "h\ud800", "part": "plate", "vertices": [1]}], pose={}),
         "an invalid character"),
        (recipe(handles=[{"name": "h\0", "part": "plate", "vertices": [1]}], pose={}),
         "an invalid character"),
        (recipe(pose={"tip\udfff": {}}), "an invalid character"),
    ],
)  # fmt: skip
def test_values_out_of_range_are_one_fault(wanted: dict, message: str):
    (line,) = faults(wanted)
    assert message in line


def test_a_pose_alone_is_checked_in_the_same_way():
    session = Session(recipe(), MESHES)
    with pytest.raises(RecipeError, match="from -1e12 to 1e12"):
        session.deform({"tip": {"translation": [1e13, 0, 0]}})
    with pytest.raises(RecipeError, match="an invalid character"):
        session.deform({"tip\ud800": {}})


def test_whole_numbers_may_be_written_with_a_point():
    written = two_plates(parts=[{"name": "plate"}, {"name": "lid", "mode": 2.0}])
    written["propagation"] = {"levels": 2.0, "smoothness": 1}
    plain = two_plates(parts=[{"name": "plate"}, {"name": "lid", "mode": 2}])
    plain["propagation"] = {"levels": 2, "smoothness": 1.0}
    found = [Session(r, meshes()).deform().positions["lid"] for r in (written, plain)]
    assert np.array_equal(*found)


def test_deeply_nested_data_is_a_fault():
    deep: list = []
    for _ in range(5000):
        deep = [deep]
    assert faults(recipe(pose=deep)) == ["recipe: it is nested too deeply; simplify it"]


def test_an_empty_part_is_a_fault():
    empty = PartMesh(np.zeros((0, 3)), np.zeros((0, 3), dtype=np.int32))
    two = recipe(parts=[{"name": "plate"}, {"name": "lid"}], primary="plate")
    (line,) = faults(two, {**MESHES, "lid": empty})
    assert line.startswith("parts[1] (lid): the part lid has no vertices")


def test_ids_beyond_32_bits_are_a_fault():
    ids = np.arange(len(PART.points)) + 2**31
    shifted = recipe_of(PART, "plate.obj", ids)
    (line,) = faults(shifted, {"plate": PartMesh(PART.points, PART.triangles, ids)})
    assert "2147483648, 2147483649" in line and "beyond 2147483647; renumber its nodes" in line


def test_ids_are_found_all_at_once():
    mesh = PartMesh(np.zeros((4, 3)), np.zeros((0, 3), dtype=np.int32), np.array([40, 10, 30, 20]))
    indices, missing = mesh.find([10, 41, 20, 10**30, -5, 40])
    assert indices.tolist() == [1, 3, 0] and indices.dtype == np.int32
    assert missing == [41, 10**30, -5]
    plain = PartMesh(np.zeros((4, 3)), np.zeros((0, 3), dtype=np.int32))
    assert plain.find([3, 4, -1, 0, 10**30])[0].tolist() == [3, 0]


CLASHES = [
    {"handles": [{"name": "tip", "part": "plate", "vertices": PART.right},
                 {"name": "top", "part": "plate", "vertices": PART.right[:2]}]},
    {"features": [{"name": "both", "part": "plate", "vertices": [PART.left[0], PART.right[0]]}]},
]  # fmt: skip


@pytest.mark.parametrize("entries", CLASHES)
def test_check_finds_what_run_refuses(entries: dict, tmp_path, monkeypatch, capsys):
    write_plate(PART, tmp_path / "plate.obj", "obj")
    save_recipe(recipe(**entries), tmp_path)
    validate(recipe(**entries), tmp_path)
    monkeypatch.chdir(tmp_path)
    assert main(["run", "recipe.json", "-o", "out"]) == 2
    refused = capsys.readouterr().err
    assert main(["check", "recipe.json"]) == 2
    assert capsys.readouterr().err == refused
    assert [path.name for path in tmp_path.iterdir() if path.name == "out"] == []


def lid_mode(mode: int, **entries: object) -> dict:
    """Two plates with a mode of the second one."""
    return two_plates(parts=[{"name": "plate"}, {"name": "lid", "mode": mode}], **entries)


FREE = np.flatnonzero(plate(holes=2).points[:, 0] > 29.9).tolist()
FOLLOWER = [{"part": "lid", "vertices": FREE, "role": "follower"}]
SINGLE = {"type": "single"}
VAIN = [
    (two_plates(contacts=[], propagation=SINGLE, regions=FOLLOWER),
     'the followers on "lid" have no effect', "(mode 3)"),
    (lid_mode(1, contacts=[], propagation=SINGLE, regions=FOLLOWER, features=[]),
     'the followers on "lid" have no effect', "(mode 1)"),
    (lid_mode(3, contacts=with_type("tied")), 'mode 3 of "lid" has no effect', "tied contact"),
    (lid_mode(3, contacts=with_type("rigid")), 'mode 3 of "lid" has no effect', "rigid contact"),
    (lid_mode(1, contacts=with_type("rigid"), features=[]), 'mode 1 of "lid"', "rigid contact"),
    (two_plates(parts=[{"name": "plate", "mode": 2}, {"name": "lid"}]),
     'mode 2 of "plate" has no effect', "it is the primary part"),
    (lid_mode(2, contacts=[]), 'mode 2 of "lid" has no effect', "no contact drives the part"),
]  # fmt: skip


@pytest.mark.parametrize("case", VAIN, ids=[f"{c[1]}: {c[2]}" for c in VAIN])
def test_the_report_tells_what_has_no_effect(case: tuple):
    wanted, lead, reason = case
    notes = Session(wanted, meshes()).deform().report()["notes"]
    other = ("one rigid body", "no motion reaches")
    (note,) = [text for text in notes if not any(words in text for words in other)]
    assert note.startswith(lead) and reason in note


def test_settings_with_an_effect_get_no_note():
    assert Session(lid_mode(3), meshes()).deform().report()["notes"] == []
    followed = lid_mode(2, contacts=[], propagation=SINGLE, regions=FOLLOWER)
    assert Session(followed, meshes()).deform().report()["notes"] == []

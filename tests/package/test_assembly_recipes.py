# SPDX-License-Identifier: LGPL-2.1-or-later
"""Recipes of several parts: contacts, propagation, modes, followers, split files."""

from __future__ import annotations

import copy
import json
from pathlib import Path

import jsonschema
import numpy as np
import pytest

from plates import plate, recipe_of, save_recipe, write_plate
from sheetmorph import PartMesh, RecipeError, Session, read_part, run, validate
from sheetmorph.cli import main
from sheetmorph.reporting.report import report_schema

PART = plate(holes=2)
# The second plate lies 1 mm above the first one's right end; ids of vertices on both.
SHIFT = np.array([20.0, 0.0, 1.0])
LOWER_SIDE = np.flatnonzero(PART.points[:, 0] > 9.99).tolist()
UPPER_SIDE = np.flatnonzero(PART.points[:, 0] < 10.01).tolist()


def two_plates(**entries: object) -> dict:
    """A recipe of two plates, one over the other's end, with a contact."""
    recipe = recipe_of(PART, "plate.obj")
    recipe["parts"] = [{"name": "plate", "file": "plate.obj"}, {"name": "lid", "file": "lid.off"}]
    recipe["primary"] = "plate"
    recipe["features"] += [{"name": "eye", "part": "lid", "vertices": PART.rims[1]}]
    recipe["contacts"] = [
        {
            "name": "weld",
            "a": {"part": "plate", "vertices": LOWER_SIDE},
            "b": {"part": "lid", "vertices": UPPER_SIDE},
        }
    ]
    return {**recipe, **entries}


def meshes() -> dict[str, PartMesh]:
    """The two plates."""
    return {
        "plate": PartMesh(PART.points, PART.triangles),
        "lid": PartMesh(PART.points + SHIFT, PART.triangles),
    }


def with_type(kind: str) -> list[dict]:
    """The contact of two_plates() with another type."""
    return [{**two_plates()["contacts"][0], "type": kind}]


@pytest.fixture
def folder(tmp_path: Path) -> Path:
    """A folder with plate.obj, lid.off, both.obj (both in one file) and recipe.json."""
    write_plate(PART, tmp_path / "plate.obj", "obj")
    lid = plate(holes=2)
    lid.points = lid.points + SHIFT
    write_plate(lid, tmp_path / "lid.off", "off")
    both = plate(holes=2)
    both.points = np.concatenate([PART.points, lid.points])
    both.triangles = np.concatenate([PART.triangles, PART.triangles + len(PART.points)])
    write_plate(both, tmp_path / "both.obj", "obj")
    save_recipe(two_plates(), tmp_path)
    return tmp_path


@pytest.mark.parametrize("kind", ["control mesh", "tied", "rigid"])
def test_the_second_part_follows_and_its_contact_is_reported(kind: str):
    result = Session(two_plates(contacts=with_type(kind)), meshes()).deform()
    report = result.report()
    jsonschema.Draft202012Validator(report_schema()).validate(report)
    assert report["order"] == ["plate", "lid"] and report["unreached"] == []
    assert report["levels"] == {"plate": 0, "lid": 1}
    (contact,) = report["contacts"]
    assert (contact["source"], contact["target"], contact["type"]) == ("plate", "lid", kind)
    # Right beside a rigid side the sheet bends, which the other side's border sees.
    assert contact["gap_change"] < {"control mesh": 0.5, "tied": 0.5, "rigid": 0.05}[kind]
    assert (contact["deviation"] < 1e-9) == (kind == "rigid")
    assert report["certificate"]["passed"]
    assert np.abs(result.positions["lid"] - meshes()["lid"].points).max() > 5.0


def test_a_session_tells_how_motion_travels():
    session = Session(two_plates(), meshes())
    assert session.directions == [("weld", "plate", "lid")]
    assert session.levels == {"plate": 0, "lid": 1}


def test_one_control_mesh_around_everything_ignores_contacts_but_reports_them():
    result = Session(two_plates(propagation={"type": "single"}), meshes()).deform()
    assert [contact.name for contact in result.contacts] == ["weld"]
    assert result.report()["notes"] == [
        "the contacts are ignored: a single control mesh drives every part"
    ]
    vertices, triangles = result.control_mesh()
    assert vertices.shape[1] == triangles.shape[1] == 3
    assert triangles.max() == len(vertices) - 1


def test_the_control_mesh_of_a_contact_can_be_shown():
    result = Session(two_plates(propagation={"levels": 2}), meshes()).deform()
    vertices, _ = result.control_mesh("weld")
    finer, _ = Session(two_plates(), meshes()).deform().control_mesh("weld")
    assert len(vertices) < len(finer)
    assert result.control_mesh() is None
    with pytest.raises(ValueError, match='there is no contact "bolt"; names are weld'):
        result.control_mesh("bolt")


def test_without_contacts_the_second_part_stays():
    result = Session(two_plates(contacts=[]), meshes()).deform()
    assert result.session.unreached == ["lid"]
    assert np.array_equal(result.positions["lid"], meshes()["lid"].points)


def test_a_follower_is_driven_like_a_side_of_the_contact():
    free = np.flatnonzero(PART.points[:, 0] > 29.9).tolist()
    regions = [{"part": "lid", "vertices": free, "role": "follower"}]
    alone = Session(two_plates(), meshes()).deform().positions["lid"]
    followed = Session(two_plates(regions=regions), meshes()).deform().positions["lid"]
    assert np.abs(alone - followed).max() > 1e-6


def test_a_mode_that_cannot_be_is_a_fault_of_the_part():
    recipe = two_plates(parts=[{"name": "plate"}, {"name": "lid", "mode": 1}])
    with pytest.raises(RecipeError) as caught:
        Session(recipe, meshes())
    assert caught.value.faults[0].where == "part 'lid'"
    assert "mode 1" in caught.value.faults[0].what


def test_a_session_takes_over_what_did_not_change():
    first = Session(two_plates(), meshes())
    second = Session(two_plates(contacts=with_type("tied")), meshes(), previous=first)
    fresh = Session(two_plates(contacts=with_type("tied")), meshes())
    for name, positions in second.deform().positions.items():
        assert np.array_equal(positions, fresh.deform().positions[name])


def test_the_command_line_tells_how_contacts_were_kept(folder: Path, monkeypatch, capsys):
    monkeypatch.chdir(folder)
    assert main(["run", "recipe.json", "-o", "out"]) == 0
    assert "weld: plate drives lid, gap change" in capsys.readouterr().out
    assert sorted(path.name for path in (folder / "out").iterdir()) == ["lid.off", "plate.obj"]


def split_recipe(way: object) -> dict:
    """The two plates as components of one file; vertices have the file's ids."""
    recipe = two_plates(parts=[{"file": "both.obj", "split": way}], primary="both/1")
    text = json.dumps(recipe).replace('"plate"', '"both/1"').replace('"lid"', '"both/2"')
    recipe = json.loads(text)
    offset = len(PART.points)
    recipe["contacts"][0]["b"]["vertices"] = [i + offset for i in UPPER_SIDE]
    recipe["features"][-1]["vertices"] = [i + offset for i in PART.rims[1]]
    return recipe


@pytest.mark.parametrize("way", [True, "components"])
def test_a_file_with_two_components_gives_the_result_of_two_files(way: object, folder: Path):
    apart = run(folder / "recipe.json", folder / "apart")
    together = run(save_recipe(split_recipe(way), folder), folder / "together")
    assert [part["name"] for part in together["parts"]] == ["both/1", "both/2"]
    assert [part["file"]["name"] for part in together["parts"]] == ["both.obj", "both.obj"]
    written = read_part(folder / "together" / "both.obj").mesh.points
    pieces = ["plate.obj", "lid.off"]
    expected = [read_part(folder / "apart" / name).mesh.points for name in pieces]
    assert np.abs(written - np.concatenate(expected)).max() < 1e-9
    assert together["contacts"][0]["gap_change"] == pytest.approx(
        apart["contacts"][0]["gap_change"], abs=1e-9
    )


DECK = "BEGIN BULK\n" + "".join(
    f"GRID    {10 * k + j + 1:<16}{x:<8.1f}{y:<8.1f}{5.0 * k:<8.1f}\n"
    for k in range(2)
    for j, (x, y) in enumerate([(0, 0), (9, 0), (9, 9), (0, 9)])
)
DECK += "CQUAD4  1       7       1       2       3       4\n"
DECK += "CQUAD4  2       3       11      12      13      14\nENDDATA\n"


def test_a_deck_can_be_split_by_property(tmp_path: Path):
    (tmp_path / "deck.nas").write_text(DECK)
    recipe = {
        "sheetmorph": 1,
        "parts": [{"file": "deck.nas", "split": "property"}],
        "primary": "deck/7",
        "fixed": [{"part": "deck/7", "vertices": [1]}, {"part": "deck/3", "vertices": [11]}],
        "handles": [{"name": "tip", "part": "deck/7", "vertices": [3]}],
        "pose": {"tip": {"translation": [0, 0, 1.0]}},
    }
    report = run(save_recipe(recipe, tmp_path), tmp_path / "out")
    assert [part["name"] for part in report["parts"]] == ["deck/7", "deck/3"]
    assert report["unreached"] == ["deck/3"]
    points = read_part(tmp_path / "out" / "deck.nas").mesh.points
    assert points[2].tolist() == [9, 9, 1]
    assert points[4:, 2].tolist() == [5, 5, 5, 5]


def faults(recipe: dict, folder: Path) -> list[tuple[str, str]]:
    """(where, what) of every fault; every one says what to do."""
    with pytest.raises(RecipeError) as caught:
        validate(recipe, folder)
    assert all(fault.todo for fault in caught.value.faults)
    return [(fault.where, fault.what) for fault in caught.value.faults]


def changed_contact(**entries: object) -> dict:
    """two_plates() with entries of the contact exchanged."""
    recipe = copy.deepcopy(two_plates())
    recipe["contacts"][0] |= entries
    return recipe


MISTAKES = [
    (changed_contact(type="glued"), "contacts[0] (weld).type", '"glued" is not a type of contact'),
    (changed_contact(a={"part": "lid", "vertices": [0]}), "contacts[0] (weld)", "both sides are"),
    (changed_contact(b={"part": "lid", "vertices": []}), "contacts[0] (weld).b.vertices", "empty"),
    (changed_contact(b={"part": "lid", "vertices": [10**6]}), "contacts[0] (weld).b.vertices",
     "vertices 1000000 are not in part lid"),
    (changed_contact(b={"part": "cap", "vertices": [1]}), "contacts[0] (weld).b.part",
     'there is no part "cap"'),
    (two_plates(contacts=two_plates()["contacts"] * 2), "contacts[1] (weld)", "is already used"),
    (two_plates(propagation={"type": "far"}), "propagation.type", '"far" is not a type'),
    (two_plates(propagation={"levels": 9}), "propagation.levels", "9 is not valid"),
    (two_plates(propagation={"smoothness": 0}), "propagation.smoothness", "0 is not valid"),
    (two_plates(regions=[{"part": "lid", "vertices": [1]}]), "regions[0]", '"role" is missing'),
    (two_plates(parts=[{"name": "plate", "file": "plate.obj", "mode": 4},
                       {"name": "lid", "file": "lid.off"}]), "parts[0] (plate).mode",
     "4 is not a mode"),
]  # fmt: skip


@pytest.mark.parametrize("mistake", MISTAKES, ids=[f"{m[1]}: {m[2]}" for m in MISTAKES])
def test_a_mistake_in_an_assembly_is_named(mistake: tuple, folder: Path):
    recipe, where, what = mistake
    found = faults(recipe, folder)
    assert len(found) == 1
    assert found[0][0] == where and what in found[0][1]


def test_split_files_say_what_is_wrong_with_them(folder: Path):
    (folder / "deck.nas").write_text(DECK.replace("11      12", "11      2 "))
    named = split_recipe(True)
    named["parts"][0]["name"] = "both"
    assert faults(named, folder) == [
        ("parts[0] (both).name", 'parts of a split file are called "both/..."')
    ]
    assert ("parts[0].split", "only decks have properties") in faults(
        split_recipe("property"), folder
    )
    # A deck keeps common nodes together; another mesh made of it cannot.
    entry = {"file": "deck.nas", "split": "property", "weld": 1e-3}
    shared = {"sheetmorph": 1, "parts": [entry]}
    fixed = [{"part": "deck/7", "vertices": [1]}]
    assert faults({**shared, "fixed": fixed, "primary": "deck/7"}, folder) == [
        ("parts[0].split", "two properties share the vertices 2")
    ]


def test_an_unread_split_file_does_not_blame_the_regions_on_its_parts(folder: Path):
    (folder / "both.obj").write_text("v 0 0\n")
    found = faults(split_recipe(True), folder)
    assert len(found) == 1
    assert found[0][1] == "a vertex with 2 coordinates instead of 3"

# SPDX-License-Identifier: LGPL-2.1-or-later
"""`"auto"` in a recipe: what is found takes its place, runs, and stands in the report."""

from __future__ import annotations

import json
from pathlib import Path

import jsonschema
import pytest

import sheetmorph
from sheetmorph.reporting.report import report_schema

EXAMPLES = Path(__file__).resolve().parents[2] / "resources/examples"


def example(name: str, **changes: object) -> tuple[dict, dict[str, sheetmorph.PartMesh]]:
    """The recipe of an example with other values, and its meshes."""
    folder = EXAMPLES / name
    recipe = {**json.loads((folder / "recipe.json").read_text()), **changes}
    return recipe, {
        p["name"]: sheetmorph.read_part(folder / p["file"]).mesh for p in recipe["parts"]
    }


@pytest.mark.parametrize("name", ["door_mirror", "body_panels", "welded_frame"])
def test_a_bare_example_runs_on_what_is_found(name):
    recipe, meshes = example(name, features="auto", contacts="auto", propagation={"type": "local"})
    result = sheetmorph.Session(recipe, meshes).deform()
    report = result.report()
    jsonschema.validate(report, report_schema())
    assert report["certificate"]["passed"]
    assert report["unreached"] == []
    assert len(report["features"]) == len(report["found"]["features"]) > 10
    assert report["found"]["gap"] > 1.0
    kinds = {entry["kind"] for entry in report["found"]["features"]}
    assert kinds <= {"round hole", "slotted hole", "rectangular hole"}


def test_files_and_meshes_give_the_same(tmp_path):
    recipe, meshes = example("door_mirror", features="auto", contacts="auto")
    for part in recipe["parts"]:
        part["file"] = str(EXAMPLES / "door_mirror" / part["file"])
    path = tmp_path / "recipe.json"
    path.write_text(json.dumps(recipe))
    assert sheetmorph.check(path) == []
    report = sheetmorph.run(path, tmp_path / "out")
    assert report["found"] == sheetmorph.Session(recipe, meshes).deform().report()["found"]


def test_options_say_what_is_taken():
    options = {"kinds": ["round hole"], "parts": ["frame"], "smallest_radius": 5.0, "rings": 0}
    contacts = {"auto": {"type": "tied", "one_per_pair": True, "kinds": ["face", "flange"]}}
    recipe, meshes = example("door_mirror", features={"auto": options}, contacts=contacts)
    found = sheetmorph.Session(recipe, meshes).deform().report()["found"]
    assert found["features"] and {entry["part"] for entry in found["features"]} == {"frame"}
    assert min(entry["radius"] for entry in found["features"]) >= 5.0
    assert {entry["type"] for entry in found["contacts"]} == {"tied"}
    pairs = [(entry["a"]["part"], entry["b"]["part"]) for entry in found["contacts"]]
    assert len(pairs) == len(set(pairs)) > 0


def test_a_hole_that_two_regions_hold_is_left_out():
    recipe, meshes = example("door_mirror", features="auto", contacts=[])
    whole = sheetmorph.Session(recipe, meshes).deform().report()["found"]["features"]
    hole = next(entry for entry in whole if entry["part"] == "cover")
    rim = hole["rims"][0]
    recipe["fixed"].append({"name": "half", "part": "cover", "vertices": rim[: len(rim) // 2]})
    recipe["handles"].append({"name": "other", "part": "cover", "vertices": rim[len(rim) // 2 :]})
    found = sheetmorph.Session(recipe, meshes).deform().report()["found"]
    assert [text for text in found["left_out"] if text.startswith(f"{hole['name']}: two regions")]
    assert hole["name"] not in [entry["name"] for entry in found["features"]]


FAULTS = (
    ("features", "all", "give a list of form features"),
    ("features", {"auto": {"rigns": 1}}, 'did you mean "rings"?'),
    ("features", {"auto": {"kinds": ["hol"]}}, "a kind of features"),
    ("contacts", {"auto": {"gap": -1}}, "a length in mm, 0 or more"),
    ("contacts", {"automatic": {}}, 'did you mean "auto"?'),
)


@pytest.mark.parametrize("section, value, words", FAULTS)
def test_what_is_wrong_is_said(section, value, words):
    recipe, meshes = example("door_mirror", **{section: value})
    with pytest.raises(sheetmorph.RecipeError) as caught:
        sheetmorph.Session(recipe, meshes)
    assert words in str(caught.value) and str(caught.value).startswith(section)

# SPDX-License-Identifier: LGPL-2.1-or-later
"""Sets 01 and 02 with all their rivets, bushes and rigid elements: joints hold or are named."""

from __future__ import annotations

import json
from pathlib import Path

import pytest

from bent_decks import SHARED, recipe_of
from sheetmorph import run
from sheetmorph.certifying import certify, read_criteria
from sheetmorph.decks import read_deck, sheet_of

ROOT = Path(__file__).resolve().parents[2]
SUPPORT = SHARED.parent / "01-riveted-oxygen-bottle-support" / "W1000BOstat.dat"
WINGBOX = SHARED.parent / "02-wingbox-skin-and-spars" / "wingbox_stitched_together-000.bdf"


def support(folder: Path) -> Path:
    """The example in words, its deck where it lies."""
    example = ROOT / "resources" / "examples" / "in_words" / "riveted_support.json"
    entry = json.loads(example.read_text())
    entry["parts"] = [{**entry["parts"][0], "file": str(SUPPORT)}]
    place = folder / "recipe.json"
    place.write_text(json.dumps(entry))
    return place


def wingbox(folder: Path) -> Path:
    """The box bent by 5 % of its size; a joint that comes apart is an error."""
    deck = read_deck(WINGBOX)
    place = recipe_of(WINGBOX, deck, sheet_of(deck).nodes, folder)
    assert place is not None
    entry = json.loads(place.read_text())
    del entry["parts"][0]["joints"]
    place.write_text(json.dumps(entry))
    return place


TORN = [26994, 26995, 26999, 27500, 27501, 27502, 27503]


@pytest.mark.parametrize(("make", "count", "torn"), [(support, 385, TORN), (wingbox, 160, [])])
def test_all_joints_hold_on_the_files_read_again(tmp_path: Path, make, count: int, torn):
    if not (SUPPORT.is_file() and WINGBOX.is_file()):
        pytest.skip("sets 01 and 02 are not here")
    recipe = make(tmp_path)
    run(recipe, tmp_path / "out")
    proof = certify(recipe, tmp_path / "out", read_criteria("static"))
    (told,) = proof["decks"]
    joints = told["joints"]
    assert proof["passed"] and joints["count"] == count
    # Rigid bodies that join what the pose bends are torn, and named; everything else holds.
    assert [joint["id"] for joint in joints["broken"]] == torn
    assert all(joint["card"] == "RBE2" for joint in joints["broken"])
    for feature in proof["features"]:
        assert feature["edge_error"] <= feature["allowed"]
    print(f"NOTE {recipe.parent.name}: {count} joints, worst {joints['worst']}")

# SPDX-License-Identifier: LGPL-2.1-or-later
"""The sheet as steel: what a recipe says, what the report tells."""

from __future__ import annotations

import json

import jsonschema
import numpy as np
import pytest

import sheetmorph
from sheetmorph.base.errors import RecipeError
from sheetmorph.reporting.report import report_schema

from strips import LENGTH, WIDTH, flat_strip

ALONG, ACROSS = 24, 6


def recipe(**more) -> dict:
    """The strip rolled up by 90 degrees at the exact place of its end."""
    radius = LENGTH * 2.0 / np.pi
    ends = [list(range(ACROSS + 1)), list(range(ALONG * (ACROSS + 1), (ALONG + 1) * (ACROSS + 1)))]
    turn = {"axis": [0, -1, 0], "degrees": 90}
    found = {
        "sheetmorph": 1,
        "parts": [{"name": "strip", "file": "strip.obj", "thickness": 1.0}],
        "energy": "steel",
        "fixed": [{"part": "strip", "name": "wall", "vertices": ends[0]}],
        "handles": [{"part": "strip", "name": "tip", "vertices": ends[1]}],
        "pose": {"tip": {"translation": [radius - LENGTH, 0, radius], "rotation": turn}},
    }
    return {**found, **more}


def session(**more) -> sheetmorph.Session:
    points, triangles = flat_strip(ALONG, ACROSS)
    return sheetmorph.Session(recipe(**more), {"strip": sheetmorph.PartMesh(points, triangles)})


def test_a_strip_of_steel_rolls_up_without_stretch():
    points, _ = flat_strip(ALONG, ACROSS)
    result = session().deform()
    angle = points[:, 0] / LENGTH * np.pi / 2.0
    radius = LENGTH * 2.0 / np.pi
    exact = np.column_stack([radius * np.sin(angle), points[:, 1], radius * (1 - np.cos(angle))])
    assert np.linalg.norm(result.positions["strip"] - exact, axis=1).max() < 1e-3 * LENGTH
    report = result.report()
    jsonschema.validate(report, report_schema())
    (part,) = report["parts"]
    assert part["steel"] == {"thickness": 1.0, "from": "recipe", "poisson": 0.3}
    assert part["stretch"]["largest"] < 0.004
    assert part["stretch"]["share_above_1_percent"] == 0.0
    assert part["stretch"]["bend"]["radius"] == pytest.approx(radius, rel=0.2)
    assert part["unsettled"] is None
    (note,) = [note for note in report["notes"] if "of elastic energy" in note]
    assert note.startswith('"strip" bends most to a radius of 6')
    assert "times its thickness, at (" in note
    # E h^3 b / (24 (1 - nu^2)) times the angle squared over the length, without the sides' curl.
    stored = 210e3 * WIDTH / 24.0 * (np.pi / 2.0) ** 2 / LENGTH
    assert part["stretch"]["springs_back"] == pytest.approx(stored, rel=0.25)


def test_a_pose_that_stretches_is_told_in_words():
    result = session(pose={"tip": {"translation": [0, 0, 30]}}).deform()
    (part,) = result.report()["parts"]
    assert 0.03 < part["stretch"]["largest"] < 0.1
    assert 1 < len(part["stretch"]["worst"]) <= 10
    (note,) = [note for note in result.report()["notes"] if "stretches" in note]
    assert note.startswith('this pose stretches the sheet "strip" by ')
    assert "handle" in note or "fixed region" in note


def test_a_thickness_that_nobody_gave_is_a_hundredth_of_the_size_and_told():
    result = session(parts=[{"name": "strip", "file": "strip.obj"}]).deform()
    report = result.report()
    steel = report["parts"][0]["steel"]
    assert steel["from"] == "a hundredth of the size"
    assert steel["thickness"] == pytest.approx(np.hypot(LENGTH, WIDTH) / 100.0)
    assert any("a hundredth of its size" in note for note in report["notes"])


def test_shells_of_a_deck_are_as_thick_as_it_says_and_told():
    points, triangles = flat_strip(ALONG, ACROSS)
    mesh = sheetmorph.PartMesh(points, triangles, thickness=0.7)
    for told, expected in (({}, (0.7, "deck")), ({"thickness": 1.5}, (1.5, "recipe"))):
        part = {"name": "strip", "file": "strip.obj", **told}
        report = sheetmorph.Session(recipe(parts=[part]), {"strip": mesh}).deform().report()
        jsonschema.validate(report, report_schema())
        steel = report["parts"][0]["steel"]
        assert (steel["thickness"], steel["from"]) == expected


def test_live_frames_are_previews():
    morph = session()
    assert morph.deform(exact=False).previews == ("strip",)
    assert morph.deform().previews == ()


def test_progress_can_stop_it():
    with pytest.raises(RuntimeError, match="cancel"):
        session().deform(progress=lambda fraction, task: False)


@pytest.mark.parametrize("key, value", [("thickness", 0), ("thickness", -1.0), ("poisson", 0.5)])
def test_what_no_sheet_can_be_is_refused(key, value):
    with pytest.raises(RecipeError, match=key):
        session(parts=[{"name": "strip", "file": "strip.obj", key: value}])


def test_a_run_writes_the_strip_and_its_report(tmp_path):
    points, triangles = flat_strip(ALONG, ACROSS)
    lines = [f"v {x!r} {y!r} {z!r}" for x, y, z in points.tolist()]
    lines += ["f {} {} {}".format(*(row + 1)) for row in triangles]
    (tmp_path / "strip.obj").write_text("\n".join(lines) + "\n")
    (tmp_path / "recipe.json").write_text(json.dumps(recipe()))
    report = sheetmorph.run(tmp_path / "recipe.json", tmp_path / "out")
    assert report["energy"] == "steel"
    assert (tmp_path / "out" / "strip.obj").exists()

# SPDX-License-Identifier: LGPL-2.1-or-later
"""Elements of a morphed deck are repaired: nodes slide in the sheet, all else stays."""

from __future__ import annotations

import json
from pathlib import Path

import numpy as np
import pytest

from sheetmorph import FileError, RecipeError, _core, run
from sheetmorph.certifying.sliding import Sliding, borders_and_creases
from sheetmorph.cli import main
from sheetmorph.decks import read_deck

ALONG, ACROSS, SIZE = 25, 13, 5.0
HOLE = (60.0, 30.0)
CRITERIA = {"elements": {"min_angle": {"min": 54.0}, "skew": {"max": 37.0}, "aspect": {"max": 2.3}}}


def deck() -> str:
    """A strip of quads, a rigid element in its middle, sheared where it will be bent."""
    lines = ["BEGIN BULK", "PSHELL,1,1,1.2", "MAT1,1,210000.,,.3,7.85-9"]
    for i in range(ALONG):
        for j in range(ACROSS):
            x, y = SIZE * i, SIZE * j
            # A wave that is well within the limits at rest, and beyond once it is sheared.
            x += 1.1 * np.sin(0.25 * np.pi * j) * np.sin(np.pi * i / (ALONG - 1))
            lines.append(f"GRID*   {node(i, j):16d}{'':16}{x:16.8f}{y:16.8f}\n*{0.0:23.8f}")
    for i in range(ALONG - 1):
        for j in range(ACROSS - 1):
            ring = (node(i, j), node(i + 1, j), node(i + 1, j + 1), node(i, j + 1))
            lines.append(f"CQUAD4,{node(i, j)},1,{','.join(map(str, ring))}")
    lines += ["GRID,9001,,60.,20.,10.", f"RBE2,9000,9001,123456,{node(12, 3)},{node(12, 4)}"]
    return "\n".join([*lines, "ENDDATA", ""])


def node(i: int, j: int) -> int:
    return 1 + ACROSS * i + j


def sheared(folder: Path, **more) -> Path:
    """A recipe whose right end goes sideways and up, with a feature in the middle."""
    (folder / "strip.bdf").write_text(deck())
    (folder / "limits.json").write_text(json.dumps(CRITERIA))
    column = [[node(i, j) for j in range(ACROSS)] for i in range(ALONG)]
    feature = [node(i, j) for i in (11, 12, 13) for j in (7, 8, 9)]
    recipe = {
        "sheetmorph": 1,
        # The shear draws the nodes of the rigid element apart, which is not what is tested here.
        "parts": [{"name": "strip", "file": "strip.bdf", "joints": {"broken": "tell"}}],
        "fixed": [{"part": "strip", "vertices": column[0] + column[1]}],
        "handles": [{"name": "end", "part": "strip", "vertices": column[-1] + column[-2]}],
        "features": [{"name": "pad", "part": "strip", "vertices": feature}],
        "pose": {"end": {"translation": [0, 90, 30]}},
        **more,
    }
    (folder / "recipe.json").write_text(json.dumps(recipe))
    return folder / "recipe.json"


@pytest.fixture(scope="module")
def both(tmp_path_factory):
    """The reports of a run as it is and of a repaired one, and the folder of both."""
    folder = tmp_path_factory.mktemp("repair")
    recipe = sheared(folder)
    plain = run(recipe, folder / "plain")
    return plain, run(recipe, folder / "repaired", repair=str(folder / "limits.json")), folder


def points(folder: Path) -> np.ndarray:
    return read_deck(folder / "strip.bdf").points


def test_a_deck_whose_elements_fail_passes_once_they_are_repaired(both):
    _, report, folder = both
    (told,) = report["repairs"]
    assert told["failing_before"] > 15 and told["failing_after"] == 0, told
    assert 0 < told["farthest"] < 2 * SIZE and told["rounds"] > 0
    for name, status in (("plain", 3), ("repaired", 0)):
        limits = str(folder / "limits.json")
        found = main(
            ["certify", str(folder / "recipe.json"), str(folder / name), "--criteria", limits]
        )
        assert found == status


def test_features_contacts_and_joints_stay_to_the_bit(both):
    _, _, folder = both
    before, after = points(folder / "plain"), points(folder / "repaired")
    kept = [node(i, j) for i in (11, 12, 13) for j in (7, 8, 9)]
    kept += [node(12, 3), node(12, 4), 9001, *(node(i, 0) for i in range(ALONG))]
    rows = read_deck(folder / "strip.bdf").find(np.array(kept))
    assert np.array_equal(before[rows], after[rows])
    assert (before != after).any()


def test_nodes_stay_on_the_sheet(both):
    plain, report, folder = both
    before, after = points(folder / "plain"), points(folder / "repaired")
    moved = np.flatnonzero((before != after).any(axis=1))
    faces = np.array(
        [
            [node(i, j), node(i + 1, j), node(i + 1, j + 1), node(i, j + 1)]
            for i in range(ALONG - 1)
            for j in range(ACROSS - 1)
        ]
    )
    rows = read_deck(folder / "strip.bdf").find(faces)
    # Whichever way a quad is cut, its two pairs of triangles are this far apart.
    both_cuts = np.concatenate([rows[:, [0, 1, 2]], rows[:, [0, 2, 3]]]).astype(np.int32)
    tree = _core.PickingTree(np.ascontiguousarray(before), both_cuts)
    away = max(tree.nearest_point(place).distance for place in after[moved])
    assert 0.0 < away < 0.01 * SIZE
    assert report["repairs"][0]["off_sheet"] < 0.02 * SIZE
    assert plain["repairs"] == []


def test_a_recipe_says_it_too_and_a_miss_is_a_warning(tmp_path: Path):
    (tmp_path / "hard.json").write_text(json.dumps({"elements": {"min_angle": {"min": 89.0}}}))
    report = run(sheared(tmp_path, repair="hard.json"), tmp_path / "out")
    (told,) = report["repairs"]
    assert told["failing_after"] > 0 and told["criteria"] == "hard.json"
    assert any("still fail the criteria hard.json after repair" in w for w in report["warnings"])


def test_what_is_no_deck_and_unknown_criteria_are_refused_in_words(tmp_path: Path):
    with pytest.raises(FileError, match="name a file, or one of the sets"):
        run(sheared(tmp_path, repair="none.json"), tmp_path / "out")
    text = "v 0 0 0\nv 1 0 0\nv 1 1 0\nf 1 2 3\n"
    (tmp_path / "a.obj").write_text(text)
    recipe = {
        "sheetmorph": 1,
        "parts": [{"name": "a", "file": "a.obj"}],
        "fixed": [{"part": "a", "vertices": [0]}],
        "handles": [{"part": "a", "vertices": [1, 2]}],
        "repair": True,
    }
    (tmp_path / "b.json").write_text(json.dumps(recipe))
    with pytest.raises(RecipeError, match="no part of the recipe is a deck"):
        run(tmp_path / "b.json", tmp_path / "out")
    assert not (tmp_path / "out").exists()


def test_a_study_does_not_repair_and_says_so(tmp_path: Path, capsys):
    sheared(tmp_path, repair=True)
    study = {
        "sheetmorph_study": 1,
        "recipe": "recipe.json",
        "parameters": {"up": {"path": "pose.end.translation[2]", "range": [0, 5], "steps": 2}},
    }
    (tmp_path / "study.json").write_text(json.dumps(study))
    assert main(["study", str(tmp_path / "study.json"), "-o", str(tmp_path / "out")]) == 2
    assert "a study cannot repair elements" in capsys.readouterr().err


def test_borders_and_creases_stay():
    places = np.array([[0, 0, 0], [1, 0, 0], [2, 0, 1], [0, 1, 0], [1, 1, 0], [2, 1, 1]], float)
    faces = np.array([[0, 1, 4, 3], [1, 2, 5, 4]])
    assert borders_and_creases(places, faces, 30.0).all()
    grid = np.array([[x, y, 0] for x in range(3) for y in range(3)], float)
    quads = np.array([[k, k + 3, k + 4, k + 1] for k in (0, 1, 3, 4)])
    assert np.flatnonzero(~borders_and_creases(grid, quads, 30.0)).tolist() == [4]
    grid[[2, 5, 8], 2] = 1.0
    assert borders_and_creases(grid, quads, 30.0).all()


def test_an_inverted_element_is_turned_back():
    grid = np.array([[x, y, 0] for x in range(4) for y in range(4)], float)
    grid[5] = [2.2, 1.0, 0.0]
    quads = np.array([[k, k + 4, k + 5, k + 1] for k in (0, 1, 2, 4, 5, 6, 8, 9, 10)])
    cut = np.concatenate([quads[:, [0, 1, 2]], quads[:, [0, 2, 3]]]).astype(np.int32)
    stays = borders_and_creases(grid, quads, 30.0)
    limits = {"jacobian": {"min": 0.5}, "min_angle": {"min": 30.0}}
    slid = Sliding(grid, cut, quads, stays, limits).slid()
    assert slid.failing[0] > 0 and slid.failing[1] == 0
    assert np.array_equal(slid.places[stays], grid[stays])

# SPDX-License-Identifier: LGPL-2.1-or-later
"""A morph written in Python: the names of the recipe, short texts, the same results."""

from __future__ import annotations

import json
from pathlib import Path

import numpy as np
import pytest

import sheetmorph as sm
from plates import plate, write_plate
from sheetmorph.selecting.grammar import WITH

STRIP = plate(3, start=0.0)


@pytest.fixture
def morph(tmp_path: Path) -> sm.Morph:
    morph = sm.open(write_plate(STRIP, tmp_path / "strip.obj", "obj"))
    morph.fix(sm.half_space([-9, 0, 0], normal=[-1, 0, 0]))
    morph.handle(sm.half_space([49, 0, 0], [1, 0, 0]), "tip")
    morph.feature(sm.found("round hole", near=[20, 0, 0]), name="seat")
    return morph.move("tip", translation=[0, 0, 8], axis=[0, 1, 0], degrees=-10)


def test_ten_lines_do_what_the_recipe_they_save_does(morph: sm.Morph, tmp_path: Path):
    result = morph.deform()
    morph.save(tmp_path / "elsewhere.json")
    sm.run(tmp_path / "elsewhere.json", tmp_path / "out")
    written = sm.read_part(tmp_path / "out" / "strip.obj").mesh.points
    assert np.array_equal(written, result.positions["strip"])
    report = morph.write(tmp_path / "again")
    assert (tmp_path / "again/strip.obj").read_bytes() == (tmp_path / "out/strip.obj").read_bytes()
    assert [entry["name"] for entry in report["regions"]] == ["fixed0", "tip", "seat"]
    assert json.loads((tmp_path / "elsewhere.json").read_text())["parts"][0]["file"] == "strip.obj"


def test_every_selector_of_a_recipe_is_a_function_of_that_name():
    functions = {"all": sm.everything, "grow": sm.grow, "shrink": sm.shrink}
    for key in set(WITH) - {"drawn"}:  # only a view knows that
        assert callable(functions.get(key) or getattr(sm, key))
    assert sm.everything() == {"all": True}
    assert sm.grow(sm.rim_at([1, 2, 3], rings=1), length=5) == {
        "grow": {"length": 5.0},
        "of": {"rim_at": [1, 2, 3], "rings": 1},
    }
    a, b = sm.box(np.zeros(3), (1, 2, 3)), sm.group("lid")
    assert a | b == {"union": [a, b]} and a & b == {"intersection": [a, b]}
    assert a - b == {"minus": [{"box": [[0.0, 0.0, 0.0], [1, 2, 3]]}, {"group": "lid"}]}
    assert json.loads(json.dumps(a - b)) == a - b


def test_texts_are_short_and_say_what_there_is(morph: sm.Morph):
    texts = (repr(morph), repr(morph.session()), repr(morph.deform()), repr(morph.session().meshes))
    assert texts[0] == "<Morph of strip: 1 fixed region, 1 handle, 1 form feature>"
    assert all(len(text) < 120 for text in texts) and "moved by up to" in texts[2]
    assert repr(sm.face_at([1, 2.5, 3]) - sm.vertices(range(99))) == (
        "(face_at [1, 2.5, 3] minus vertices [99 ids])"
    )


def test_a_notebook_gets_a_picture_or_the_reason_why_not(morph: sm.Morph):
    for shown in (morph._repr_html_(), morph.deform()._repr_html_()):
        assert "data:image/png;base64," in shown or "python3-vtk" in shown
    morph.feature(sm.box([90, 0, 0], [91, 1, 1]))
    assert "selects nothing" in morph._repr_html_()


def test_mistakes_are_sentences(morph: sm.Morph, tmp_path: Path):
    with pytest.raises(sm.RecipeError, match="the file does not exist"):
        sm.open(tmp_path / "none.obj")
    with pytest.raises(sm.RecipeError, match="selects nothing"):
        morph.fix(sm.box([90, 0, 0], [91, 1, 1])).deform()
    write_plate(STRIP, tmp_path / "other.obj", "obj")
    two = sm.open(tmp_path / "strip.obj", tmp_path / "other.obj")
    with pytest.raises(sm.RecipeError, match="there are several parts"):
        two.fix(sm.everything())
    with pytest.raises(sm.RecipeError, match="found automatically"):
        two.find().feature(sm.everything(), part="strip")
    with pytest.raises(ValueError, match="either rings or a length"):
        sm.grow(sm.everything())

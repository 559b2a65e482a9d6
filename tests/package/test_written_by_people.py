# SPDX-License-Identifier: LGPL-2.1-or-later
"""Recipes as people write them: with comments, in TOML, with mistakes on a line."""

from __future__ import annotations

import json
import tomllib
from pathlib import Path

import jsonschema
import pytest
from hypothesis import given
from hypothesis import strategies as st

from plates import save_recipe
import sheetmorph
from sheetmorph.base.errors import FileError, RecipeError
from sheetmorph.certifying import read_criteria
from sheetmorph.cli import main
from sheetmorph.files.comments import plain_json
from sheetmorph.recipe.reading import read_json
from sheetmorph.recipe.writing import recipe_text
from sheetmorph.study.reading import read_study

VALUES = st.recursive(
    st.none() | st.booleans() | st.integers(-9, 9) | st.text('ab/*,"\\]}', max_size=6),
    lambda inner: st.lists(inner, max_size=3) | st.dictionaries(st.text("k/", max_size=3), inner),
    max_leaves=12,
)


@given(VALUES)
def test_comments_and_last_commas_change_nothing(value: object):
    text = json.dumps(value, indent=1)
    decorated = "// so: {\n" + text.replace("\n", " /* , ] */ // [\n") + "/* end\n */"
    assert json.loads(plain_json(decorated)) == value
    assert plain_json(text) == text


def test_a_comma_before_a_bracket_is_no_mistake(tmp_path: Path):
    path = tmp_path / "recipe.json"
    path.write_text('{"a": [1, 2, ], "b": ",]" , // last\n}')
    assert read_json(path) == {"a": [1, 2], "b": ",]"}


@pytest.mark.parametrize(
    ("text", "place"),
    [
        ('{\n  // note\n  "a": 1\n  "b": 2\n}', "line 4, column 3"),
        ('{"a": /* one\ntwo */ ]}', "line 2, column 8"),
        ('{"a": "//"\n', "line 2, column 1"),
    ],
)
def test_a_mistake_is_told_where_it_is_in_the_file(tmp_path: Path, text: str, place: str):
    path = tmp_path / "recipe.json"
    path.write_text(text)
    with pytest.raises(RecipeError, match=f"{place}: not JSON"):
        read_json(path)


@pytest.mark.parametrize(
    ("text", "place"), [("a = 1\nb = = 2\n", "line 2, column 5"), ("a = [1,\n", "line 2")]
)
def test_a_mistake_in_toml_is_told_where_it_is(tmp_path: Path, text: str, place: str):
    path = tmp_path / "recipe.toml"
    path.write_text(text)
    with pytest.raises(RecipeError, match=f"{place}: not TOML"):
        read_json(path)


def test_every_entry_that_is_wrong_has_its_line(folder: Path, capsys):
    Path("recipe.json").write_text(
        '{\n  // the plate\n  "sheetmorph": 1, "parts": [{"name": "plate", "file": "plate.obj"}],\n'
        '  "fixed": [{"part": "plate", "vertices": [0, 1]},\n'
        '            {"part": "plane", "vertices": [2]}],\n'
        '  "handles": [\n    {"name": "end", "part": "plate", "vertices": [5, 9999999]}],\n'
        '  "pose": {"end": {"translation": [0, 0, "1"]}}\n}\n'
    )
    assert main(["check", "recipe.json"]) == 2
    told = capsys.readouterr().err
    assert "recipe.json, line 8, column 42, pose.end.translation[2]" in told
    assert "recipe.json, line 5, column 14, fixed[1].part" in told
    assert "recipe.json, line 7, column 38, handles[0] (end).vertices" in told


def test_every_entry_of_a_recipe_in_toml_that_is_wrong_has_its_line(folder: Path, capsys):
    Path("recipe.toml").write_text(
        'sheetmorph = 1 # "parts" = [\nparts = [\n  {name = "plate", file = "plate.obj"},\n]\n'
        '[[fixed]]\npart = "plate"\nvertices = [0, 1]\n'
        "[[fixed]]\npart = 'plane'\nvertices = [2]\n"
        '[[handles]]\nname = "the [end]"\npart = "plate"\n'
        'where = {"union" = [{sphere = {center = [0, 0, 0], radius = -1.5}}]}\n'
        '[pose."the [end]"]\ntranslation = [0, 0, """1"""]\n'
    )
    assert main(["check", "recipe.toml"]) == 2
    told = capsys.readouterr().err
    assert "recipe.toml, line 9, column 1, fixed[1].part" in told
    assert "recipe.toml, line 14, column 52, handles[0] (the [end]).where.union[0].sphere" in told
    assert "recipe.toml, line 16, column 22, pose.the [end].translation[2]" in told


def test_a_key_that_stands_twice_is_told_where_it_is(tmp_path: Path):
    path = tmp_path / "recipe.json"
    path.write_text('{"a": {"b": 1},\n "c": [{"b": 1}, // b\n {"b": 1, "b": 2}]}')
    with pytest.raises(RecipeError, match='line 3, column 11: the key "b" appears twice'):
        read_json(path)


def test_nothing_that_was_edited_is_written_over(folder: Path, capsys):
    before = Path("recipe.json").read_text()
    assert main(["init", "plate.obj", "-o", "recipe.json"]) == 2
    assert "recipe.json already exists" in capsys.readouterr().err
    assert main(["show", "recipe.json", "-o", "recipe.json"]) == 2
    assert "use a name that ends in .png" in capsys.readouterr().err
    assert Path("recipe.json").read_text() == before


def test_a_recipe_in_toml_runs(folder: Path):
    recipe = json.loads(Path("recipe.json").read_text())
    lines = ["sheetmorph = 1"]
    for section in ("parts", "fixed", "handles", "features"):
        for entry in recipe.get(section, []):
            lines.append(f"[[{section}]]")
            lines += [f"{key} = {json.dumps(value)}" for key, value in entry.items()]
    lines += ["[pose.handle0]", "translation = [0, 0, 3]"]
    handle = recipe["handles"][0].get("name", "handle0")
    Path("recipe.toml").write_text("\n".join(lines).replace("pose.handle0", f'pose."{handle}"'))
    assert main(["run", "recipe.toml", "-o", "out"]) == 0
    assert (folder / "out" / "plate.obj").is_file()
    assert main(["run", "recipe.json", "-o", "."]) == 2  # both recipes read plate.obj


def test_schema_prints_what_editors_need(folder: Path, capsys):
    assert main(["schema"]) == 0
    found = json.loads(capsys.readouterr().out)
    assert found["$id"] and found["title"] and found["description"]
    for example in found["examples"]:
        jsonschema.validate(example, found)
    missing = [
        f"{name}.{key}"
        for name, entry in [("recipe", found), *found["$defs"].items()]
        for key, value in entry.get("properties", {}).items()
        if not {"description", "$ref", "const"} & value.keys()
    ]
    assert missing == []
    recipe = json.loads(Path("recipe.json").read_text())
    save_recipe({"$schema": "recipe.schema.json", **recipe}, folder)
    assert main(["check", "recipe.json"]) == 0


def test_every_recipe_is_read_and_written_in_toml_too(folder: Path):
    assert main(["resolve", "recipe.json", "-o", "ids.toml", "--quiet"]) == 0
    assert main(["resolve", "recipe.json", "-o", "ids.json", "--quiet"]) == 0
    assert read_json("ids.toml") == read_json("ids.json")
    morph = sheetmorph.open("plate.obj").fix([0]).handle([5], name="tip")
    morph.save("saved.toml")
    morph.save("saved.json")
    assert read_json("saved.toml") == read_json("saved.json") == morph.recipe
    assert Path("saved.toml").read_text().startswith("sheetmorph = 1\n")
    Path("ours.toml").write_text("[elements.min_angle]\nmin = 1.0\n")
    assert read_criteria("ours.toml").elements == {"min_angle": {"min": 1.0}}
    Path("bad.toml").write_text("elements = ")
    with pytest.raises(FileError, match="it is not TOML"):
        read_criteria("bad.toml")
    Path("study.toml").write_text(
        'sheetmorph_study = 1\nrecipe = "recipe.json"\n'
        "parameters = { lift = { values = [1, 2] } }\n"
    )
    assert read_study("study.toml").names == ["lift"]


@given(
    st.dictionaries(
        st.text(max_size=4), VALUES.filter(lambda value: "null" not in json.dumps(value))
    )
)
def test_what_is_written_is_read_back(recipe: dict):
    assert json.loads(recipe_text(recipe)) == recipe
    assert tomllib.loads(recipe_text(recipe, "a.toml")) == recipe

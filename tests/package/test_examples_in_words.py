# SPDX-License-Identifier: LGPL-2.1-or-later
"""The examples written by hand with selectors alone: short, and as with vertex ids."""

from __future__ import annotations

import json
import shutil
import sys
from pathlib import Path

import numpy as np
import pytest

from sheetmorph import Session
from sheetmorph.checking import prepare, with_ids
from sheetmorph.recipe.reading import read_json
from sheetmorph.morph.running import resolve

REPOSITORY = Path(__file__).resolve().parents[2]
EXAMPLES = REPOSITORY / "resources" / "examples"
sys.path.insert(0, str(REPOSITORY / "tests" / "real"))
NAMES = ("door_mirror", "welded_frame", "riveted_support")
DECK = "01-riveted-oxygen-bottle-support/W1000BOstat.dat"


def in_words(name: str, folder: Path) -> Path:
    """A recipe in words, in its place or, of the deck that is not ours, beside it in a folder."""
    path = EXAMPLES / "in_words" / f"{name}.json"
    if name != "riveted_support":
        return path
    recipes = pytest.importorskip("recipes")
    if recipes.data_folder() is None:
        pytest.skip(recipes.ABSENT)
    shutil.copy(path, folder)
    (folder / "W1000BOstat.dat").symlink_to(recipes.data_folder() / DECK)
    return folder / path.name


def result_of(recipe: dict, base: Path):
    """A recipe in its own pose."""
    parts = prepare(recipe, base)
    return Session(with_ids(parts), parts.meshes, told=parts.resolved.told).deform()


@pytest.mark.parametrize("name", NAMES)
def test_a_recipe_in_words_is_short_and_has_no_ids(name: str):
    text = (EXAMPLES / "in_words" / f"{name}.json").read_text("utf-8")
    assert len(text.splitlines()) < 60 and '"vertices"' not in text
    recipe = json.loads(text)
    sides = [contact[side] for contact in recipe.get("contacts", ()) for side in "ab"]
    entries = [*recipe["fixed"], *recipe["handles"], *sides]
    assert entries and all("where" in entry for entry in entries)


@pytest.mark.parametrize("name", NAMES)
def test_it_is_the_same_to_the_bit_with_the_ids_it_stands_for(name: str, tmp_path: Path):
    path = in_words(name, tmp_path)
    ids = resolve(path)
    assert "where" not in json.dumps(ids)
    words, numbers = (result_of(recipe, path.parent) for recipe in (read_json(path), ids))
    for part, positions in words.positions.items():
        assert np.array_equal(positions, numbers.positions[part]), part
    assert words.report()["warnings"] == [] and words.report()["certificate"]["passed"]


def worst_difference(words, ids) -> float:
    """The largest distance between two results, over the largest displacement."""
    pairs = [(words.positions[part], ids.positions[part]) for part in ids.positions]
    moved = [
        np.linalg.norm(ids.positions[part] - mesh.points, axis=1).max()
        for part, mesh in ids.session.meshes.items()
    ]
    return max(np.linalg.norm(a - b, axis=1).max() for a, b in pairs) / max(moved)


@pytest.mark.parametrize("name, share", [("door_mirror", 0.0), ("welded_frame", 0.012)])
def test_it_does_what_the_example_with_ids_does(name: str, share: float, tmp_path: Path):
    path = in_words(name, tmp_path)
    folder = EXAMPLES / name
    words = result_of(read_json(path), path.parent)
    ids = result_of(read_json(folder / "recipe.json"), folder)
    assert worst_difference(words, ids) <= share


def test_the_riveted_support_in_words_does_what_its_ids_do(tmp_path: Path):
    path = in_words("riveted_support", tmp_path)
    riveted_support, recipes = map(pytest.importorskip, ("riveted_support", "recipes"))
    recipe = riveted_support.support(recipes.data_folder())
    written = read_json(path)
    recipe["pose"] = written["pose"]
    recipe["handles"][0]["pivot"] = written["handles"][0]["pivot"]
    words, ids = result_of(written, path.parent), result_of(recipe, path.parent)
    assert worst_difference(words, ids) <= 0.001

# SPDX-License-Identifier: LGPL-2.1-or-later
"""`init` and `run` of a deck give the deck back."""
import re
from collections.abc import Callable
from pathlib import Path

import pytest
from conftest import sheetmorph

DECKS = ["strip.bdf", "main.k", "bracket.inp", "rolled_in_metres.inp"]
# A number, whole or real, as any of these formats writes it.
NUMBER = re.compile(rb"[ ]*[+-]?\d*\.?\d+(?:[eEdD]?[+-]?\d+)?\.?")


@pytest.mark.parametrize("name", DECKS)
def test_a_deck_comes_back_as_a_deck(case: Callable[[str], Path], name: str) -> None:
    folder = case("04")
    assert sheetmorph("init", name, "-o", "r.json", folder=folder).status == 0
    text = (folder / "r.json").read_text("utf-8")
    assert not re.search(r'"(weld|remesh|scale|thin)"', text)
    ended = sheetmorph("run", "r.json", "-o", "out", folder=folder)
    assert ended.status == 0, ended.said
    assert not list((folder / "out").rglob("*.obj"))
    before, after = (folder / name).read_bytes(), (folder / "out" / name).read_bytes()
    assert NUMBER.sub(b"", before) == NUMBER.sub(b"", after)
    assert before.count(b"\n") == after.count(b"\n")


def test_a_recipe_that_makes_a_mesh_of_a_deck_warns(case: Callable[[str], Path]) -> None:
    folder = case("04")
    sheetmorph("init", "strip.bdf", "-o", "r.json", folder=folder)
    text = (folder / "r.json").read_text("utf-8")
    changed = text.replace('"file": "strip.bdf"', '"file": "strip.bdf", "remesh": {"edge": 3}')
    (folder / "r.json").write_text(changed, "utf-8")
    ended = sheetmorph("run", "r.json", "-o", "out", folder=folder)
    assert 'the deck "strip.bdf" is written as OBJ' in ended.said
    strict = sheetmorph("run", "r.json", "-o", "out2", "--strict", folder=folder)
    assert strict.status == 3


def test_flatten_and_init_name_the_unit_of_a_deck_in_metres(case: Callable[[str], Path]) -> None:
    from sheetmorph.starting.doctor import diagnose_files

    folder = case("04")
    ended = sheetmorph("flatten", "rolled_in_metres.inp", folder=folder)
    assert ended.status == 0 and "0.314 x 0.200 m," in ended.out and "seems to be m" in ended.out
    (told,) = diagnose_files([folder / "rolled_in_metres.inp"])["files"]
    assert set(told["part"]) <= {"name", "file", "split"}

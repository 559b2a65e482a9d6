# SPDX-License-Identifier: LGPL-2.1-or-later
"""Welds of decks: CWELD is a weld, and each weld is counted once."""
import json
from collections.abc import Callable
from pathlib import Path

from conftest import sheetmorph


def test_elements_that_stand_between_sheets_are_welds(case: Callable[[str], Path]) -> None:
    found = json.loads(sheetmorph("find", "cweld.bdf", folder=case("21")).out)
    (contact,) = found["contacts"]
    assert contact["kind"] == "weld" and contact["connections"] == 3


def test_a_weld_is_counted_and_named_once(case: Callable[[str], Path]) -> None:
    folder = case("21")
    ended = sheetmorph("run", "c.json", "-o", "out", "--certify", folder=folder)
    assert ended.status == 0 and "3 joints" in ended.out
    recipe = json.loads((folder / "c.json").read_text())
    recipe["contacts"] = []
    recipe["parts"][0]["split"] = "property"
    (folder / "apart.json").write_text(json.dumps(recipe))
    apart = sheetmorph("run", "apart.json", "-o", "apart", folder=folder)
    assert apart.status == 3
    assert apart.said.count("line 1703") == 1

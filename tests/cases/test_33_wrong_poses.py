# SPDX-License-Identifier: LGPL-2.1-or-later
"""Wrong values below `poses`, and a huge whole number in a placement's axis."""
import json
from collections.abc import Callable
from pathlib import Path

import pytest
from conftest import sheetmorph

WRONG = [None, "x", 3, [], {}, [1, 2], {"open": None}, {"open": {"h": None}},
         {"open": {"h": {"translation": [0, 0]}}}, {"open": {"h": {"rotation": None}}},
         {"open": {"h": {"translation": [0, 0, 10**400]}}}, {"open": "closed"}]  # fmt: skip


def test_the_fault_has_its_line(case: Callable[[str], Path]) -> None:
    done = sheetmorph("check", "poses.json", folder=case("33"))
    assert done.status == 2
    assert "line 1, column" in done.err and "poses.open.h.translation[2]" in done.err


def test_a_huge_axis_is_a_direction(case: Callable[[str], Path]) -> None:
    done = sheetmorph("check", "axis.json", folder=case("33"))
    assert done.status == 0, done.said


@pytest.mark.parametrize("value", WRONG, ids=repr)
def test_no_wrong_value_below_poses_is_a_mistake_of_the_program(
    value: object, case: Callable[[str], Path]
) -> None:
    folder = case("33")
    recipe = json.loads((folder / "poses.json").read_text())
    recipe["poses"] = value
    (folder / "wrong.json").write_text(json.dumps(recipe))
    done = sheetmorph("check", "wrong.json", folder=folder)
    assert done.status == (0 if value == {} else 2), done.said
    assert "has a bug" not in done.err

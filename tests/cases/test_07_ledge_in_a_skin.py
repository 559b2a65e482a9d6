# SPDX-License-Identifier: LGPL-2.1-or-later
"""A ledge of 0.0001 mm in the skin of a sheet."""
import json
from collections.abc import Callable
from pathlib import Path

import pytest
from conftest import sheetmorph

AREAS = {"ledge.step": 128.642 * 40.0, "veneer.step": 101_486.0}


def area(path: Path) -> float:
    """The area of a flat OBJ mesh."""
    lines = [line.split() for line in path.read_text("utf-8").splitlines()]
    points = [tuple(map(float, words[1:3])) for words in lines if words[:1] == ["v"]]
    total = 0.0
    for words in lines:
        if words[:1] == ["f"]:
            a, b, c = (points[int(word) - 1] for word in words[1:4])
            total += 0.5 * abs((b[0] - a[0]) * (c[1] - a[1]) - (c[0] - a[0]) * (b[1] - a[1]))
    return total


@pytest.mark.parametrize("file", AREAS)
def test_the_sheet_is_thin(case: Callable[[str], Path], file: str) -> None:
    folder = case("07")
    told = json.loads(sheetmorph("doctor", file, folder=folder).out)["files"][0]
    assert told["kind"] == "thin solid"
    assert told["thickness"] == pytest.approx(0.8, abs=2e-3)


@pytest.mark.parametrize("file", AREAS)
def test_a_blank_has_its_whole_area_or_is_refused(case: Callable[[str], Path], file: str) -> None:
    folder = case("07")
    done = sheetmorph("flatten", file, "-o", "out", folder=folder)
    if done.status == 0:
        (blank,) = (folder / "out").glob("*.obj")
        assert area(blank) == pytest.approx(AREAS[file], rel=0.01)
    else:
        assert "cannot be flattened" in done.said

# SPDX-License-Identifier: LGPL-2.1-or-later
"""A wall that ends beside another one, nearer than the sheet is thick."""
import json
from collections.abc import Callable
from pathlib import Path

import pytest
from conftest import sheetmorph


def test_the_thickness_is_that_of_the_sheet_and_not_of_the_gap(case: Callable[[str], Path]) -> None:
    folder = case("05")
    told = json.loads(sheetmorph("doctor", "corner_gap_0_5.step", folder=folder).out)
    assert told["files"][0]["thickness"] == pytest.approx(1.5, abs=1e-3)
    recipe = {
        "sheetmorph": 1,
        "parts": [{"name": "corner", "file": "corner_gap_0_5.step", "mesh": {"edge": 4}}],
        "fixed": [
            {"part": "corner", "where": {"half_space": {"point": [0, 0, 2], "normal": [0, 0, -1]}}}
        ],
        "handles": [
            {
                "name": "wall",
                "part": "corner",
                "where": {"box": [[-9, 5, 14], [0, 99, 99]]},
            }
        ],
        "pose": {"wall": {"translation": [-2, 0, 0]}},
    }
    (folder / "pull.json").write_text(json.dumps(recipe), "utf-8")
    done = sheetmorph("run", "pull.json", "-o", "out", "--report", "report.json", folder=folder)
    assert done.status == 0, done.said
    thin = json.loads((folder / "report.json").read_text("utf-8"))["parts"][0]["thin"]
    assert thin["thickness"] == pytest.approx(1.5, abs=1e-3)
    assert thin["rest"]["least"] == pytest.approx(1.5, rel=0.05)
    assert thin["rest"]["most"] == pytest.approx(1.5, rel=0.05)
    assert max(thin["largest_change"], thin["largest_change_at_walls"]) < 0.1

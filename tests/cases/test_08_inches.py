# SPDX-License-Identifier: LGPL-2.1-or-later
"""A bracket written in inches is not taken for one in metres."""
import json
from collections.abc import Callable
from pathlib import Path

from conftest import sheetmorph


def test_inches_are_named_and_no_scale_of_metres_is_written(case: Callable[[str], Path]) -> None:
    folder = case("08")
    done = sheetmorph("doctor", "bracket_in_inches.stl", folder=folder)
    (found,) = json.loads(done.out)["files"]
    assert "inch" in found["unit"]["plausible"] and "m" not in found["unit"]["plausible"]
    (unit,) = [one["text"] for one in found["findings"] if one["finding"] == "unit"]
    assert "inch" in unit
    assert found["part"].get("scale", 25.4) == 25.4
    made = sheetmorph("init", "bracket_in_inches.stl", folder=folder)
    assert made.status == 0 and "inch" in made.out and '"scale": 1000' not in made.out

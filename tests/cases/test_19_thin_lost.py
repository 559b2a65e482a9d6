# SPDX-License-Identifier: LGPL-2.1-or-later
"""A sheet with brackets lapped onto it: every command must have one answer to how thick it is."""
import json
from collections.abc import Callable
from pathlib import Path

import pytest
from conftest import sheetmorph


def test_doctor_init_and_run_agree_on_the_thickness(case: Callable[[str], Path]) -> None:
    folder = case("19")
    told = json.loads(sheetmorph("doctor", "default_fender.stl", folder=folder).out)["files"][0]
    assert told["kind"] == "thin solid"
    assert told["thickness"] * told["unit"]["scale"] == pytest.approx(1.5875, abs=1e-3)
    started = sheetmorph("init", "default_fender.stl", "-o", "recipe.json", folder=folder)
    assert started.status == 0, started.said
    assert '"thin": "auto"' in (folder / "recipe.json").read_text("utf-8")
    done = sheetmorph("run", "recipe.json", "-o", "out", "--report", "report.json", folder=folder)
    assert done.status == 0, done.said
    thin = json.loads((folder / "report.json").read_text("utf-8"))["parts"][0]["thin"]
    assert thin["thickness"] == pytest.approx(1.5875, rel=0.01)

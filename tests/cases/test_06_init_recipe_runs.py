# SPDX-License-Identifier: LGPL-2.1-or-later
"""A rib along a plate joins the ends that `init` would hold and move."""
from collections.abc import Callable
from pathlib import Path

from conftest import sheetmorph


def test_the_recipe_of_a_plate_with_a_rib_runs_unchanged(case: Callable[[str], Path]) -> None:
    folder = case("06")
    written = sheetmorph("init", "plate_with_rib.step", "-o", "r.json", folder=folder)
    assert written.status == 0, written.said
    ran = sheetmorph("run", "r.json", "-o", "out", folder=folder)
    assert ran.status == 0, ran.said

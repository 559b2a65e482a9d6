# SPDX-License-Identifier: LGPL-2.1-or-later
"""A clean STL with a few slivers in its bend keeps its mesh."""
import tomllib
from collections.abc import Callable
from pathlib import Path

from conftest import sheetmorph


def test_a_few_slivers_are_no_reason_to_remesh(case: Callable[[str], Path]) -> None:
    folder = case("22")
    written = sheetmorph("init", "bracket.stl", "-o", "r.toml", folder=folder)
    assert written.status == 0, written.said
    recipe = tomllib.loads((folder / "r.toml").read_text())
    assert recipe["parts"] == [{"name": "bracket", "file": "bracket.stl"}]
    assert "folds" not in (folder / "r.toml").read_text()
    ran = sheetmorph("run", "r.toml", "-o", "out", folder=folder)
    assert ran.status == 0, ran.said
    assert (folder / "out" / "bracket.stl").is_file()

# SPDX-License-Identifier: LGPL-2.1-or-later
"""Recipes with thousands of entries."""
import subprocess
import sys
from collections.abc import Callable
from pathlib import Path

import pytest
from conftest import sheetmorph


@pytest.fixture
def folder(case: Callable[[str], Path]) -> Path:
    found = case("37")
    subprocess.run([sys.executable, "make.py"], cwd=found, check=True)
    return found


def test_a_list_of_faults_ends(folder: Path) -> None:
    for name in ("faults50000.json", "ids50000.json"):
        done = sheetmorph("check", name, "--quiet", folder=folder)
        lines = done.err.splitlines()
        assert done.status == 2 and len(lines) == 21
        assert lines[-1] == "and 49,980 more"


def test_four_thousand_features_on_one_place_are_read(folder: Path) -> None:
    assert sheetmorph("check", "features4000.json", folder=folder).status == 0

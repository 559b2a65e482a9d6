# SPDX-License-Identifier: LGPL-2.1-or-later
"""CalculiX takes a morphed deck, and finds in it what it finds in the same shape made directly."""

from __future__ import annotations

import re
import shutil
import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest

from sheetmorph import run
from sheetmorph.decks import read_deck

EXAMPLES = Path(__file__).resolve().parents[2] / "resources" / "examples"
sys.path.append(str(EXAMPLES))

from shapes import bracket  # noqa: E402

COUNT = 6


def frequencies(path: Path) -> list[float]:
    """What CalculiX finds, Hz."""
    command = ["ccx", path.stem]
    done = subprocess.run(command, cwd=path.parent, capture_output=True, text=True, timeout=120)
    assert done.returncode == 0 and "*ERROR" not in done.stdout, done.stdout[-2000:]
    text = path.with_suffix(".dat").read_text()
    rows = re.findall(r"^\s+\d+\s+\S+\s+\S+\s+(\S+)\s+\S+\s*$", text, re.MULTILINE)
    return [float(value) for value in rows[:COUNT]]


@pytest.fixture(scope="module")
def morphed(tmp_path_factory) -> Path:
    """The example's deck after its recipe."""
    out = tmp_path_factory.mktemp("bracket")
    run(EXAMPLES / "bracket" / "recipe.json", out)
    return out / "bracket.inp"


def test_the_hole_is_where_the_recipe_wants_it_and_still_round(morphed: Path):
    rest = read_deck(EXAMPLES / "bracket" / "bracket.inp").points
    moved = read_deck(morphed).points
    up, aside = bracket.SHIFT
    middle = np.array([bracket.WIDTH, 0.0, bracket.WEB + 0.5 * bracket.WIDTH])
    rim = np.abs(np.linalg.norm(rest - middle, axis=1) - bracket.HOLE) < 1e-6
    away = np.linalg.norm(moved[rim] - middle - [0.0, aside, up], axis=1)
    assert np.abs(away - bracket.HOLE).max() < 1e-6
    np.testing.assert_array_equal(moved[:, 0], rest[:, 0])


@pytest.mark.skipif(shutil.which("ccx") is None, reason="CalculiX (ccx) is not installed")
def test_a_morphed_deck_has_the_frequencies_of_its_shape(morphed: Path, tmp_path: Path):
    """The shape made directly has a mesh of its own; no morph is in it."""
    (tmp_path / "direct.inp").write_text(bracket.deck(10, 8, bracket.SHIFT))
    (tmp_path / "rest.inp").write_bytes((EXAMPLES / "bracket" / "bracket.inp").read_bytes())
    found = frequencies(morphed)
    direct, rest = (frequencies(tmp_path / name) for name in ("direct.inp", "rest.inp"))
    assert len(found) == len(direct) == COUNT
    assert found == pytest.approx(direct, rel=0.006)
    changes = [abs(one / other - 1.0) for one, other in zip(found, rest)]
    assert sum(change > 0.01 for change in changes) >= 3

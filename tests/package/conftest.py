# SPDX-License-Identifier: LGPL-2.1-or-later
"""Fixtures of the package's tests: part files in a folder of their own."""

from __future__ import annotations

import signal
from pathlib import Path

import pytest
from hypothesis import HealthCheck, settings

from part_samples import samples
from plates import plate, recipe_of, save_recipe, write_plate

# What is drawn is not timed, however loaded the machine is, and leaves no file behind.
settings.register_profile(
    "sheetmorph", database=None, deadline=None, suppress_health_check=[HealthCheck.too_slow]
)
settings.load_profile("sheetmorph")


@pytest.fixture(scope="session", autouse=True)
def can_be_interrupted() -> None:
    """What a shell script starts in the background is deaf to Ctrl+C, with all that it starts in
    turn: the tests' own commands, too, which are sent it."""
    signal.signal(signal.SIGINT, signal.default_int_handler)


@pytest.fixture(params=sorted(samples()))
def sample(request: pytest.FixtureRequest, tmp_path: Path) -> Path:
    """A part file of each kind, in its own folder."""
    path = tmp_path / request.param
    path.write_bytes(samples()[request.param])
    return path


@pytest.fixture
def folder(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """A folder with plate.obj and recipe.json; the working folder of the test."""
    part = plate()
    write_plate(part, tmp_path / "plate.obj", "obj")
    save_recipe(recipe_of(part, "plate.obj"), tmp_path)
    monkeypatch.chdir(tmp_path)
    return tmp_path

# SPDX-License-Identifier: LGPL-2.1-or-later
"""A file that was not read whole is a warning of the run, not a note deep in the report."""

from __future__ import annotations

import json
from pathlib import Path

import numpy as np
import pytest

from plates import plate, write_plate
from sheetmorph.cli import main


@pytest.mark.parametrize(("short", "strictly"), [(0, 0), (2, 3)])
def test_a_file_that_ends_early_is_a_warning(short: int, strictly: int, tmp_path: Path, capsys):
    made = plate()
    path = write_plate(made, tmp_path / "plate.stl", "binary.stl")
    path.write_bytes(path.read_bytes()[: -short or None])
    ends = {
        "left": np.asarray(made.points)[:, 0].min(),
        "right": np.asarray(made.points)[:, 0].max(),
    }
    where = {
        name: {"half_space": {"point": [x, 0, 0], "normal": [1 if name == "right" else -1, 0, 0]}}
        for name, x in (("left", ends["left"] + 0.5), ("right", ends["right"] - 0.5))
    }
    recipe = {
        "sheetmorph": 1,
        "parts": [{"name": "plate", "file": "plate.stl"}],
        "fixed": [{"part": "plate", "where": where["left"]}],
        "handles": [{"name": "tip", "part": "plate", "where": where["right"]}],
        "pose": {"tip": {"translation": [0, 0, 2]}},
    }
    (tmp_path / "recipe.json").write_text(json.dumps(recipe))
    for command in ("check", "run"):
        ways = ["--strict", "--quiet"] + (["-o", str(tmp_path / "out")] if command == "run" else [])
        assert main([command, str(tmp_path / "recipe.json"), *ways]) == strictly
        told = capsys.readouterr()
        assert ("plate.stl: 2 bytes are missing" in told.out + told.err) == bool(short)

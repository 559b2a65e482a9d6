# SPDX-License-Identifier: LGPL-2.1-or-later
"""Pipes where files are read: those without a writer are told, the others are read."""
import os
import subprocess
import sys
from collections.abc import Callable
from pathlib import Path

import pytest
from conftest import sheetmorph


@pytest.mark.parametrize(
    ("pipe", "line"),
    [
        ("rf.json", "check rf.json"),
        ("p.json", "run r.json -o out --pose p.json"),
        ("so/range.json", "study study.json -o so --quiet"),
        ("so/.lock", "study study.json -o so --quiet"),
        ("so/.lock", "study study.json -o so --quiet --runs 0-1"),
    ],
)
def test_it_does_not_wait_for_ever(pipe: str, line: str, case: Callable[[str], Path]) -> None:
    folder = case("39")
    (folder / "so").mkdir()
    os.mkfifo(folder / pipe)
    done = sheetmorph(*line.split(), folder=folder, seconds=60.0)
    # A range is a help, not an input: a study goes on without one.
    assert done.status == (0 if pipe == "so/range.json" else 2), done.said
    if done.status:
        assert Path(pipe).name in done.err and "pipe" in done.err


def test_a_recipe_may_come_through_a_pipe(case: Callable[[str], Path]) -> None:
    folder = case("39")
    line = f"{sys.executable} -m sheetmorph check /dev/stdin --quiet"
    recipe = (folder / "r.json").read_text().replace('"a.obj"', f'"{folder / "a.obj"}"')
    done = subprocess.run(
        line.split(), cwd=folder, input=recipe, text=True, capture_output=True, timeout=60
    )
    assert done.returncode == 0, done.stderr

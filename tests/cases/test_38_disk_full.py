# SPDX-License-Identifier: LGPL-2.1-or-later
"""A disk that is full: the words name the file that cannot be written."""
import os
import resource
import subprocess
import sys
from collections.abc import Callable
from pathlib import Path

import pytest

COMMANDS = {
    "run": (["run", "r.json", "-o", "full"], "full/a.obj"),
    "report": (["run", "r.json", "-o", "full", "--report", "full/x.json"], "full/"),
    "find": (["find", "a.obj", "-o", "f.json"], "f.json"),
    "init": (["init", "a.obj", "-o", "new.json"], "new.json"),
    "study": (["study", "study.json", "-o", "so"], "so"),
}


def _nothing_fits() -> None:
    resource.setrlimit(resource.RLIMIT_FSIZE, (0, 0))


@pytest.mark.parametrize("name", COMMANDS)
def test_the_words_name_the_file(name: str, case: Callable[[str], Path]) -> None:
    folder = case("38")
    before = sorted(folder.rglob("*"))
    command, file = COMMANDS[name]
    done = subprocess.run(
        [sys.executable, "-m", "sheetmorph", *command], cwd=folder, capture_output=True, text=True,
        timeout=120, preexec_fn=_nothing_fits, env={**os.environ, "PYTHONDONTWRITEBYTECODE": "1"},
    )  # fmt: skip
    assert done.returncode == 2, done.stderr
    (told,) = [line for line in done.stderr.splitlines() if "too large" in line.lower()]
    assert file in told and ".tmp" not in told
    left = [path for path in sorted(folder.rglob("*")) if path.is_file() and path.name != ".lock"]
    assert left == [path for path in before if path.is_file()]


@pytest.mark.skipif(os.geteuid() == 0, reason="the superuser may write anywhere")
def test_a_folder_that_cannot_be_written(case: Callable[[str], Path]) -> None:
    folder = case("38")
    (folder / "ro").mkdir(mode=0o555)
    command = [sys.executable, "-m", "sheetmorph", "find", "a.obj", "-o", "ro/f.json"]
    done = subprocess.run(command, cwd=folder, capture_output=True, text=True, timeout=120)
    assert done.returncode == 2 and "ro/f.json: Permission denied" in done.stderr

# SPDX-License-Identifier: LGPL-2.1-or-later
"""Inputs on which SheetMorph once failed: one test file for each folder of ../shared/data/10-cases.

The folders are beside the project, on the machines of its authors and of CI only; elsewhere these
tests are skipped.
"""
import os
import shutil
import stat
import subprocess
import sys
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path

import pytest

CASES = Path(__file__).resolve().parents[3] / "shared" / "data" / "10-cases"


@dataclass(frozen=True)
class Ended:
    """How a command ended: its exit status and what it printed."""

    status: int
    out: str
    err: str

    @property
    def said(self) -> str:
        """Everything it printed."""
        return self.out + self.err


def sheetmorph(*arguments: object, folder: Path, seconds: float = 120.0) -> Ended:
    """Run `python3 -m sheetmorph` with these arguments in a folder."""
    done = subprocess.run(
        [sys.executable, "-m", "sheetmorph", *map(str, arguments)],
        cwd=folder,
        capture_output=True,
        text=True,
        errors="replace",
        timeout=seconds,
        env={**os.environ, "PYTHONDONTWRITEBYTECODE": "1"},
    )
    assert "Traceback" not in done.stderr, done.stderr
    return Ended(done.returncode, done.stdout, done.stderr)


@pytest.fixture
def case(tmp_path: Path) -> Callable[[str], Path]:
    """Copy one folder of the cases, by its number ("31"), and return the copy."""

    def copied(number: str) -> Path:
        if not CASES.is_dir():
            pytest.skip("the inputs of ../shared/data/10-cases are not on this machine")
        (folder,) = CASES.glob(f"{number}-*")
        copy = Path(shutil.copytree(folder, tmp_path / folder.name))
        for path in (copy, *copy.rglob("*")):
            path.chmod(path.stat().st_mode | stat.S_IWUSR)  # the inputs may not be written
        return copy

    return copied

# SPDX-License-Identifier: LGPL-2.1-or-later
"""Blocks of runs and the commands that compute them, for batch systems."""

from __future__ import annotations

import shlex
import sys
from dataclasses import dataclass
from pathlib import Path

from ...files.atomic import FileSet

_PACKAGE = Path(__file__).resolve().parents[2]


@dataclass(frozen=True)
class Call:
    """A study for other processes that see the same files."""

    study: Path
    out: Path
    runs: int

    def blocks(self, most: int) -> list[tuple[int, int]]:
        """Return the first and last run of blocks of equal size, at most `most`."""
        count = max(1, min(most, self.runs))
        edges = [k * self.runs // count for k in range(count + 1)]
        return [(first, after - 1) for first, after in zip(edges, edges[1:])]

    def command(self, *options: str) -> str:
        """Return the shell command that computes the study, or some of its runs."""
        words = [sys.executable, "-m", "sheetmorph", "study", str(self.study.resolve())]
        words += ["-o", str(self.out.resolve()), "--quiet"]
        return " ".join([f"PYTHONPATH={shlex.quote(path())}", *map(shlex.quote, words), *options])


def path() -> str:
    """Return the folder for PYTHONPATH."""
    return str(_PACKAGE.parent)


def write_script(place: Path, text: str) -> None:
    """Write a script, complete or not at all."""
    with FileSet(is_own=True) as files:
        files.temporary_for(place).write_text(text, "utf-8")
        files.commit()

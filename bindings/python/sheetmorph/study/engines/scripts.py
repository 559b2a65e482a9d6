# SPDX-License-Identifier: LGPL-2.1-or-later
"""What a batch system needs to compute a study: blocks of runs, and how to call them."""

from __future__ import annotations

import shlex
import sys
from dataclasses import dataclass
from pathlib import Path

from ...files.atomic import FileSet

_PACKAGE = Path(__file__).resolve().parents[2]


@dataclass(frozen=True)
class Call:
    """A study to be computed by other processes, which see the same files."""

    study: Path
    out: Path
    runs: int

    def blocks(self, most: int) -> list[tuple[int, int]]:
        """The first and last run of at most so many blocks of even size."""
        count = max(1, min(most, self.runs))
        edges = [k * self.runs // count for k in range(count + 1)]
        return [(first, after - 1) for first, after in zip(edges, edges[1:])]

    def command(self, *options: str) -> str:
        """The shell's line that computes the study, or some of its runs."""
        words = [sys.executable, "-m", "sheetmorph", "study", str(self.study.resolve())]
        words += ["-o", str(self.out.resolve()), "--quiet"]
        return " ".join([f"PYTHONPATH={shlex.quote(path())}", *map(shlex.quote, words), *options])


def path() -> str:
    """Where Python finds this package."""
    return str(_PACKAGE.parent)


def write_script(place: Path, text: str) -> None:
    """Write a script, whole or not at all."""
    with FileSet(is_own=True) as files:
        files.temporary_for(place).write_text(text, "utf-8")
        files.commit()

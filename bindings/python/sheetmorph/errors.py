# SPDX-License-Identifier: LGPL-2.1-or-later
"""What goes wrong, said for the person who has to put it right: where, what, what to do."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path


@dataclass(frozen=True)
class Fault:
    """One mistake: where it is, what is wrong, what to do about it."""

    where: str
    what: str
    todo: str

    def __str__(self) -> str:
        text = f"{self.where}: {self.what}; {self.todo}"
        line = " ".join(text.split())
        # Names can hold what a terminal must not get, and halves of surrogate pairs.
        return "".join(c if c.isprintable() else c.encode("unicode_escape").decode() for c in line)


# More mistakes than that are counted, not listed.
_MOST_LINES = 20


class RecipeError(ValueError):
    """A recipe that cannot be run; ``faults`` lists every mistake found. The text has a line for
    each of the first 20, and how many more there are."""

    def __init__(self, faults: Sequence[Fault]):
        self.faults = list(faults)
        lines = [str(fault) for fault in self.faults[:_MOST_LINES]]
        more = len(self.faults) - _MOST_LINES
        super().__init__("\n".join([*lines, *([f"and {more:,} more"] if more > 0 else [])]))


class FileError(ValueError):
    """A mesh file that cannot be read or written.

    ``path``; ``line`` (from 1, None where it has no meaning); ``what``; ``todo``.
    """

    def __init__(self, path: str | Path, what: str, todo: str, line: int | None = None):
        self.path = Path(path)
        self.line = line
        self.what = what
        self.todo = todo
        super().__init__(str(self.fault()))

    def fault(self, where: str = "") -> Fault:
        """The same as a Fault; ``where`` is put before the file name."""
        place = str(self.path) + (f", line {self.line}" if self.line else "")
        return Fault(f"{where}, {place}" if where else place, self.what, self.todo)


class KernelError(RuntimeError):
    """The compiled kernel ``sheetmorph._core`` is missing, broken or of another version."""


class OccupiedError(FileError):
    """A file that SheetMorph did not write stands where it would write one."""

    def __init__(self, path: str | Path):
        what = "it is there already, and SheetMorph did not write it as it is now"
        super().__init__(path, what, "name another place, remove it, or add --force (force=True)")


def list_ids(ids: Sequence[int], shown: int = 8) -> str:
    """ "3, 7, 12 and 5 more": the first ids of a list, for messages."""
    text = ", ".join(str(int(i)) for i in list(ids)[:shown])
    return text + (f" and {len(ids) - shown} more" if len(ids) > shown else "")

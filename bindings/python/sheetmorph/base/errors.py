# SPDX-License-Identifier: LGPL-2.1-or-later
"""Errors and warnings for the user: where it is wrong, what is wrong, what to do."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from pathlib import Path
from typing import NamedTuple


class Subject(NamedTuple):
    """A recipe entry that a message is about.

    Parameters
    ----------
    kind : str
        "part", "fixed region", "handle", "feature", "point", "follower", "contact", "group" or
        "pair"; "region" stands for any kind of region, because region names are unique.
    name : str
        Name of the entry.
    """

    kind: str
    name: str


OTHER = "other"
"""Code of a fault without a specific cure."""


@dataclass(frozen=True)
class Fault:
    """One fault of the input: where it is, what is wrong, and what to do.

    Parameters
    ----------
    where, what, todo : str
        Place, problem and remedy.
    code : str
        "unheld" (a piece of a part has no prescribed vertices), "overlap" (two regions share
        vertices), "torn" (a rigid shape touches regions that move differently) or "other".
    objects : tuple of Subject
        The recipe entries at fault.
    vertices : tuple of int
        Vertices at fault, as numbered in the file of the part.
    brief : str
        The problem without vertex numbers.
    """

    where: str
    what: str
    todo: str
    code: str = OTHER
    objects: tuple[Subject, ...] = ()
    vertices: tuple[int, ...] = ()
    brief: str = ""

    def about(self, *objects: Subject) -> Fault:
        """Return a copy with other entries at fault."""
        return replace(self, objects=objects)

    def in_brief(self) -> str:
        """Return the sentence without vertex numbers, for a panel."""
        place = f"{self.where}: " if self.where else ""
        todo = f"; {self.todo}" if self.todo else ""
        return self._line(f"{place}{self.brief or self.what}{todo}")

    def __str__(self) -> str:
        return self._line(f"{self.where}: {self.what}; {self.todo}")

    @staticmethod
    def _line(text: str) -> str:
        line = " ".join(text.split())
        # Names can contain control characters that a terminal must not receive, and lone
        # surrogates.
        return "".join(c if c.isprintable() else c.encode("unicode_escape").decode() for c in line)


class Caution(str):
    """A warning: one sentence with the entries that it is about and the kind of warning.

    Parameters
    ----------
    text : str
        The sentence.
    *objects : Subject
        The recipe entries that the warning is about.
    code : str
        Kind of the warning.
    """

    objects: tuple[Subject, ...]
    code: str

    def __new__(cls, text: str, *objects: Subject, code: str = OTHER) -> Caution:
        found = super().__new__(cls, text)
        found.objects, found.code = objects, code
        return found

    def __getnewargs_ex__(self) -> tuple[tuple[str | Subject, ...], dict[str, str]]:
        return (str(self), *self.objects), {"code": self.code}

    def after(self, lead: str) -> Caution:
        """Return a copy with a text in front of the sentence."""
        return Caution(f"{lead}{self}", *self.objects, code=self.code)


# Further faults are counted, not listed.
_MOST_LINES = 20


class RecipeError(ValueError):
    """A recipe that SheetMorph cannot run; ``faults`` lists every fault found.

    The text has one line for each of the first 20 faults, and the number of the others.

    Parameters
    ----------
    faults : sequence of Fault
        All faults of the recipe.
    """

    def __init__(self, faults: Sequence[Fault]):
        self.faults = list(faults)
        lines = [str(fault) for fault in self.faults[:_MOST_LINES]]
        more = len(self.faults) - _MOST_LINES
        super().__init__("\n".join([*lines, *([f"and {more:,} more"] if more > 0 else [])]))


class FileError(ValueError):
    """A file that SheetMorph cannot read or write.

    Parameters
    ----------
    path : str or Path
        The file.
    what, todo : str
        Problem and remedy.
    line : int, optional
        Line of the file, counted from 1; None if it has no lines.
    """

    def __init__(self, path: str | Path, what: str, todo: str, line: int | None = None):
        self.path = Path(path)
        self.line = line
        self.what = what
        self.todo = todo
        super().__init__(str(self.fault()))

    def fault(self, where: str = "") -> Fault:
        """Return the error as a Fault; ``where`` is put before the file name."""
        place = str(self.path) + (f", line {self.line}" if self.line else "")
        return Fault(f"{where}, {place}" if where else place, self.what, self.todo)


class InputError(ValueError):
    """An input that SheetMorph cannot use.

    Parameters
    ----------
    what, todo : str
        Problem and remedy.
    """

    def __init__(self, what: str, todo: str):
        self.what, self.todo = what, todo
        super().__init__(f"{what}; {todo}")


def fault_of(error: Exception, todo: str, where: str = "recipe") -> Fault:
    """Convert an error of the kernel or of this package to a Fault.

    The arguments todo and where are used if the error does not provide them.
    """
    if isinstance(error, RecipeError):
        return error.faults[0]
    if isinstance(error, FileError):
        return error.fault()
    return Fault(
        getattr(error, "where", "") or where,
        getattr(error, "what", "") or " ".join(str(error).split()),
        getattr(error, "todo", "") or todo,
        getattr(error, "code", OTHER),
        tuple(Subject(*pair) for pair in getattr(error, "objects", ())),
        tuple(getattr(error, "vertices", ())),
        getattr(error, "brief", ""),
    )


class KernelError(RuntimeError):
    """The compiled kernel ``sheetmorph._core`` is missing, broken or incompatible."""


class OccupiedError(FileError):
    """The output path has a file that SheetMorph did not write.

    Parameters
    ----------
    path : str or Path
        The existing file.
    """

    def __init__(self, path: str | Path):
        what = "it already exists, and SheetMorph did not write its current content"
        super().__init__(path, what, "choose another name, remove it, or add --force (force=True)")


def list_ids(ids: Sequence[int], shown: int = 8) -> str:
    """Return the first ids of a list for a message, such as "3, 7, 12 and 5 more"."""
    text = ", ".join(str(int(i)) for i in list(ids)[:shown])
    return text + (f" and {len(ids) - shown} more" if len(ids) > shown else "")

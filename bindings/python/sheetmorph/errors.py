# SPDX-License-Identifier: LGPL-2.1-or-later
"""What goes wrong, said for the person who has to put it right: where, what, what to do."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from pathlib import Path
from typing import NamedTuple


class Subject(NamedTuple):
    """An entry of a recipe that a message is about.

    kind: "part", "fixed region", "handle", "feature", "point", "follower", "contact", "group" or
    "pair"; "region" for one of the regions, whose names differ whatever their kind is.
    """

    kind: str
    name: str


OTHER = "other"
"""The code of a fault that has no cure of its own."""


@dataclass(frozen=True)
class Fault:
    """One mistake: where it is, what is wrong, what to do about it.

    code: "unheld" (nothing holds a piece of a part), "overlap" (two regions share vertices), "torn"
    (a rigid shape touches regions that move differently) or "other"; objects: the entries at fault;
    vertices: those that it lists, as the part's file numbers them; brief: `what` without them.
    """

    where: str
    what: str
    todo: str
    code: str = OTHER
    objects: tuple[Subject, ...] = ()
    vertices: tuple[int, ...] = ()
    brief: str = ""

    def about(self, *objects: Subject) -> Fault:
        """The same with the entries at fault."""
        return replace(self, objects=objects)

    def in_brief(self) -> str:
        """The sentence without the numbers of vertices, for a panel."""
        place = f"{self.where}: " if self.where else ""
        todo = f"; {self.todo}" if self.todo else ""
        return self._line(f"{place}{self.brief or self.what}{todo}")

    def __str__(self) -> str:
        return self._line(f"{self.where}: {self.what}; {self.todo}")

    @staticmethod
    def _line(text: str) -> str:
        line = " ".join(text.split())
        # Names can hold what a terminal must not get, and halves of surrogate pairs.
        return "".join(c if c.isprintable() else c.encode("unicode_escape").decode() for c in line)


class Caution(str):
    """A warning: one sentence that knows which entries it is about (``objects``) and, by its
    ``code``, what kind of warning it is."""

    objects: tuple[Subject, ...]
    code: str

    def __new__(cls, text: str, *objects: Subject, code: str = OTHER) -> Caution:
        found = super().__new__(cls, text)
        found.objects, found.code = objects, code
        return found

    def __getnewargs_ex__(self) -> tuple[tuple[str | Subject, ...], dict[str, str]]:
        return (str(self), *self.objects), {"code": self.code}

    def after(self, lead: str) -> Caution:
        """The same with words in front."""
        return Caution(f"{lead}{self}", *self.objects, code=self.code)


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


class InputError(ValueError):
    """Something given that cannot be used: ``what`` is wrong, and what ``todo`` about it."""

    def __init__(self, what: str, todo: str):
        self.what, self.todo = what, todo
        super().__init__(f"{what}; {todo}")


def fault_of(error: Exception, todo: str, where: str = "recipe") -> Fault:
    """The fault that an error of the kernel or of this package stands for.

    todo, where: for errors that do not say what to do, or where.
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

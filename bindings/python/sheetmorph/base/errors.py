# SPDX-License-Identifier: LGPL-2.1-or-later
"""Errors and warnings for the user: where it is wrong, what is wrong, what to do."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any, NamedTuple


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
        vertices), "torn" (a rigid shape touches regions that move differently), the kind of a
        warning, or "other".
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
        return self._sentence(self.brief or self.what)

    def to_json(self) -> dict[str, Any]:
        """Return the fault as an object of JSON."""
        return {
            **{"code": self.code, "where": self.where, "what": self.what, "todo": self.todo},
            "objects": [subject._asdict() for subject in self.objects],
            "vertices": list(self.vertices),
        }

    def __str__(self) -> str:
        return self._sentence(self.what)

    def _sentence(self, what: str) -> str:
        place = f"{self.where}: " if self.where else ""
        line = " ".join(f"{place}{what}{f'; {self.todo}' if self.todo else ''}".split())
        # Names can contain control characters that a terminal must not receive, and lone
        # surrogates.
        return "".join(c if c.isprintable() else c.encode("unicode_escape").decode() for c in line)


class Caution(str):
    """A warning: a sentence that carries its Fault.

    Parameters
    ----------
    text : str
        The problem.
    *objects : Subject
        The recipe entries that the warning is about.
    code : str
        Kind of the warning.
    todo : str
        Remedy, which ends the sentence.
    where : str
        Place, which begins the sentence.
    """

    fault: Fault

    def __new__(
        cls, text: str, *objects: Subject, code: str = OTHER, todo: str = "", where: str = ""
    ) -> Caution:
        found = super().__new__(cls, ": ".join(part for part in (where, text, todo) if part))
        found.fault = Fault(where, text, todo, code, objects)
        return found

    @property
    def objects(self) -> tuple[Subject, ...]:
        """The recipe entries that the warning is about."""
        return self.fault.objects

    @property
    def code(self) -> str:
        """Kind of the warning."""
        return self.fault.code

    def __getnewargs_ex__(self) -> tuple[tuple[str | Subject, ...], dict[str, str]]:
        fault = self.fault
        named = {"code": fault.code, "todo": fault.todo, "where": fault.where}
        return (fault.what, *fault.objects), named

    def after(self, lead: str) -> Caution:
        """Return a copy with a text in front of the sentence."""
        fault = self.fault
        return Caution(f"{lead}{fault.what}", *fault.objects, code=fault.code, todo=fault.todo)

    def within(self, place: str) -> Caution:
        """Return a copy with a place in front of its own; an empty one changes nothing."""
        fault = self.fault
        where = ": ".join(part for part in (place, fault.where) if part)
        return Caution(fault.what, *fault.objects, code=fault.code, todo=fault.todo, where=where)


# Further faults are counted, not listed.
_MOST_LINES = 20


def _restored(kind: type[SheetMorphError], texts: tuple[str, ...]) -> SheetMorphError:
    """Return an error without its faults, which pickle adds."""
    return kind.__new__(kind, *texts)


class SheetMorphError(Exception):
    """The base of all errors of SheetMorph, with their faults.

    The fields of the first fault (where, what, todo, code, objects, vertices) are attributes of
    the error. The text has one line for each of the first 20 faults, and the number of the others.

    Parameters
    ----------
    faults : sequence of Fault
        All faults.
    text : str, optional
        Another text.
    """

    def __init__(self, faults: Sequence[Fault], text: str | None = None):
        self.faults: Sequence[Fault] = list(faults)
        lines = [str(fault) for fault in self.faults[:_MOST_LINES]]
        more = len(self.faults) - _MOST_LINES
        lines += [f"and {more:,} more"] if more > 0 else []
        super().__init__("\n".join(lines) if text is None else text)

    def __reduce__(self) -> tuple[Any, ...]:
        # Workers of a study send their errors, whatever arguments the class takes.
        return _restored, (type(self), self.args), self.__dict__

    def __getattr__(self, name: str) -> Any:
        if name in Fault.__dataclass_fields__ and self.faults:
            return getattr(self.faults[0], name)
        raise AttributeError(name)


class RecipeError(SheetMorphError, ValueError):
    """A recipe that SheetMorph cannot run; ``faults`` lists every fault found.

    Parameters
    ----------
    faults : sequence of Fault
        All faults of the recipe.
    """


class FileError(SheetMorphError, ValueError):
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
        where = str(self.path) + (f", line {line}" if line else "")
        super().__init__([Fault(where, what, todo)])

    @classmethod
    def of(cls, path: str | Path, error: Exception, todo: str = "") -> FileError:
        """Return an error of work on a file as an error of the file; todo is a default remedy."""
        if isinstance(error, OSError):
            what = f"cannot be read ({error.strerror or error})"
            return cls(path, what, todo or "check the path and its rights")
        inner = fault_of(error, todo, "")
        found = cls(path, inner.what, inner.todo, getattr(error, "line", None))
        found.faults = [replace(inner, where=found.where)]
        return found

    def fault(self, where: str = "") -> Fault:
        """Return the error as a Fault; ``where`` is put before the file name."""
        found = self.faults[0]
        return replace(found, where=f"{where}, {found.where}") if where else found


class _OneFault(SheetMorphError):
    """An error with one fault: problem, remedy and place."""

    def __init__(self, what: str, todo: str = "", where: str = ""):
        super().__init__([Fault(where, what, todo)])


class InputError(_OneFault, ValueError):
    """An input that SheetMorph cannot use."""


class FailedError(_OneFault, RuntimeError):
    """Work that fails although its input is valid."""


class KernelError(FailedError):
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


def fault_of(error: Exception, todo: str, where: str = "recipe") -> Fault:
    """Convert an error to a Fault; todo and where are used if the error does not provide them."""
    if not isinstance(error, SheetMorphError):
        return Fault(where, " ".join(str(error).split()), todo)
    first = error.faults[0]
    return replace(first, where=first.where or where, todo=first.todo or todo)


def reason_of(error: Exception) -> str:
    """Return an error as one line, with all its faults."""
    faults = getattr(error, "faults", None) or [fault_of(error, "", "")]
    return "; ".join(map(str, faults))


def list_ids(ids: Sequence[int], shown: int = 8) -> str:
    """Return the first ids of a list for a message, such as "3, 7, 12 and 5 more"."""
    text = ", ".join(str(int(i)) for i in list(ids)[:shown])
    return text + (f" and {len(ids) - shown} more" if len(ids) > shown else "")

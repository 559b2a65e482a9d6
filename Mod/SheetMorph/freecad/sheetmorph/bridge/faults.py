# SPDX-License-Identifier: LGPL-2.1-or-later
"""Conversion of errors of kernel, package or document to faults of document objects."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from contextlib import contextmanager

from freecad.sheetmorph.bridge import kernel
from freecad.sheetmorph.kinds import ASSEMBLY, kind
from freecad.sheetmorph.objects import model
from freecad.sheetmorph.objects.errors import Fault, MorphError

FAILURES = (ValueError, RuntimeError, OSError)
"""The errors of a computation: input, solver, and files."""

Names = Mapping[tuple[str, str], str]
"""Document object names by recipe list ("part", "region", ...) and name in it."""

LISTS = {"part": "part", "contact": "contact", "group": "relation", "pair": "relation"}
"""Recipe list of each kind of subject; all other kinds are regions."""


def fault_of(error: Exception | str, names: Names | None = None) -> Fault:
    """Return the fault of an error, without vertex numbers.

    `names` are those of the objects in the error. Of several faults it is the first, with the
    number of the others.
    """
    if isinstance(error, str):
        return error if isinstance(error, Fault) else Fault(error)
    if isinstance(error, MorphError):
        return error.fault
    several = getattr(error, "faults", ())
    if not several:
        sentence = " ".join(str(error).split())
        return Fault(sentence or f"{type(error).__name__} without a message.")
    first = several[0]
    more = f" (and {len(several) - 1} more)" if len(several) > 1 else ""
    return Fault(f"{first.in_brief()}{more}", *objects_in(first, names or {}), code=first.code)


def warning_of(caution, names: Names) -> Fault:
    """Return a warning of a result with its document objects."""
    return Fault(str(caution), *objects_in(caution, names), code=caution.code)


def objects_in(message, names: Names) -> list[str]:
    """Return the object names of a fault or a warning of the package."""
    keys = [(LISTS.get(subject.kind, "region"), subject.name) for subject in message.objects]
    return list(dict.fromkeys(names[key] for key in keys if key in names))


@contextmanager
def as_morph_errors() -> Iterator[None]:
    """Convert the errors of a computation in this context to MorphErrors."""
    try:
        yield
    except FAILURES as error:
        raise MorphError(fault_of(error)) from error


@contextmanager
def named(names: Names) -> Iterator[None]:
    """Convert errors of the package in this context to MorphErrors with document objects."""
    try:
        yield
    except (ValueError, RuntimeError) as error:
        if not getattr(error, "faults", ()) or isinstance(error, kernel.core().Cancelled):
            raise
        raise MorphError(fault_of(error, names)) from error


def faults_in(document) -> dict[str, Fault]:
    """Return the faults of the last recompute by object name of the assembly."""
    morphs = [obj for obj in document.Objects if kind(obj) == ASSEMBLY]
    found = {morph.Name: model.failure_of(morph) for morph in morphs}
    return {name: fault for name, fault in found.items() if fault}


def at_fault(assembly, fault: str) -> list:
    """Return the parts, regions, contacts and relations of an assembly in a fault."""
    found = map(assembly.Document.getObject, getattr(fault, "objects", ()))
    return [obj for obj in found if obj is not None and obj in assembly.Group]


def new_fault(document, before: Mapping[str, Fault]) -> Fault | None:
    """Return a new fault of a morph that was valid `before`, if objects are at fault.

    Without such objects the morph is only incomplete, and an incomplete step is admissible.
    """
    for name, fault in faults_in(document).items():
        if name not in before and has_blame(document.getObject(name), fault):
            return fault
    return None


def has_blame(assembly, fault: str) -> bool:
    """Return whether a fault concerns regions, contacts or relations, which a step can revert."""
    return any(kind(obj) != model.PART for obj in at_fault(assembly, fault))

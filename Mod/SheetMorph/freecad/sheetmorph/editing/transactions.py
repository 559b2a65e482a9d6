# SPDX-License-Identifier: LGPL-2.1-or-later
"""The undo steps of a document; only this module opens and closes them.

`Document.commitTransaction` and `abortTransaction` do nothing while a step is empty. The step would
stay open and include the next change. The close function of the application has no such
restriction.

While a step is open, the active document and every document that changes join it. The step is then
committed, undone and redone in all of them. A longer step is therefore closed for the application
and continues in its own document only.
"""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager

import FreeCAD

from freecad.sheetmorph.kinds import ASSEMBLY, kind

NOBODYS = -1
"""The number that belongs to no step."""


def begin(document, title: str) -> int:
    """Open an undo step and return its number, after finishing any open step."""
    keep()
    document.openTransaction(title)
    return FreeCAD.getActiveTransaction()[1]


def begin_alone(document, title: str) -> int:
    """Open an undo step that no other document joins, and return its number.

    The document must have a morph.
    """
    with _active(document):
        number = begin(document, title)
        for morph in [obj for obj in document.Objects if kind(obj) == ASSEMBLY][:1]:
            # This assignment changes nothing, but starts the document's step.
            morph.Order = morph.Order
        if document.HasPendingTransaction:
            FreeCAD.closeActiveTransaction(False, NOBODYS)
    return number


def keep(number: int = 0) -> None:
    """Finish a step, by default the open one; a step without changes leaves no entry."""
    FreeCAD.closeActiveTransaction(False, number)


def take_back(number: int = 0) -> None:
    """Undo the changes of a step, by default the open one, and close it."""
    FreeCAD.closeActiveTransaction(True, number)


@contextmanager
def step(document, title: str) -> Iterator[None]:
    """Make one undo step, and undo all of it after an error."""
    begin(document, title)
    try:
        yield
    except BaseException:
        take_back()
        raise
    keep()


@contextmanager
def trial(document, title: str) -> Iterator[None]:
    """Change the document temporarily, and undo everything at the end."""
    with _active(document):
        begin(document, title)
        try:
            yield
        finally:
            take_back()


def forget_redos(document) -> None:
    """Discard the redo steps, which FreeCAD does at the first change of a new step."""
    if document.RedoCount:
        with trial(document, ""):
            document.addObject("App::FeaturePython", "Nothing")


@contextmanager
def _active(document) -> Iterator[None]:
    """Make a document the active one temporarily."""
    before = FreeCAD.ActiveDocument
    FreeCAD.setActiveDocument(document.Name)
    try:
        yield
    finally:
        if before is not None and before != document:
            FreeCAD.setActiveDocument(before.Name)

# SPDX-License-Identifier: LGPL-2.1-or-later
"""The undo steps of a document; nothing else opens or closes one.

`Document.commitTransaction` and `abortTransaction` do nothing while a step is empty: it would stay
open and take in whatever changes next. The program's own close does not mind.

While a step is open every document that changes joins it, and the active one besides; it is
committed, taken back, undone and redone in all of them. So a step that is not over at once is one
that the program does not count as open any more: the document that has begun it goes on with it.
"""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager

import FreeCAD

from freecad.sheetmorph.kinds import ASSEMBLY, kind

NOBODYS = -1
"""The number of no step."""


def begin(document, title: str) -> int:
    """Open an undo step and return its number; one that somebody left open is finished."""
    keep()
    document.openTransaction(title)
    return FreeCAD.getActiveTransaction()[1]


def begin_alone(document, title: str) -> int:
    """Open an undo step that no other document joins and return its number; the document has a
    morph."""
    with _active(document):
        number = begin(document, title)
        for morph in [obj for obj in document.Objects if kind(obj) == ASSEMBLY][:1]:
            morph.Order = morph.Order  # no change, but the step of the document begins with it
        if document.HasPendingTransaction:
            FreeCAD.closeActiveTransaction(False, NOBODYS)
    return number


def keep(number: int = 0) -> None:
    """Finish a step, by default the one that is open; none is left by one that changed nothing."""
    FreeCAD.closeActiveTransaction(False, number)


def take_back(number: int = 0) -> None:
    """Undo what a step, by default the open one, has changed, and close it."""
    FreeCAD.closeActiveTransaction(True, number)


@contextmanager
def step(document, title: str) -> Iterator[None]:
    """Do one undo step; an error takes all of it back."""
    begin(document, title)
    try:
        yield
    except BaseException:
        take_back()
        raise
    keep()


@contextmanager
def trial(document, title: str) -> Iterator[None]:
    """Change the document for a moment: everything is taken back."""
    with _active(document):
        begin(document, title)
        try:
            yield
        finally:
            take_back()


def forget_redos(document) -> None:
    """Leave nothing to be redone: FreeCAD forgets it with the first change of a new step."""
    if document.RedoCount:
        with trial(document, ""):
            document.addObject("App::FeaturePython", "Nothing")


@contextmanager
def _active(document) -> Iterator[None]:
    """Make a document the active one for a moment."""
    before = FreeCAD.ActiveDocument
    FreeCAD.setActiveDocument(document.Name)
    try:
        yield
    finally:
        if before is not None and before != document:
            FreeCAD.setActiveDocument(before.Name)

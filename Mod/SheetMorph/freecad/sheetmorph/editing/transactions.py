# SPDX-License-Identifier: LGPL-2.1-or-later
"""The undo steps of a document; nothing else opens or closes one.

`Document.commitTransaction` and `abortTransaction` do nothing while a step is empty: it would stay
open and take in whatever changes next. The program's own close does not mind.
"""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager

import FreeCAD


def begin(document, title: str) -> int:
    """Open an undo step and return its number; one that somebody left open is finished."""
    keep()
    document.openTransaction(title)
    return FreeCAD.getActiveTransaction()[1]


def keep() -> None:
    """Finish the step that is open; none is left by one that changed nothing."""
    FreeCAD.closeActiveTransaction(False)


def take_back() -> None:
    """Undo what the open step has changed, and close it."""
    FreeCAD.closeActiveTransaction(True)


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
    begin(document, title)
    try:
        yield
    finally:
        take_back()


def forget_redos(document) -> None:
    """Leave nothing to be redone: FreeCAD forgets it with the first change of a new step."""
    if document.RedoCount:
        begin(document, "")
        document.addObject("App::FeaturePython", "Nothing")
        take_back()

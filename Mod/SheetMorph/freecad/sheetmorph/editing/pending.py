# SPDX-License-Identifier: LGPL-2.1-or-later
"""The pose that a document has while a panel is open: seen everywhere, kept only by OK.

It stands in an open undo step, the way back from it in a snapshot: FreeCAD commits what is open as
soon as somebody else opens a step, and undoes all of it at once.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from contextlib import contextmanager
from typing import Any

import FreeCAD

from freecad.sheetmorph.editing import transactions


class Pending:
    """Changes that are neither kept nor taken back yet."""

    def __init__(self, document, title: str, read: Callable, write: Callable):
        """`title`: of the undo step; `read()` a snapshot, `write(snapshot)` where it differs."""
        self._document, self._title = document, title
        self._read, self._write = read, write
        self._is_open = self._is_closing = self._lost_something = False
        self._made: dict[str, Callable] = {}
        self._begin()

    def _begin(self) -> None:
        self._steps = [self._read()]
        self._interrupted: Any = None
        self._forward: Any = None

    @property
    def is_open(self) -> bool:
        """Whether anything may be pending."""
        return self._is_open

    def change(self) -> None:
        """Make sure that what changes next can be taken back; call it before every change."""
        if not self._is_open:
            transactions.begin(self._document, self._title)
            self._is_open = True
            self._forward = None

    def remember_made(self, name: str, make: Callable) -> None:
        """An object was made on the way; `make()` makes it anew when an undo has taken it."""
        self._made[name] = make

    def forget_made(self, name: str) -> None:
        """What was made is not wanted any more."""
        self._made.pop(name, None)

    def settle(self) -> None:
        """Count the present pose as a step that an undo comes back to."""
        now = self._read()
        if self._is_open and now != self._steps[-1]:
            self._steps.append(now)

    def keep(self) -> None:
        """Make what is pending one undo step; the next one begins from here."""
        self._close(transactions.keep)
        self._made = {}
        self._begin()

    def take_back(self) -> None:
        """Give the document the pose of the beginning; what others did meanwhile stays."""
        if self._is_open and self._lost_something:
            self._write(self._steps[0])
            self._close(transactions.keep)
        else:
            self._close(transactions.take_back)

    @contextmanager
    def aside(self) -> Iterator[None]:
        """In this context a step of its own may be done; what is pending comes back after it."""
        wanted = self._read() if self._is_open else None
        self.take_back()
        yield
        if wanted is not None:
            self._take(wanted)

    def abandon(self) -> None:
        """The document is gone: nothing may stay open."""
        self._close(transactions.take_back)

    def _close(self, way) -> None:
        if self._is_open:
            self._is_open, self._is_closing = False, True
            way()
            self._is_closing = False

    # -- what others do to the document

    def on_deletion(self) -> None:
        """Something that is not ours was deleted within our step."""
        self._lost_something = self._lost_something or self._is_open

    def on_close(self, is_abort: bool) -> bool:
        """A step is closed; returns whether it was ours and somebody else did it.

        Nothing half done is committed by others: the document gets its beginning before.
        """
        if self._is_closing or not self._is_open:
            return False
        self._is_open = False
        self._interrupted = self._read()
        is_undo = FreeCAD.getActiveTransaction() is not None
        if not is_abort and not is_undo:
            for name in [name for name in self._made if self._document.getObject(name)]:
                self._document.removeObject(name)
            self._write(self._steps[0])
        return not is_undo

    @property
    def was_undone(self) -> bool:
        """Whether an undo has just taken what was pending."""
        return self._interrupted is not None

    def go_back(self) -> None:
        """After that undo: the pose of the step before the last one."""
        last, self._interrupted = self._interrupted, None
        if last == self._steps[-1] and len(self._steps) > 1:
            self._steps.pop()
        if len(self._steps) > 1:
            self._take(self._steps[-1])
        else:
            self._forward = last

    def go_on(self) -> None:
        """After an interruption: the pose there was."""
        last, self._interrupted = self._interrupted, None
        transactions.keep()  # what the other left open
        if last is not None:
            self._take(last)

    @property
    def can_go_forward(self) -> bool:
        """Whether a redo of the program is one of what was pending."""
        return self._forward is not None

    def go_forward(self) -> None:
        """After that redo: what it brought back is pending again, not a step of its own."""
        wanted = self._forward
        self._document.undo()
        self._take(wanted)
        self.settle()

    def _take(self, wanted: Any) -> None:
        self.change()
        for name, make in self._made.items():
            if name in wanted.motions and self._document.getObject(name) is None:
                make()
        self._write(wanted)

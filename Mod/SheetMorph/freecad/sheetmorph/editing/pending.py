# SPDX-License-Identifier: LGPL-2.1-or-later
"""The pose that a document has while a panel is open: seen everywhere, kept only by OK.

It stands in an undo step of its document alone, the way back from it in a snapshot: FreeCAD commits
the step as soon as somebody else opens one, and undoes all of it at once. After an undo of a part
of it, it is parked in two steps of the document: what is left, and what a redo brings back.

An exception on the way leaves neither an open step nor a pending pose to the next panel: after
`take_back` the document has the pose of the beginning, even if a write failed before or in it.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from contextlib import contextmanager, suppress
from dataclasses import dataclass
from typing import Any

from freecad.sheetmorph.editing import transactions


class Pending:
    """Changes that are neither kept nor taken back yet."""

    def __init__(self, document, title: str, read: Callable, write: Callable):
        """`title`: of the undo step; `read()` a snapshot, `write(snapshot)` where it differs."""
        self._document, self._title = document, title
        self._read, self._write = read, write
        self._is_open = self._is_undone = self._lost_something = self._has_failed = False
        self._number = transactions.NOBODYS
        self._made: dict[str, Callable] = {}
        self._begin()

    def _begin(self) -> None:
        self._steps = [self._read()]
        self._interrupted: Any = None
        self._parked: _Parked | None = None

    @property
    def is_open(self) -> bool:
        """Whether anything may be pending."""
        return self._is_open

    def change(self) -> None:
        """Make sure that what changes next can be taken back; call it before every change."""
        with self._noticed():
            if self._parked is not None:
                self._gather()
            elif not self._is_open:
                self._open()

    def gather(self) -> None:
        """Make one open step of what is parked, before it is kept."""
        if self._parked is not None and self._parked.place > 0:
            with self._noticed():
                self._gather()

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
        self.gather()
        self._close(transactions.keep)
        self._made = {}
        self._begin()

    def take_back(self) -> None:
        """Give the document the pose of the beginning; what others did meanwhile stays."""
        try:
            with self._noticed():
                self._go_to_beginning()
        finally:
            if self._has_failed:
                self._restore()

    def _go_to_beginning(self) -> None:
        if self._parked is not None:
            self._unpark()
        if self._is_open and self._lost_something:
            self._write(self._steps[0])
            self._close(transactions.keep)
        else:
            shown = {obj.Name: obj.Visibility for obj in self._document.Objects}
            self._close(transactions.take_back)
            self._show_again(shown)

    def _restore(self) -> None:
        """After a failure: no step stays open, and no pose that is not kept."""
        self._parked = None
        self._close(transactions.take_back)
        self._has_failed = False
        if self._read() == self._steps[0]:
            return
        transactions.begin(self._document, self._title)
        with suppress(Exception):  # a part of it is better than nothing
            self._write(self._steps[0])
        transactions.keep()

    @contextmanager
    def _noticed(self) -> Iterator[None]:
        """After a failure in this context, `take_back` restores the pose of the beginning."""
        try:
            yield
        except BaseException:
            self._has_failed = True
            raise

    def _show_again(self, shown: dict[str, bool]) -> None:
        """What was hidden or shown meanwhile stays so: that is no change of the morph."""
        for obj in self._document.Objects:
            if obj.Visibility != shown.get(obj.Name, obj.Visibility):
                obj.Visibility = shown[obj.Name]

    @contextmanager
    def aside(self) -> Iterator[None]:
        """In this context a step of its own may be done; what is pending comes back after it."""
        is_pending = self._is_open or (self._parked is not None and self._parked.place > 0)
        wanted = self._read() if is_pending else None
        self.take_back()
        try:
            yield
        finally:
            if wanted is not None:
                with self._noticed():
                    self._take(wanted)

    def abandon(self) -> None:
        """The document is gone, and the step with it."""
        self._is_open = False

    def _open(self) -> None:
        self._is_open, self._number = True, 0  # the step that is open, if it fails half-way
        self._number = transactions.begin_alone(self._document, self._title)

    def _close(self, way) -> None:
        if self._is_open:
            self._is_open = False
            way(self._number)

    # -- what others do to the document

    def on_deletion(self) -> None:
        """Something that is not ours was deleted within our step."""
        is_pending = self._is_open or self._parked is not None
        self._lost_something = self._lost_something or is_pending

    def on_close(self, is_abort: bool) -> bool:
        """A step is closed; returns whether it was ours and somebody else did it.

        Nothing half done is committed by others: the document gets its beginning before.
        """
        if not self._is_open:
            return False
        self._is_open = False
        with self._noticed():
            self._interrupted = self._read()
            self._leave_to(is_abort)
        return True

    def _leave_to(self, is_abort: bool) -> None:
        """Somebody else takes our step back, or commits it: then without what is pending."""
        if not is_abort:
            for name in [name for name in self._made if self._document.getObject(name)]:
                self._document.removeObject(name)
            self._write(self._steps[0])

    def on_undo(self) -> bool:
        """A step was undone; returns whether it was what was pending, or a part of it."""
        parked = self._parked
        is_parked = parked is not None and parked.place > 0 and parked.is_undone(self._document)
        is_mine = not self._is_undone and (self._interrupted is not None or is_parked)
        self._is_undone = self._is_undone or is_mine
        return is_mine

    def resume(self) -> bool:
        """Go on after that; returns whether there was anything."""
        with self._noticed():
            if self._is_undone:
                self._go_back()
            elif self._interrupted is not None:
                transactions.keep()  # what the other left open
                self._take(self._uninterrupted())
            else:
                return False
        return True

    def _go_back(self) -> None:
        """The pose of the step before the last one; a redo goes on from it."""
        self._is_undone = False
        if self._parked is not None:
            self._park(self._parked.place - 1)
            return
        last = self._uninterrupted()
        if last != self._steps[-1]:
            self._steps.append(last)
        self._park(len(self._steps) - 2)

    def _uninterrupted(self) -> Any:
        last, self._interrupted = self._interrupted, None
        return last

    @property
    def can_go_forward(self) -> bool:
        """Whether the redo that was just done is one of what was pending."""
        return self._parked is not None and self._parked.is_redone(self._document)

    def go_forward(self) -> None:
        """After that redo: what it brought back is pending again, not a step of its own."""
        parked = self._parked
        with self._noticed():
            self._document.undo()
            if parked.place > 0:
                self._document.undo()
            if parked.place + 2 < len(self._steps):
                self._park(parked.place + 1)
            else:
                self._parked = None
                self._take(self._steps[-1])

    # -- parked: what an undo has left is a step of the document, a redo away from what it took

    def _park(self, place: int) -> None:
        """From the pose of the beginning: show a step, let a redo of the program lead to the next.

        A document keeps a number of steps only: there are never more than two of these.
        """
        self._parked = None
        if place < 0:
            return
        if place > 0:
            self._one_step(self._steps[place])
        self._one_step(self._steps[place + 1])
        self._document.undo()
        self._parked = _Parked(place, self._document.UndoCount, self._document.RedoCount)

    def _one_step(self, wanted: Any) -> None:
        self._take(wanted)
        self._close(transactions.keep)

    def _unpark(self) -> None:
        """Give the document the pose of the beginning; no redo leads away from it."""
        parked, self._parked = self._parked, None
        self._steps = self._steps[: parked.place + 1]
        if not parked.is_untouched(self._document):
            self._lost_something = True  # a step of somebody else is on top of ours
            self._open()
            return
        if parked.place > 0:
            self._document.undo()
        transactions.forget_redos(self._document)

    def _gather(self) -> None:
        wanted = self._read()
        self._unpark()
        if not self._is_open:
            self._open()
        self._take(wanted)

    def _take(self, wanted: Any) -> None:
        self.change()
        for name, make in self._made.items():
            if name in wanted.motions and self._document.getObject(name) is None:
                make()
        self._write(wanted)


@dataclass(frozen=True)
class _Parked:
    """Which step is shown, and how many steps the document could undo and redo then."""

    place: int
    undos: int
    redos: int

    def is_untouched(self, document) -> bool:
        """Whether nobody has done anything since."""
        return (document.UndoCount, document.RedoCount) == (self.undos, self.redos)

    def is_undone(self, document) -> bool:
        """Whether an undo has taken our step."""
        return (document.UndoCount, document.RedoCount) == (self.undos - 1, self.redos + 1)

    def is_redone(self, document) -> bool:
        """Whether a redo has brought our step back."""
        return (document.UndoCount, document.RedoCount) == (self.undos + 1, self.redos - 1)

# SPDX-License-Identifier: LGPL-2.1-or-later
"""The pose of a document while a panel is open: visible everywhere, stored only by OK.

The changes are in an undo step of this document alone; a snapshot has the pose before them. FreeCAD
commits the step as soon as another one opens, and undoes a step only as a whole. After an undo of
some of the changes, they are parked in two steps of the document: one with the changes that remain,
and one that a redo restores.

A stack of steps in the panel cannot replace this. FreeCAD offers Undo and Redo only if the document
has steps, and executes them on the document.

An exception leaves neither an open step nor a pending pose to the next panel. After `take_back` the
document has the initial pose, even if a write failed before or during it.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from contextlib import contextmanager, suppress
from dataclasses import dataclass
from typing import Any

from freecad.sheetmorph.editing import transactions


class Pending:
    """Changes that are neither stored nor undone yet."""

    def __init__(self, document, title: str, read: Callable, write: Callable):
        """Start without changes; `title` is that of the undo step.

        `read()` returns a snapshot. `write(snapshot)` writes the values that differ.
        """
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
        """Whether changes may be pending."""
        return self._is_open

    def change(self) -> None:
        """Prepare for a change; call it before every change, so that it can be undone."""
        with self._noticed():
            if self._parked is not None:
                self._gather()
            elif not self._is_open:
                self._open()

    def gather(self) -> None:
        """Combine parked changes in one open step before they are stored."""
        if self._parked is not None and self._parked.place > 0:
            with self._noticed():
                self._gather()

    def remember_made(self, name: str, make: Callable) -> None:
        """Register a new object; `make()` creates it again after an undo."""
        self._made[name] = make

    def forget_made(self, name: str) -> None:
        """Remove an object from the register."""
        self._made.pop(name, None)

    def settle(self) -> None:
        """Count the present pose as a step to which an undo returns."""
        now = self._read()
        if self._is_open and now != self._steps[-1]:
            self._steps.append(now)

    def keep(self) -> None:
        """Store the pending changes as one undo step and start afresh."""
        self.gather()
        self._close(transactions.keep)
        self._made = {}
        self._begin()

    def take_back(self) -> None:
        """Restore the initial pose of the document; changes by others stay."""
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
        """Close any open step after a failure and restore the initial pose."""
        self._parked = None
        self._close(transactions.take_back)
        self._has_failed = False
        if self._read() == self._steps[0]:
            return
        transactions.begin(self._document, self._title)
        with suppress(Exception):  # a partial restoration is better than none
            self._write(self._steps[0])
        transactions.keep()

    @contextmanager
    def _noticed(self) -> Iterator[None]:
        """Let `take_back` restore the initial pose after a failure in this context."""
        try:
            yield
        except BaseException:
            self._has_failed = True
            raise

    def _show_again(self, shown: dict[str, bool]) -> None:
        """Restore the visibility set meanwhile, which is not part of the morph."""
        for obj in self._document.Objects:
            if obj.Visibility != shown.get(obj.Name, obj.Visibility):
                obj.Visibility = shown[obj.Name]

    @contextmanager
    def aside(self) -> Iterator[None]:
        """Allow another undo step in this context; the pending changes return after it."""
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
        """Discard the state because the document and its step no longer exist."""
        self._is_open = False

    def _open(self) -> None:
        self._is_open, self._number = True, 0  # 0 is the open step, in case of a failure half-way
        self._number = transactions.begin_alone(self._document, self._title)

    def _close(self, way) -> None:
        if self._is_open:
            self._is_open = False
            way(self._number)

    # -- changes of the document by others

    def on_deletion(self) -> None:
        """Note that an object of somebody else was deleted within the step."""
        is_pending = self._is_open or self._parked is not None
        self._lost_something = self._lost_something or is_pending

    def on_close(self, is_abort: bool) -> bool:
        """Handle a closed step; return whether somebody else closed the pending one.

        The document first returns to its initial pose, so that nothing half done is committed.
        """
        if not self._is_open:
            return False
        self._is_open = False
        with self._noticed():
            self._interrupted = self._read()
            self._leave_to(is_abort)
        return True

    def _leave_to(self, is_abort: bool) -> None:
        """Remove the pending changes before somebody else commits the step."""
        if not is_abort:
            for name in [name for name in self._made if self._document.getObject(name)]:
                self._document.removeObject(name)
            self._write(self._steps[0])

    def on_undo(self) -> bool:
        """Return whether an undo concerned the pending changes or some of them."""
        parked = self._parked
        is_parked = parked is not None and parked.place > 0 and parked.is_undone(self._document)
        is_mine = not self._is_undone and (self._interrupted is not None or is_parked)
        self._is_undone = self._is_undone or is_mine
        return is_mine

    def resume(self) -> bool:
        """Continue after an interruption; return whether there was one."""
        with self._noticed():
            if self._is_undone:
                self._go_back()
            elif self._interrupted is not None:
                transactions.keep()  # the step that the other program part left open
                self._take(self._uninterrupted())
            else:
                return False
        return True

    def _go_back(self) -> None:
        """Show the pose of the step before the last one, to which a redo adds the next."""
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
        """Whether the last redo restored pending changes."""
        return self._parked is not None and self._parked.is_redone(self._document)

    def go_forward(self) -> None:
        """Make the changes of the last redo pending again, instead of a separate step."""
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

    # -- parked changes: the document is one undo and one redo away from the neighbouring poses

    def _park(self, place: int) -> None:
        """Show a step from the initial pose, and let a redo of the program lead to the next one.

        A document stores a limited number of steps, so that parking uses at most two.
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
        """Restore the initial pose of the document and discard the redo steps."""
        parked, self._parked = self._parked, None
        self._steps = self._steps[: parked.place + 1]
        if not parked.is_untouched(self._document):
            self._lost_something = True  # somebody else's step is on top of the parked ones
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
    """The number of the displayed step, and the document's undo and redo counts at that time."""

    place: int
    undos: int
    redos: int

    def is_untouched(self, document) -> bool:
        """Return whether no step was added, undone or redone since."""
        return (document.UndoCount, document.RedoCount) == (self.undos, self.redos)

    def is_undone(self, document) -> bool:
        """Return whether an undo removed the parked step."""
        return (document.UndoCount, document.RedoCount) == (self.undos - 1, self.redos + 1)

    def is_redone(self, document) -> bool:
        """Return whether a redo restored the parked step."""
        return (document.UndoCount, document.RedoCount) == (self.undos + 1, self.redos - 1)

# SPDX-License-Identifier: LGPL-2.1-or-later
"""To whom long work tells how far it is, and who may stop it: set by whoever waits for it.

A macro line has no room for a function, so what it calls asks here. Without a window nobody waits.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from contextlib import contextmanager
from contextvars import ContextVar
from typing import TypeVar

Progress = Callable[[float, str], bool]
"""Called with the share that is done, 0..1, and what is next; returns whether to go on."""

Found = TypeVar("Found")

_WAITING: ContextVar[Progress | None] = ContextVar("waiting", default=None)


def progress() -> Progress | None:
    """Return whom to tell, None for nobody."""
    return _WAITING.get()


def waited_for(work: Callable[[Progress | None], Found]) -> Found:
    """Return what `work(progress)` does, which touches no document and may take long.

    A listener with a window has it done in a thread, and its method `wait_for` handles events.
    """
    listener = _WAITING.get()
    wait_for = getattr(listener, "wait_for", None)
    return work(listener) if wait_for is None else wait_for(work)


class Stopped(RuntimeError):
    """Nobody wants to wait for the rest."""


def one_by_one(things: Sequence[Found], task: str) -> Iterator[Found]:
    """Yield things that are dealt with in the thread of the window; between two of them events
    are handled. Raises Stopped.
    """
    told = progress()
    for number, thing in enumerate(things):
        if told is not None and not told(number / len(things), task):
            raise Stopped(f"Stopped after {number} of {len(things)}.")
        yield thing


@contextmanager
def told_to(listener: Progress) -> Iterator[None]:
    """Let long work in this context tell `listener`."""
    before = _WAITING.set(listener)
    try:
        yield
    finally:
        _WAITING.reset(before)

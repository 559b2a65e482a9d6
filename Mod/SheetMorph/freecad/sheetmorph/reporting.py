# SPDX-License-Identifier: LGPL-2.1-or-later
"""The receiver of progress reports from long work, which can also stop it.

A macro line cannot pass a function, so the code that it calls finds the receiver here. Without a
window there is none.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from contextlib import contextmanager
from contextvars import ContextVar
from typing import TypeVar

Progress = Callable[[float, str], bool]
"""A function that gets the done share (0 to 1) and the next task, and returns whether to go on."""

Found = TypeVar("Found")

_WAITING: ContextVar[Progress | None] = ContextVar("waiting", default=None)


def progress() -> Progress | None:
    """Return the receiver, None without one."""
    return _WAITING.get()


def waited_for(work: Callable[[Progress | None], Found]) -> Found:
    """Return the result of `work(progress)`, which may take long and touches no document.

    A receiver with a window runs it in a thread, and its method `wait_for` handles events.
    """
    listener = _WAITING.get()
    wait_for = getattr(listener, "wait_for", None)
    return work(listener) if wait_for is None else wait_for(work)


class Stopped(RuntimeError):
    """The error for work that was stopped."""


def one_by_one(things: Sequence[Found], task: str) -> Iterator[Found]:
    """Yield things to process in the window thread, handling events in between.

    Raises Stopped if the user cancels.
    """
    told = progress()
    for number, thing in enumerate(things):
        if told is not None and not told(number / len(things), task):
            raise Stopped(f"Stopped after {number} of {len(things)}.")
        yield thing


@contextmanager
def told_to(listener: Progress) -> Iterator[None]:
    """Send progress reports of this context to `listener`."""
    before = _WAITING.set(listener)
    try:
        yield
    finally:
        _WAITING.reset(before)

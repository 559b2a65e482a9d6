# SPDX-License-Identifier: LGPL-2.1-or-later
"""Signals that are postponed while files are renamed."""

from __future__ import annotations

import signal
import threading
from collections.abc import Iterator
from contextlib import contextmanager
from types import FrameType

_NAMES = ("SIGINT", "SIGTERM", "SIGHUP")


def stopping_signals() -> list[signal.Signals]:
    """Return the terminating signals that this system has."""
    return [getattr(signal, name) for name in _NAMES if hasattr(signal, name)]


@contextmanager
def postponed() -> Iterator[None]:
    """Deliver terminating signals after the block; other threads than the main one receive none."""
    if threading.current_thread() is not threading.main_thread():
        yield
        return
    arrived: list[int] = []

    def note(number: int, _frame: FrameType | None) -> None:
        arrived.append(number)

    # None marks a handler from outside Python, which cannot be restored.
    found = {number: signal.getsignal(number) for number in stopping_signals()}
    previous = {number: handler for number, handler in found.items() if handler is not None}
    for number in previous:
        signal.signal(number, note)
    try:
        yield
    finally:
        for number, handler in previous.items():
            signal.signal(number, handler)
        for first in arrived[:1]:
            signal.raise_signal(first)

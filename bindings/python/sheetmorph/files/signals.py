# SPDX-License-Identifier: LGPL-2.1-or-later
"""Signals that have to wait while files get their names."""

from __future__ import annotations

import signal
import threading
from collections.abc import Iterator
from contextlib import contextmanager
from types import FrameType

_NAMES = ("SIGINT", "SIGTERM", "SIGHUP")


def stopping_signals() -> list[signal.Signals]:
    """The signals that ask a program to end, those of them that this system has."""
    return [getattr(signal, name) for name in _NAMES if hasattr(signal, name)]


@contextmanager
def postponed() -> Iterator[None]:
    """Signals that ask to end are delivered after the block (in threads, none arrive anyway)."""
    if threading.current_thread() is not threading.main_thread():
        yield
        return
    arrived: list[int] = []

    def note(number: int, _frame: FrameType | None) -> None:
        arrived.append(number)

    # None: a handler that was not set from Python, which could not be set again.
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

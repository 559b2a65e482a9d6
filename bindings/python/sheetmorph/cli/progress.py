# SPDX-License-Identifier: LGPL-2.1-or-later
"""Progress on stderr: one changing line on a terminal, and a new line now and then elsewhere."""

from __future__ import annotations

import contextlib
import time
from collections.abc import Callable, Iterator
from typing import TextIO

# Seconds before the first line, and between lines.
_ON_TERMINAL = (0.5, 0.1)
_ELSEWHERE = (10.0, 10.0)


@contextlib.contextmanager
def progress_on(stream: TextIO | None, is_quiet: bool) -> Iterator[Callable[[float, str], bool]]:
    """Provide a progress(fraction, task) that prints to a stream, and clear its line at the end."""
    line = _Line(None if is_quiet else stream)
    try:
        yield line.tell
    finally:
        line.clear()


class _Line:
    """The progress line, with the time of its next update."""

    def __init__(self, stream: TextIO | None):
        self._stream = stream
        self._is_terminal = stream is not None and stream.isatty()
        first, self._pause = _ON_TERMINAL if self._is_terminal else _ELSEWHERE
        self._start = time.monotonic()
        self._next = self._start + first
        self._width = 0

    def tell(self, fraction: float, task: str) -> bool:
        now = time.monotonic()
        if self._stream is not None and now >= self._next:
            self._next = now + self._pause
            self._write(f"{now - self._start:5.0f} s  {100.0 * fraction:3.0f} %  {task}")
        return True

    def _write(self, text: str) -> None:
        encoding = getattr(self._stream, "encoding", None) or "utf-8"
        text = text.encode(encoding, "backslashreplace").decode(encoding)
        end = "" if self._is_terminal else "\n"
        start = "\r" if self._is_terminal else ""
        with contextlib.suppress(OSError, ValueError):
            print(start + text.ljust(self._width), end=end, file=self._stream, flush=True)
        self._width = len(text)

    def clear(self) -> None:
        """Erase the changing line from a terminal."""
        if self._is_terminal and self._width:
            self._write("")
            with contextlib.suppress(OSError, ValueError):
                print("\r", end="", file=self._stream, flush=True)

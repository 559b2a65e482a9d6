# SPDX-License-Identifier: LGPL-2.1-or-later
"""What stands in a file, or comes through a pipe that somebody writes to."""

from __future__ import annotations

import errno
import os
import stat
import time
from pathlib import Path

# Seconds for which a pipe may have no writer.
_PATIENCE = 2.0


def read_bytes(path: str | Path) -> bytes:
    """The content of a file. Raises OSError, for a pipe that nobody writes to as well."""
    # Without O_NONBLOCK a pipe is not even opened before somebody writes to it.
    opened = os.open(path, os.O_RDONLY | getattr(os, "O_NONBLOCK", 0) | getattr(os, "O_BINARY", 0))
    with open(opened, "rb") as file:
        if not stat.S_ISFIFO(os.fstat(opened).st_mode):
            return file.read()
        first = _first_of(opened, path)
        os.set_blocking(opened, True)
        return first + file.read()


def read_text(path: str | Path, encoding: str = "utf-8-sig") -> str:
    """The same as text. Raises OSError, UnicodeDecodeError."""
    return read_bytes(path).decode(encoding).replace("\r\n", "\n").replace("\r", "\n")


def _first_of(pipe: int, path: str | Path) -> bytes:
    """What is in a pipe once somebody writes to it; nothing if there is only a writer yet."""
    deadline = time.monotonic() + _PATIENCE
    while True:
        try:
            first = os.read(pipe, 65536)
        except BlockingIOError:
            return b""
        if first:
            return first
        if time.monotonic() > deadline:
            raise OSError(errno.EPIPE, "it is a pipe that nobody writes to", str(path))
        time.sleep(0.02)

# SPDX-License-Identifier: LGPL-2.1-or-later
"""Content of files and of named pipes."""

from __future__ import annotations

import errno
import os
import stat
import time
from pathlib import Path

# Seconds to wait for a writer of a pipe.
_PATIENCE = 2.0


def read_bytes(path: str | Path) -> bytes:
    """Return the content of a file or pipe. Raises OSError, also for a pipe without a writer."""
    # Without O_NONBLOCK, open() blocks until a pipe has a writer.
    opened = os.open(path, os.O_RDONLY | getattr(os, "O_NONBLOCK", 0) | getattr(os, "O_BINARY", 0))
    with open(opened, "rb") as file:
        if not stat.S_ISFIFO(os.fstat(opened).st_mode):
            return file.read()
        first = _first_of(opened, path)
        os.set_blocking(opened, True)
        return first + file.read()


def read_text(path: str | Path, encoding: str = "utf-8-sig") -> str:
    """Return the content of a file or pipe as text. Raises OSError, UnicodeDecodeError."""
    return read_bytes(path).decode(encoding).replace("\r\n", "\n").replace("\r", "\n")


def _first_of(pipe: int, path: str | Path) -> bytes:
    """Return the first data of a pipe, or nothing if a writer has sent no data yet."""
    deadline = time.monotonic() + _PATIENCE
    while True:
        try:
            first = os.read(pipe, 65536)
        except BlockingIOError:
            return b""
        if first:
            return first
        if time.monotonic() > deadline:
            raise OSError(errno.EPIPE, "it is a pipe without a writer", str(path))
        time.sleep(0.02)

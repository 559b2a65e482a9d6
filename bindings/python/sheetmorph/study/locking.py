# SPDX-License-Identifier: LGPL-2.1-or-later
"""Locks of open files that end with their process, on POSIX and on Windows."""

from __future__ import annotations

import errno
import os
from importlib import import_module
from typing import Any

try:
    import fcntl
except ImportError:  # Windows
    fcntl = None  # type: ignore[assignment]
    msvcrt: Any = import_module("msvcrt")

# Windows locks bytes, which need not exist, exclusively for one process. A shared lock takes any
# one of these bytes, an exclusive lock all of them.
_BYTES = 1024
_TAKEN = (errno.EAGAIN, errno.EACCES, errno.EDEADLK)
# Windows cannot remove an open file. Elsewhere a removed file cannot be opened again.
removes_open_files = fcntl is not None
# Flags that Windows does not have.
NEVER_WAIT = getattr(os, "O_NONBLOCK", 0)
NOT_INHERITED = getattr(os, "O_CLOEXEC", 0) | getattr(os, "O_NOINHERIT", 0)


def try_lock(file: int, shared: bool = False) -> bool:
    """Lock an open file until it is closed; return False if another process has locked it.

    Without support for locks only a shared lock succeeds.
    """
    try:
        if fcntl is not None:
            fcntl.flock(file, (fcntl.LOCK_SH if shared else fcntl.LOCK_EX) | fcntl.LOCK_NB)
        else:
            _lock_bytes(file, shared)
    except OSError as error:
        return error.errno not in _TAKEN and shared
    return True


def _lock_bytes(file: int, shared: bool) -> None:
    """Lock one byte or all bytes; raise OSError if they are locked already."""
    for first in range(_BYTES if shared else 1):
        os.lseek(file, first, os.SEEK_SET)
        try:
            msvcrt.locking(file, msvcrt.LK_NBLCK, 1 if shared else _BYTES)
            return
        except OSError as error:
            taken = error
            if error.errno not in _TAKEN:
                break
    raise taken

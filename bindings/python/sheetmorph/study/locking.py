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

# Windows locks bytes, which need not exist, for one process alone. A shared lock takes any of these
# bytes, an exclusive one all of them.
_BYTES = 1024
_TAKEN = (errno.EAGAIN, errno.EACCES, errno.EDEADLK)
# Windows removes no open file; elsewhere nobody can open what is removed before it is closed.
removes_open_files = fcntl is not None
# Names that Windows does not have.
NEVER_WAIT = getattr(os, "O_NONBLOCK", 0)
NOT_INHERITED = getattr(os, "O_CLOEXEC", 0) | getattr(os, "O_NOINHERIT", 0)


def try_lock(file: int, shared: bool = False) -> bool:
    """Lock an open file until it is closed; return False where another process has locked it.

    Where locks do not exist, only a shared lock succeeds: nobody is known to have another one.
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
    """Raise OSError if the bytes are locked already."""
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

# SPDX-License-Identifier: LGPL-2.1-or-later
"""Locks in the folder of a study that state which process works on what; they end with it."""

from __future__ import annotations

import os
import stat
import time
from collections.abc import Iterator
from contextlib import contextmanager, suppress
from pathlib import Path
from types import TracebackType

from ..base.errors import Fault, FileError, RecipeError
from .locking import NEVER_WAIT, NOT_INHERITED, removes_open_files, try_lock

# Seconds for which a batch job waits for the call that started it.
_PATIENCE = 60.0
# Seconds after which a folder without a lease, from an older version, counts as abandoned.
_LONG_AGO = 3600.0
LOCK = ".lock"


class Lease:
    """A file that this process locks for the duration of the ``with`` block."""

    def __init__(self, place: Path):
        self._place, self._file = place, -1

    def __enter__(self) -> Lease:
        self._file = os.open(self._place, os.O_RDWR | os.O_CREAT | NOT_INHERITED, 0o666)
        try_lock(self._file)
        return self

    def __exit__(
        self,
        kind: type[BaseException] | None,
        error: BaseException | None,
        trace: TracebackType | None,
    ) -> None:
        if removes_open_files:
            self._place.unlink(missing_ok=True)
        os.close(self._file)
        if not removes_open_files:
            with suppress(OSError):  # another process looks at it, and removes it
                self._place.unlink(missing_ok=True)


def is_abandoned(lease: Path, folder: Path) -> bool:
    """Return whether the process with the lease of a folder has ended."""
    try:
        file = os.open(lease, os.O_RDWR | NOT_INHERITED)
    except FileNotFoundError:
        try:
            return time.time() - folder.stat().st_mtime > _LONG_AGO
        except OSError:
            return False
    except OSError:
        return False
    try:
        return try_lock(file)
    finally:
        os.close(file)


@contextmanager
def alone(out: Path) -> Iterator[None]:
    """Lock a folder exclusively. Raises RecipeError if another call computes a study in it."""
    with _opened(out) as file:
        if not try_lock(file):
            raise _busy(out)
        yield


@contextmanager
def among_others(out: Path) -> Iterator[None]:
    """Lock a folder for a call that computes some of the runs.

    Raises RecipeError if a call that computes all runs has the lock for too long.
    """
    with _opened(out) as file:
        deadline = time.monotonic() + _PATIENCE
        while not try_lock(file, shared=True):
            if time.monotonic() > deadline:
                raise _busy(out)
            time.sleep(0.1)
        yield


@contextmanager
def _opened(out: Path) -> Iterator[int]:
    place = out / LOCK
    # Opening a pipe without a reader must not block.
    file = os.open(place, os.O_RDWR | os.O_CREAT | NOT_INHERITED | NEVER_WAIT, 0o666)
    try:
        if not stat.S_ISREG(os.fstat(file).st_mode):
            raise FileError(place, "it is a device or a pipe", "remove it")
        yield file
    finally:
        os.close(file)


def _busy(out: Path) -> RecipeError:
    what = f"another process is computing a study in {out}"
    return RecipeError([Fault("-o", what, "wait for it, or choose another folder")])

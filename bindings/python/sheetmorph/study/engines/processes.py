# SPDX-License-Identifier: LGPL-2.1-or-later
"""Variants in processes of this machine."""

from __future__ import annotations

import multiprocessing
import os
import signal
import threading
from collections.abc import Iterator
from concurrent.futures import ProcessPoolExecutor
from concurrent.futures.process import BrokenProcessPool
from contextlib import contextmanager

from .driving import Driver, Hopes, Pool

BROKEN = (BrokenProcessPool,)
THREADS = "SHEETMORPH_THREADS"


def processes_driver(workers: int, hopes: Hopes) -> Driver:
    """Return a driver of this number of worker processes."""

    @contextmanager
    def opened() -> Iterator[Pool]:
        # Forked processes inherit the pre-processing phase. The kernel starts its own threads in
        # each.
        context = multiprocessing.get_context("fork")
        executor = ProcessPoolExecutor(workers, mp_context=context, initializer=_begin)
        with _share_of_cores(workers):
            try:
                yield Pool(executor, 2 * workers)
            finally:
                executor.shutdown(wait=True, cancel_futures=True)

    return Driver(opened, BROKEN, hopes)


@contextmanager
def _share_of_cores(workers: int) -> Iterator[None]:
    """Limit the threads of forked processes so that together they use all cores."""
    if THREADS in os.environ:
        yield
        return
    os.environ[THREADS] = str(max(1, (os.cpu_count() or 1) // workers))
    try:
        yield
    finally:
        del os.environ[THREADS]


def _begin() -> None:
    """Make a new worker end with its parent, or when a broken pool terminates it.

    The handler of the command would only raise an error in the current variant.
    """
    signal.signal(signal.SIGTERM, signal.SIG_DFL)
    threading.Thread(target=_end_with_parent, daemon=True).start()


def _end_with_parent() -> None:
    parent = multiprocessing.parent_process()
    if parent is not None:
        parent.join()
        os._exit(1)

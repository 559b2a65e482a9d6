# SPDX-License-Identifier: LGPL-2.1-or-later
"""Variants in processes of this machine."""

from __future__ import annotations

import multiprocessing
import os
import threading
from collections.abc import Iterator
from concurrent.futures import ProcessPoolExecutor
from concurrent.futures.process import BrokenProcessPool
from contextlib import contextmanager

from .driving import Driver, Hopes, Pool

BROKEN = (BrokenProcessPool,)


def processes_driver(workers: int, hopes: Hopes) -> Driver:
    """A driver of this many worker processes."""

    @contextmanager
    def opened() -> Iterator[Pool]:
        # Forked processes would have the kernel's locks without its threads.
        context = multiprocessing.get_context("spawn")
        threads = max(1, (os.cpu_count() or 1) // workers)
        executor = ProcessPoolExecutor(
            workers, mp_context=context, initializer=_begin, initargs=(threads,)
        )
        try:
            yield Pool(executor, 2 * workers)
        finally:
            executor.shutdown(wait=True, cancel_futures=True)

    return Driver(opened, BROKEN, hopes)


def _begin(threads: int) -> None:
    """In a new worker: its share of the cores, and an end when the one who started it ends."""
    os.environ.setdefault("SHEETMORPH_THREADS", str(threads))
    threading.Thread(target=_end_with_parent, daemon=True).start()


def _end_with_parent() -> None:
    parent = multiprocessing.parent_process()
    if parent is not None:
        parent.join()
        os._exit(1)

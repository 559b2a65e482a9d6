# SPDX-License-Identifier: LGPL-2.1-or-later
"""Variants on a Dask cluster, at a given address or started on this machine."""

from __future__ import annotations

import os
import time
from collections.abc import Iterator
from contextlib import contextmanager
from typing import Any

from ...base.errors import Fault, RecipeError
from .driving import Driver, Hopes, Pool

# Seconds in which a restarted scheduler must answer.
_PATIENCE = 120.0
_AHEAD = 2


def dask_driver(scheduler: str | None, workers: int, hopes: Hopes) -> Driver:
    """Return a driver of the cluster at an address, or of new workers on this machine.

    Raises RecipeError if Dask distributed is not installed or no scheduler answers.
    """
    distributed = _distributed()
    broken = (
        distributed.scheduler.KilledWorker,
        distributed.comm.CommClosedError,
        TimeoutError,
        OSError,
    )

    @contextmanager
    def opened() -> Iterator[Pool]:
        with _client(distributed, scheduler, workers) as client:
            threads = sum(client.ncores().values())
            with client.get_executor(pure=False, retries=0) as executor:
                yield Pool(executor, _AHEAD * max(1, threads), lambda: _known_to(client))

    return Driver(opened, broken, hopes)


@contextmanager
def _client(distributed: Any, scheduler: str | None, workers: int) -> Iterator[Any]:
    if scheduler is not None:
        client = _answering(distributed, scheduler)
        try:
            yield client
        finally:
            client.close(timeout=5)
        return
    threads = max(1, (os.cpu_count() or 1) // workers)
    cluster = distributed.LocalCluster(
        n_workers=workers, threads_per_worker=1, host="127.0.0.1", dashboard_address=None,
        env={"SHEETMORPH_THREADS": os.environ.get("SHEETMORPH_THREADS", str(threads))},
    )  # fmt: skip
    with cluster, distributed.Client(cluster) as client:
        yield client


def _answering(distributed: Any, scheduler: str) -> Any:
    """Return a client of the scheduler as soon as it answers and has workers."""
    end = time.monotonic() + _PATIENCE
    while True:
        try:
            client = distributed.Client(scheduler, timeout=5)
        except (OSError, TimeoutError, ValueError) as error:
            if time.monotonic() > end or isinstance(error, ValueError):
                raise _nobody(scheduler, f"no scheduler answers at {scheduler}") from None
            time.sleep(1.0)
            continue
        try:
            client.wait_for_workers(1, timeout=max(1.0, end - time.monotonic()))
        except (OSError, TimeoutError):
            client.close(timeout=5)
            if time.monotonic() > end:
                raise _nobody(scheduler, f"{scheduler} has no workers") from None
            continue
        return client


def _known_to(client: Any) -> int:
    """Return the number of tasks of the workers; it is 0 after a restart of the scheduler."""
    return sum(map(len, client.processing().values()))


def _nobody(_scheduler: str, what: str) -> RecipeError:
    todo = "start dask-scheduler and dask-worker, and give the address such as tcp://host:8786"
    return RecipeError([Fault("--scheduler", what, todo)])


def _distributed() -> Any:
    try:
        import distributed
    except ImportError:
        todo = "install python3-distributed, or use --engine processes"
        what = "Dask distributed is not installed"
        raise RecipeError([Fault("--engine dask", what, todo)]) from None
    return distributed

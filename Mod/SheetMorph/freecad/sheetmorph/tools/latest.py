# SPDX-License-Identifier: LGPL-2.1-or-later
"""A queue for one job, in which a newer job replaces the one that waits."""

from __future__ import annotations

from typing import Any


class Latest:
    """The running job's state and the job that waits; the worker reports when it has finished."""

    def __init__(self) -> None:
        self._waiting: Any = None
        self.is_busy = False

    @property
    def is_waiting(self) -> bool:
        """Whether a newer job waits for the running one."""
        return self._waiting is not None

    def ask(self, job: Any) -> Any:
        """Return the job if it can begin now; else let it wait and return None."""
        if self.is_busy:
            self._waiting = job
            return None
        self.is_busy = True
        return job

    def finish(self) -> Any:
        """Return the job that begins now that one has finished, None if none waits."""
        job, self._waiting = self._waiting, None
        self.is_busy = job is not None
        return job

    def drop(self) -> None:
        """Discard the waiting job."""
        self._waiting = None

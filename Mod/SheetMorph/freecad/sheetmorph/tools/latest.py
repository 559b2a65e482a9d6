# SPDX-License-Identifier: LGPL-2.1-or-later
"""One thing at a time; of what is asked for meanwhile only the last counts."""

from __future__ import annotations

from typing import Any


class Latest:
    """Keeps what is next; who does the work says when it is finished."""

    def __init__(self) -> None:
        self._waiting: Any = None
        self.is_busy = False

    @property
    def is_waiting(self) -> bool:
        """Whether something newer than what is under way has been asked for."""
        return self._waiting is not None

    def ask(self, job: Any) -> Any:
        """Returns the job if it can begin now, else None: it waits in place of another one."""
        if self.is_busy:
            self._waiting = job
            return None
        self.is_busy = True
        return job

    def finish(self) -> Any:
        """Returns the job that begins now that one is finished, None if none waits."""
        job, self._waiting = self._waiting, None
        self.is_busy = job is not None
        return job

    def drop(self) -> None:
        """Forgets what waits."""
        self._waiting = None

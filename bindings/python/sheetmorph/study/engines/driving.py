# SPDX-License-Identifier: LGPL-2.1-or-later
"""Execution of variants by any executor; variants of a dead worker are tried again."""

from __future__ import annotations

from collections import Counter, deque
from collections.abc import Callable, Iterable
from concurrent.futures import FIRST_COMPLETED, CancelledError, Executor, Future, wait
from contextlib import AbstractContextManager
from dataclasses import dataclass

from ...base.errors import Fault, RecipeError
from ..working import Cost, Task, attempt

_TRIES, _SUSPECT = 4, 2
# Seconds between checks whether an executor still has its tasks, and failed checks to accept.
_LOOK, _PATIENCE = 2.0, 3


@dataclass(frozen=True)
class Hopes:
    """Callbacks of the caller.

    finished: a variant is in its folder. lost: its worker died too often. is_done: returns whether
    its folder exists.
    """

    finished: Callable[[Task, Cost], None]
    lost: Callable[[Task, str], None]
    is_done: Callable[[Task], bool]


@dataclass(frozen=True)
class Pool:
    """An executor.

    room is the number of variants submitted ahead. knows returns how many of them it still has, if
    it can lose some.
    """

    executor: Executor
    room: int
    knows: Callable[[], int] | None = None


_Outcome = tuple[Cost, Fault | None]


class Forgotten(RuntimeError):
    """An executor has lost its tasks."""


class Driver:
    """The submission of tasks to pools that may break; every task ends exactly once."""

    def __init__(
        self,
        opened: Callable[[], AbstractContextManager[Pool]],
        broken: tuple[type[BaseException], ...],
        hopes: Hopes,
    ):
        self._opened, self._hopes = opened, hopes
        self._broken: tuple[type[BaseException], ...] = (*broken, CancelledError, Forgotten)
        self._tries: Counter[int] = Counter()

    def drive(self, tasks: Iterable[Task]) -> None:
        """Run until every task is finished or lost. Raises RecipeError for errors that stop all."""
        waiting, vain = deque(tasks), 0
        while waiting:
            given: dict[Future[_Outcome], Task] = {}
            left = len(waiting)
            try:
                with self._opened() as pool:
                    self._feed(pool, waiting, given)
            except self._broken as error:
                vain = vain + 1 if len(waiting) == left and not given else 0
                if vain >= _PATIENCE:
                    what = f"no worker can be started ({type(error).__name__}: {error})"
                    raise RecipeError([Fault("--engine", what, "try --engine local")]) from error
                self._again(given.values(), waiting, error)

    def _feed(self, pool: Pool, waiting: deque[Task], given: dict[Future[_Outcome], Task]) -> None:
        idle = 0
        while waiting or given:
            while waiting and self._may_give(waiting[0], pool, given):
                given[pool.executor.submit(attempt, waiting[0])] = waiting[0]
                waiting.popleft()
            done = wait(given, _LOOK, FIRST_COMPLETED).done
            for future in done:
                cost, failure = _outcome(future)
                if failure:
                    raise RecipeError([failure])
                self._hopes.finished(given.pop(future), cost)
            idle = 0 if done or pool.knows is None or pool.knows() else idle + 1
            if idle >= _PATIENCE:
                raise Forgotten("it was started again")

    def _may_give(self, task: Task, pool: Pool, given: dict[Future[_Outcome], Task]) -> bool:
        """Return whether to submit a task; repeatedly lost ones run alone to find the culprit."""
        if self._tries[task.run] >= _SUSPECT:
            return not given
        return len(given) < pool.room and not any(
            self._tries[other.run] >= _SUSPECT for other in given.values()
        )

    def _again(self, lost: Iterable[Task], waiting: deque[Task], error: BaseException) -> None:
        """Queue the tasks of a broken pool again; most of them did not cause the failure."""
        for task in list(lost):
            self._tries[task.run] += 1
            if self._hopes.is_done(task):
                self._hopes.finished(task, Cost())
            elif self._tries[task.run] >= _TRIES:
                what = f"its worker process ended {_TRIES} times ({type(error).__name__})"
                self._hopes.lost(task, what)
            else:
                waiting.append(task)


def _outcome(future: Future[_Outcome]) -> _Outcome:
    try:
        return future.result()
    except ImportError as error:
        what = f"the workers cannot load SheetMorph ({error})"
        todo = "start them with this package on their PYTHONPATH"
        return Cost(), Fault("study", what, todo)

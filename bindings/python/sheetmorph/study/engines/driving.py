# SPDX-License-Identifier: LGPL-2.1-or-later
"""Variants handed to an executor of any kind; a worker that dies costs its variants a new try."""

from __future__ import annotations

from collections import Counter, deque
from collections.abc import Callable, Iterable
from concurrent.futures import FIRST_COMPLETED, CancelledError, Executor, Future, wait
from contextlib import AbstractContextManager
from dataclasses import dataclass

from ...errors import Fault, RecipeError
from ..working import Cost, Task, attempt

_TRIES, _SUSPECT = 4, 2
# Seconds after which it is looked whether an executor still knows what it was given, and how often
# it may say no.
_LOOK, _PATIENCE = 2.0, 3


@dataclass(frozen=True)
class Hopes:
    """What the one who drives is told. finished: a variant is in its place; lost: its worker died
    too often; is_done: whether its folder is there."""

    finished: Callable[[Task, Cost], None]
    lost: Callable[[Task, str], None]
    is_done: Callable[[Task], bool]


@dataclass(frozen=True)
class Pool:
    """An executor for one while. executor; room: how many variants it is given ahead; knows: how
    many of them it still knows of, where it may forget some."""

    executor: Executor
    room: int
    knows: Callable[[], int] | None = None


_Outcome = tuple[Cost, Fault | None]


class Forgotten(RuntimeError):
    """An executor that knows no more of what it was given."""


class Driver:
    """Gives tasks to pools that may break; every task ends once, whatever breaks."""

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
        """Returns when every task is finished or lost. Raises RecipeError for what stops all."""
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
                raise Forgotten("it was started anew")

    def _may_give(self, task: Task, pool: Pool, given: dict[Future[_Outcome], Task]) -> bool:
        """What was lost again and again is tried alone: then it is known who is to blame."""
        if self._tries[task.run] >= _SUSPECT:
            return not given
        return len(given) < pool.room and not any(
            self._tries[other.run] >= _SUSPECT for other in given.values()
        )

    def _again(self, lost: Iterable[Task], waiting: deque[Task], error: BaseException) -> None:
        """What a pool was given when it broke: most of it was not to blame."""
        for task in list(lost):
            self._tries[task.run] += 1
            if self._hopes.is_done(task):
                self._hopes.finished(task, Cost())
            elif self._tries[task.run] >= _TRIES:
                what = f"its worker died {_TRIES} times ({type(error).__name__})"
                self._hopes.lost(task, what)
            else:
                waiting.append(task)


def _outcome(future: Future[_Outcome]) -> _Outcome:
    try:
        return future.result()
    except ImportError as error:
        what = f"the workers cannot load what computes variants ({error})"
        todo = "start them with this package on their PYTHONPATH"
        return Cost(), Fault("study", what, todo)

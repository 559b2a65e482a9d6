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

_TRIES = 4
# Seconds after which it is looked whether what was promised is there already.
_LOOK = 5.0


@dataclass(frozen=True)
class Hopes:
    """What the one who drives is told. finished: a variant is in its place; lost: its worker died
    too often; is_done: whether its folder is there."""

    finished: Callable[[Task, Cost], None]
    lost: Callable[[Task, str], None]
    is_done: Callable[[Task], bool]


@dataclass(frozen=True)
class Pool:
    """An executor for one while. executor; room: how many variants it is given ahead."""

    executor: Executor
    room: int


class Driver:
    """Gives tasks to pools that may break; every task ends once, whatever breaks."""

    def __init__(
        self,
        opened: Callable[[], AbstractContextManager[Pool]],
        broken: tuple[type[BaseException], ...],
        hopes: Hopes,
    ):
        self._opened, self._hopes = opened, hopes
        self._broken = (*broken, CancelledError)
        self._tries: Counter[int] = Counter()

    def drive(self, tasks: Iterable[Task]) -> None:
        """Returns when every task is finished or lost. Raises RecipeError for what stops all."""
        waiting = deque(tasks)
        while waiting:
            given: dict[Future, Task] = {}
            try:
                with self._opened() as pool:
                    self._feed(pool, waiting, given)
            except self._broken as error:
                self._again(given.values(), waiting, error)

    def _feed(self, pool: Pool, waiting: deque[Task], given: dict[Future, Task]) -> None:
        while waiting or given:
            while waiting and len(given) < pool.room:
                given[pool.executor.submit(attempt, waiting[0])] = waiting[0]
                waiting.popleft()
            for future in wait(given, _LOOK, FIRST_COMPLETED).done:
                cost, failure = future.result()
                if failure:
                    raise RecipeError([Fault("study", *_halves(failure))])
                self._hopes.finished(given.pop(future), cost)

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
                # One by one from the second time on, behind the others: the culprit dies alone.
                waiting.append(task)


def _halves(sentence: str) -> tuple[str, str]:
    what, _, todo = sentence.rpartition("; ")
    return (what, todo) if what else (sentence, "correct it and start the study again")

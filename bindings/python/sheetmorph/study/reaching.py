# SPDX-License-Identifier: LGPL-2.1-or-later
"""Admissible range of one number of a pose from live answers, for marks during a drag."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass

from ..base.errors import Caution, RecipeError, reason_of
from ..morph.session import Result
from .certifying import failures_of, judged
from .figures import FIGURES, Figures, live_report
from .ranges import Limit, searched

Criteria = Mapping[str, Mapping[str, float]]


class _Stopped(Exception):
    """Nobody waits for the result."""


@dataclass(frozen=True)
class Reach:
    """A search for the admissible range of a number.

    answered returns the live answer for a value. criteria are those of a study. goes_on returns
    whether the result is still needed.
    """

    answered: Callable[[float], Result]
    criteria: Criteria
    goes_on: Callable[[], bool]

    def limits(self, ends: tuple[float, float]) -> list[Limit] | None:
        """Return the limits from 0 to both ends, as shares of the ways.

        The list is empty if 0 itself is not admissible. The result is None if nobody waits for it.
        """
        try:
            if self._why(0.0):
                return []
            return [self._limit(end) for end in ends]
        except _Stopped:
            return None

    def _limit(self, end: float) -> Limit:
        return searched(lambda share: self._why(share * end))

    def _why(self, value: float) -> str:
        """Return the failures at a value, with the first criterion as their code, or an empty text.

        Criteria that need an exact answer are skipped.
        """
        if not self.goes_on():
            raise _Stopped
        try:
            result = self.answered(value)
        except (RecipeError, RuntimeError) as error:
            return reason_of(error)
        figures = Figures(result, live_report(result))
        asked = {name: limits for name, limits in self.criteria.items() if name in FIGURES}
        found = judged(asked, {}, figures.figure)
        failed = [e for e in found if e["value"] is not None and not e["passed"]]
        return Caution("; ".join(failures_of(failed)), code=failed[0]["name"] if failed else "")

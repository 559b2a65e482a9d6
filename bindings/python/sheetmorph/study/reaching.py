# SPDX-License-Identifier: LGPL-2.1-or-later
"""How far one number of a pose may go, on live answers alone: for marks while it is dragged."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass

from ..errors import Caution, RecipeError
from ..session import Result
from .certifying import failures_of, judged
from .figures import FIGURES, Figures, live_report
from .ranges import Limit, searched

Criteria = Mapping[str, Mapping[str, float]]


class _Stopped(Exception):
    """Nobody waits for it any more."""


@dataclass(frozen=True)
class Reach:
    """Asks how far a number may go. answered: the live answer for a value; criteria: as a study has
    them; goes_on: whether somebody still waits."""

    answered: Callable[[float], Result]
    criteria: Criteria
    goes_on: Callable[[], bool]

    def limits(self, ends: tuple[float, float]) -> list[Limit] | None:
        """How far it may go from 0 to both ends, as shares of the ways; none if 0 itself is not
        possible. None as soon as nobody waits.
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
        """What breaks at a value, with the name of the first criterion as its code; empty if
        nothing does. What only exact answers measure is not asked for."""
        if not self.goes_on():
            raise _Stopped
        try:
            result = self.answered(value)
        except RecipeError as error:
            return "; ".join(map(str, error.faults))
        except RuntimeError as error:  # the solver gave up
            return " ".join(str(error).split())
        figures = Figures(result, live_report(result))
        asked = {name: limits for name, limits in self.criteria.items() if name in FIGURES}
        found = judged(asked, {}, figures.figure)
        failed = [e for e in found if e["value"] is not None and not e["passed"]]
        return Caution("; ".join(failures_of(failed)), code=failed[0]["name"] if failed else "")

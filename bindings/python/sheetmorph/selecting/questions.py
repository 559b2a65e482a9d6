# SPDX-License-Identifier: LGPL-2.1-or-later
"""Questions about items that a selector selected before a change, and their answers."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import Any

import numpy as np

from ..base.arrays import Floats
from ..base.errors import InputError
from .things import text_of


@dataclass(frozen=True)
class Candidate:
    """An item that the user can mean: a description, and its position, mm."""

    text: str
    place: list[float]


class Question(InputError):
    """An item that a selector selected before has no certain match; ``was`` describes it.

    candidates are possible items of the changed part, the nearest first.
    """

    def __init__(self, was: str, candidates: list[Candidate]):
        named = " or ".join(one.text for one in candidates) or "nothing like it exists"
        super().__init__(f"{was} may be {named}" if candidates else f"{was} is gone: {named}")
        self.was, self.candidates = was, candidates


@dataclass
class Work:
    """State of a search: the position (3,) that answers one question, and sentences for the user.

    is_still states whether a selector selected something that is not a single rim, face or border.
    """

    answer: Floats | None
    told: list[str] = field(default_factory=list)
    is_still: bool = False

    def answered(self, question: Question) -> Floats:
        """Return the answer, or raise the question if there is none or it was used before."""
        if self.answer is None:
            raise question
        answer, self.answer = self.answer, None
        return answer


def candidate_of(entry: Mapping[str, Any]) -> Candidate:
    """Return a feature as a candidate."""
    return Candidate(text_of(entry), plain(entry["center"]))


def plain(place: Any) -> list[float]:
    """Return a position rounded to three decimals, as a person writes it."""
    return [float(x) + 0.0 for x in np.round(np.asarray(place, dtype=float), 3)]

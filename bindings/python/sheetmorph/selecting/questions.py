# SPDX-License-Identifier: LGPL-2.1-or-later
"""Questions about what a selector took before a change of the part, and their answers."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import Any

import numpy as np

from ..arrays import Floats
from .things import text_of


@dataclass(frozen=True)
class Candidate:
    """What a person may have meant: a sentence, and its place, mm."""

    text: str
    place: list[float]


class Question(ValueError):
    """What a selector took before has no certain match; ``was`` says what that is.

    candidates: the things of the changed part that may be meant, the nearest first.
    """

    def __init__(self, was: str, candidates: list[Candidate]):
        named = " or ".join(one.text for one in candidates) or "nothing like it is there"
        super().__init__(f"{was} may be {named}" if candidates else f"{was} is gone: {named}")
        self.was, self.candidates = was, candidates


@dataclass
class Work:
    """answer: (3,) the place that answers a question, once; told: sentences.

    is_still: whether a selector took what is no rim, face or border of its own.
    """

    answer: Floats | None
    told: list[str] = field(default_factory=list)
    is_still: bool = False

    def answered(self, question: Question) -> Floats:
        """The answer to a question, which is raised if there is none or it was used before."""
        if self.answer is None:
            raise question
        answer, self.answer = self.answer, None
        return answer


def candidate_of(entry: Mapping[str, Any]) -> Candidate:
    """Return a feature as a candidate."""
    return Candidate(text_of(entry), plain(entry["center"]))


def plain(place: Any) -> list[float]:
    """Return a place with three digits behind the point, as a person would write it."""
    return [float(x) + 0.0 for x in np.round(np.asarray(place, dtype=float), 3)]

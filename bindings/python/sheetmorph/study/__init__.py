# SPDX-License-Identifier: LGPL-2.1-or-later
"""Studies: variants of a recipe that are sampled, computed, certified and tabulated."""

from .evaluating import Evaluator
from .reaching import Reach
from .reading import Study, read_study, study_schema
from .rows import Row
from .running import StudyRows, Ways, run_study, study_range
from .sampling import samples_of

__all__ = [
    "Evaluator",
    "Reach",
    "Row",
    "Study",
    "StudyRows",
    "Ways",
    "read_study",
    "run_study",
    "samples_of",
    "study_range",
    "study_schema",
]

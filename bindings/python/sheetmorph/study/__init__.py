# SPDX-License-Identifier: LGPL-2.1-or-later
"""Studies: variants of a recipe, sampled, computed, certified and told in one table."""

from .evaluating import Evaluator
from .reading import Study, read_study, study_schema
from .running import Ways, run_study, study_range

__all__ = ["Evaluator", "Study", "Ways", "read_study", "run_study", "study_range", "study_schema"]

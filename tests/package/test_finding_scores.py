# SPDX-License-Identifier: LGPL-2.1-or-later
"""Precision and recall on labelled models, measured or drawn, fine or coarse: at least 95 % of the
round holes of 8 rim vertices or more and of the contacts; the figures stand in accuracy.md."""

from __future__ import annotations

import pytest

from finding_scores import VARIANTS, Score, data_folder, example_scores, pair_scores
from finding_scores import real_models, real_scores, shape_scores, summed
from sheetmorph.finding.options import CONTACT_KINDS, HOLES

GOOD = 0.95


def require_good(score: Score, least_labels: int) -> None:
    assert score.labelled >= least_labels
    assert score.precision >= GOOD and score.recall >= GOOD, score


@pytest.mark.parametrize("variant", VARIANTS)
def test_holes_and_contacts_of_the_generated_models_are_found(variant: str):
    scores = example_scores(*VARIANTS[variant])
    shapes = shape_scores(*VARIANTS[variant])
    pairs = pair_scores(*VARIANTS[variant])
    require_good(scores["round hole"] + shapes["round hole"], 95)
    of_pairs = sum((pairs[kind] for kind in CONTACT_KINDS), Score())
    require_good(scores["contact"] + of_pairs, 42)
    for kind in (*HOLES, "flange"):
        require_good(shapes[kind], 3)


@pytest.mark.skipif(data_folder() is None, reason="the public meshes are not at hand")
def test_holes_and_contacts_of_the_real_models_are_found():
    scores = summed([real_scores(model, data_folder()) for model in real_models()])
    require_good(scores["round hole"], 110)
    require_good(scores["contact"], 35)

# SPDX-License-Identifier: LGPL-2.1-or-later
"""How far a number may go while it is dragged: the same as the range of a study by live answers."""

from __future__ import annotations

from pathlib import Path

import pytest

from sheetmorph.study import Reach
from sheetmorph.study.plan import Plan
from sheetmorph.study.working import Workshop
from study_samples import write_study

CRITERIA = {"stretch": {"max": 0.45}, "gap change": {"max": 0.1}, "no figure": {"max": 0}}


@pytest.fixture()
def answered(tmp_path: Path):
    shop = Workshop(Plan(write_study(tmp_path)))
    session = shop.session(shop.plan.variant({"lift": 0.0}))
    asked = []

    def answer(value: float):
        asked.append(value)
        return session.deform({"tip": {"translation": [0.0, 0.0, value]}}, exact=False)

    answer.asked = asked
    return answer


def test_both_limits_are_where_a_criterion_breaks(answered):
    low, high = Reach(answered, CRITERIA, lambda: True).limits((-150.0, 90.0))
    for limit, end in ((low, -150.0), (high, 90.0)):
        assert 0.0 < limit.share < 1.0 and "stretch is 0.45" in limit.why
        inside, beyond = (
            Reach(answered, CRITERIA, lambda: True).limits((share * end, 0.0))[0]
            for share in (limit.share, limit.share + 0.01)
        )
        assert not inside.why and beyond.why
    assert abs(low.share * -150.0 + high.share * 90.0) < 0.1  # the plate is flat


def test_without_criteria_only_turned_triangles_are_a_limit(answered):
    found = Reach(answered, {}, lambda: True).limits((-1.0, 1.0))
    assert [(limit.share, limit.why) for limit in found] == [(1.0, ""), (1.0, "")]


def test_it_stops_as_soon_as_nobody_waits(answered):
    left = iter([True, True, True])
    reach = Reach(answered, CRITERIA, lambda: next(left, False))
    assert reach.limits((-150.0, 90.0)) is None
    assert len(answered.asked) == 3


def test_a_start_that_is_not_possible_has_no_limits(answered):
    assert Reach(answered, {"angle": {"min": 89.0}}, lambda: True).limits((-1.0, 1.0)) == []

# SPDX-License-Identifier: LGPL-2.1-or-later
"""What `run` warns of, `check` warns of."""
from collections.abc import Callable
from pathlib import Path

from conftest import sheetmorph


def test_a_rim_far_from_the_given_point(case: Callable[[str], Path]) -> None:
    case("22")
    folder = case("23")
    told = [
        [line for line in done.out.splitlines() if line.startswith("warning: ")]
        for done in (
            sheetmorph("check", "rim_far.json", folder=folder),
            sheetmorph("run", "rim_far.json", "-o", "out", folder=folder),
        )
    ]
    assert told[0] == told[1] and any("144" in line for line in told[0])


def test_a_fixed_region_and_a_handle_that_overlap(case: Callable[[str], Path]) -> None:
    case("22")
    folder = case("23")
    done = sheetmorph("run", "overlap_fixed_handle.json", "-o", "out", folder=folder)
    assert done.status == 2
    assert "fixed region 'fixed0' and handle 'end' share " in done.err
    assert " vertices (" in done.err and " more), which the handle moves by up to 15 mm" in done.err

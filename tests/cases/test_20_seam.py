# SPDX-License-Identifier: LGPL-2.1-or-later
"""A seam of spot welds between two sheets bends."""
from collections.abc import Callable
from pathlib import Path

import numpy as np
from conftest import sheetmorph

WELDS = [(1174, 5036), (1284, 5146), (1394, 5256), (1504, 5366), (1614, 5476)]


def test_the_second_sheet_of_a_seam_bends_and_keeps_its_gaps(case: Callable[[str], Path]) -> None:
    from sheetmorph.decks import read_deck

    folder = case("20")
    ended = sheetmorph("run", "seam2.json", "-o", "out", folder=folder)
    assert ended.status == 0, ended.said
    before, after = read_deck(folder / "seam2.k"), read_deck(folder / "out" / "seam2.k")
    for one, other in WELDS:
        i, j = before.find(np.array([one, other]))
        gap = np.linalg.norm(before.points[i] - before.points[j])
        assert abs(np.linalg.norm(after.points[i] - after.points[j]) - gap) < 1e-6
    # A straight board has no deviation from a plane.
    second = after.points[after.ids >= 5000]
    off = np.linalg.svd(second - second.mean(axis=0))[1][-1] / len(second) ** 0.5
    assert off > 0.1

# SPDX-License-Identifier: LGPL-2.1-or-later
"""Numbers as a person reads them; needs no FreeCAD."""

import pytest
from freecad.sheetmorph.tools import words
from sheetmorph.base.words import counted, folds, preparation


@pytest.mark.parametrize(
    "value, text", [(0.0, "0"), (2.5, "2.5"), (1234.6, "1230"), (0.00123456, "0.00123"), (10, "10")]
)
def test_no_number_has_an_exponent(value, text):
    assert words.plain(value) == text


def test_lengths_that_are_rounding_are_none():
    assert words.length(8e-16) == "0 mm" and words.length(-3e-5) == "0 mm"
    assert words.length(0.8) == "0.8 mm" and words.length(12345.0, 4) == "12340 mm"


def test_shares_that_are_rounding_are_none():
    assert words.percent(1.7e-14) == "0 %"
    assert words.percent(0.0123) == "1.2 %" and words.percent(1.0) == "100 %"


def test_one_is_singular():
    assert counted(1, "sliver", "slivers") == "1 sliver"
    assert counted(0, "sliver", "slivers") == "0 slivers"


def test_one_triangle_folds_and_two_fold():
    assert folds(1) == "1 triangle folds over"
    assert folds(2, " of lid") == "2 triangles of lid fold over"


def test_a_cured_mesh_says_one_in_the_singular():
    done = {"welded": 1, "removed": 1, "split": 0, "turned": 3}
    assert preparation(done) == "1 vertex merged, 1 triangle removed, 0 cut, 3 reoriented"

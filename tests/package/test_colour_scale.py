# SPDX-License-Identifier: LGPL-2.1-or-later
"""The colours of a map of values, which need no FreeCAD."""

import numpy as np
import pytest
from freecad.sheetmorph.tools import colour_scale


def test_the_ends_of_the_span_have_the_end_colours_and_what_is_outside_too():
    colours = colour_scale.colours_of(np.array([0.0, 1.0, 2.0, 3.0]), (1.0, 2.0))
    assert colours[[0, 1]] == pytest.approx(np.stack([colour_scale.STOPS[0]] * 2))
    assert colours[[2, 3]] == pytest.approx(np.stack([colour_scale.STOPS[-1]] * 2))


def test_where_there_is_no_value_it_is_grey():
    (colour,) = colour_scale.colours_of(np.array([np.nan]), (1.0, 2.0))
    assert tuple(colour) == colour_scale.MISSING


def test_rounding_is_no_pattern():
    low, high = colour_scale.span_of(np.array([2.0, 2.0 + 1e-12, np.nan]))
    assert (low, high) == pytest.approx((1.9, 2.1))


def test_a_wide_span_is_that_of_the_values():
    assert colour_scale.span_of(np.array([1.0, np.nan, 4.0])) == (1.0, 4.0)
    assert colour_scale.span_of(np.array([np.nan])) == (0.0, 1.0)

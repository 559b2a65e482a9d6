# SPDX-License-Identifier: LGPL-2.1-or-later
"""Marks on a screen keep apart from each other and from what has its place already."""

import numpy as np
import pytest
from freecad.sheetmorph.tools.spreading import spread


@pytest.mark.parametrize("seed", range(20))
def test_marks_are_apart_and_near_their_places(seed: int):
    draw = np.random.default_rng(seed)
    places = draw.uniform(0.0, draw.choice([1.0, 40.0, 800.0]), (draw.integers(1, 25), 2))
    places = np.vstack([places, places[:1]])  # two in one place
    arrows = places[0] + draw.normal(size=2)
    found = spread(places, 26.0, ((arrows, 100.0),))
    apart = np.linalg.norm(found[:, None] - found[None], axis=2) + 1e9 * np.eye(len(found))
    assert apart.min() >= 26.0 - 1e-6
    assert np.linalg.norm(found - arrows, axis=1).min() >= 100.0 - 1e-6
    assert np.linalg.norm(found - places, axis=1).max() < 100.0 + 26.0 * (len(places) + 2)


def test_marks_that_are_apart_stay():
    places = np.array([[0.0, 0.0], [50.0, 0.0], [0.0, 200.0]])
    assert np.array_equal(spread(places, 26.0), places)
    assert spread(np.empty((0, 2)), 26.0).shape == (0, 2)

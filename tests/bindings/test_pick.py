# SPDX-License-Identifier: LGPL-2.1-or-later
"""The pick layer as Python sees it."""

import numpy as np
import pytest
from sheetmorph import _core

FROM_ABOVE = np.diag([0.1, 0.1, -0.1, 1.0])


def square(height: float) -> tuple[np.ndarray, np.ndarray]:
    """A square of 10 mm, four cells."""
    x, y = (g.ravel() for g in np.meshgrid([-5.0, 0.0, 5.0], [-5.0, 0.0, 5.0], indexing="ij"))
    points = np.stack([x, y, np.full(9, height)], axis=1)
    first = np.array([0, 1, 3, 4])
    a, b, c, d = first, first + 3, first + 4, first + 1
    triangles = np.concatenate([np.stack([a, b, c], 1), np.stack([a, c, d], 1)])
    return points, triangles.astype(np.int32)


@pytest.fixture
def screen():
    return _core.Screen(FROM_ABOVE, 200.0, 100.0)


def test_a_screen_shows_pixels_and_depth(screen):
    assert screen.seen([5.0, -5.0, 2.0]).tolist() == [150.0, 25.0, -0.2]
    with pytest.raises(ValueError, match="extent"):
        _core.Screen(FROM_ABOVE, 200.0, 0.0)
    with pytest.raises(TypeError):
        _core.Screen(np.zeros((3, 3)), 200.0, 100.0)


def test_vertices_inside_an_outline_and_those_nothing_hides(screen):
    low, high = _core.PickingTree(*square(0.0)), _core.PickingTree(*square(3.0))
    outline = np.array([[90.0, 10.0], [190.0, 10.0], [190.0, 60.0], [90.0, 60.0]])
    found = _core.vertices_inside(low, screen, outline)
    assert found.dtype == np.int32 and found.tolist() == [3, 4, 6, 7]
    assert _core.visible_vertices(low, found, screen, [low]).tolist() == [3, 4, 6, 7]
    assert _core.visible_vertices(low, found, screen, [low, high]).tolist() == []
    with pytest.raises(ValueError, match="three or more corners"):
        _core.vertices_inside(low, screen, outline[:2])


def test_a_neighbourhood_grows_shrinks_and_finds_what_hangs_together():
    near = _core.Neighbourhood(_core.TriangleMesh(*square(0.0)))
    assert near.triangles_at([0]).tolist() == [0, 4]
    assert near.grown([0], 1).tolist() == [0, 1, 3, 4]
    assert near.shrunk(np.array([0, 1, 3, 4]), 1).tolist() == [0]
    assert near.face(0, 0.5).tolist() == near.piece(3).tolist() == list(range(8))
    assert [p.tolist() for p in near.pieces([0, 1, 8])] == [[0, 1], [8]]
    assert [len(rim) for rim in near.rims(0.5)] == [8]
    with pytest.raises(ValueError, match="77"):
        near.grown([77], 1)

# SPDX-License-Identifier: LGPL-2.1-or-later
"""Points near the mouse, their distance, and shifts that snap; needs no FreeCAD."""

import numpy as np
import pytest
from freecad.sheetmorph.tools import places, snapping
from freecad.sheetmorph.tools.figures import Camera
from sheetmorph import _core

SQUARE = np.array([[0, 0, 0], [400, 0, 0], [400, 400, 0], [0, 400, 0]], float)
HALVES = np.array([[0, 1, 2], [0, 2, 3]], np.int32)
TURNED = np.array([[0.0, -1.0, 0.0], [1.0, 0.0, 0.0], [0.0, 0.0, 1.0]])

# looks down on 400 mm x 400 mm, a pixel is a millimetre
FROM_ABOVE = Camera(np.diag([1 / 200, 1 / 200, -1e-3, 1.0]), 400.0, 400.0)


def place_at(x: float, y: float) -> places.Place:
    hit = _core.first_hit(SQUARE, HALVES, np.array([x, y, 9.0]), np.array([0.0, 0.0, -1.0]))
    mouse = (x + 200.0, y + 200.0)

    def away(points):
        return FROM_ABOVE.away(points, mouse)

    return places.place_near("plate", (SQUARE, HALVES), hit, away)


@pytest.mark.parametrize(
    ("mouse", "kind", "point"),
    [
        ((395, 6), places.VERTEX, (400, 0, 0)),
        ((206, 3), places.MIDPOINT, (200, 0, 0)),
        ((204, 195), places.MIDPOINT, (200, 200, 0)),
        ((300, 100), places.SURFACE, (300, 100, 0)),
    ],
)
def test_the_mouse_finds_vertices_midpoints_and_else_the_surface(mouse, kind, point):
    place = place_at(*mouse)
    assert place.kind == kind
    assert np.allclose(place.at(SQUARE), point)


def test_a_place_moves_with_its_material():
    place = place_at(300, 100)
    moved = 2.0 * SQUARE + (1.0, 2.0, 3.0)
    assert np.allclose(place.at(moved), (601.0, 202.0, 3.0))


def test_a_drag_along_one_arrow_goes_level_with_a_point():
    assert np.allclose(snapping.along_drag((0, 0, 3.0), (5, 6, 7), np.eye(3)), (0, 0, 7))
    assert np.allclose(snapping.along_drag((1.0, 0, -3.0), (5, 6, 7), np.eye(3)), (5, 0, 7))
    assert np.allclose(snapping.along_drag((0.0, 2.0, 0.0), (5, 6, 7), TURNED), (0, 6, 0))


def test_a_drag_in_a_turned_direction_stays_on_its_line():
    axes = TURNED @ np.array([[0.8, -0.6, 0.0], [0.6, 0.8, 0.0], [0.0, 0.0, 1.0]])
    found = snapping.along_drag(3.0 * axes[:, 0], (5.0, 6.0, 7.0), axes)
    assert np.allclose(np.cross(found, axes[:, 0]), 0.0, atol=1e-12)
    assert np.isclose(found @ axes[:, 0], np.array([5.0, 6.0, 7.0]) @ axes[:, 0])


def test_steps_are_multiples_along_the_axes():
    assert np.allclose(snapping.stepped((3.1, -0.9, 0.2), 2.0, np.eye(3)), (4.0, 0.0, 0.0))
    assert np.allclose(snapping.stepped((-3.1, 0.9, 0.2), 2.0, TURNED), (-4.0, 0.0, 0.0))


def test_a_distance_is_measured_at_rest_and_now():
    ends = [place_at(395, 6), place_at(6, 6)]
    rest = {"plate": (SQUARE, HALVES)}
    now = {"plate": (SQUARE * (1.5, 1.0, 1.0), HALVES)}
    found = places.distance(ends, rest, now)
    assert np.allclose((found.rest, found.now, found.change), (400.0, 600.0, 200.0))


def test_a_place_is_gone_with_its_part_or_vertices():
    place = place_at(300, 100)
    assert place.is_on({"plate": (SQUARE, HALVES)}) and not place.is_on({})
    assert not place.is_on({"plate": (SQUARE[:2], HALVES[:0])})

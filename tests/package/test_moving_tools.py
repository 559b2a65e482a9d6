# SPDX-License-Identifier: LGPL-2.1-or-later
"""The motion in the panel and when results follow it; needs no FreeCAD."""

import numpy as np
import pytest
from freecad.sheetmorph.tools.grabbing import grab
from freecad.sheetmorph.tools.motion import Motion, Moving
from freecad.sheetmorph.tools.part_mesh import Ray
from freecad.sheetmorph.tools.updating import (
    AUTOMATIC,
    BUDGET,
    ON_OK,
    ON_PAUSE,
    WHILE_CHANGING,
    Updating,
)
from sheetmorph import _core

SQUARE = np.array([[0, 0, 0], [4, 0, 0], [4, 4, 0], [0, 4, 0]], float)
HALVES = np.array([[0, 1, 2], [0, 2, 3]], np.int32)


def test_a_zero_axis_is_a_fault_in_words():
    assert "direction" in Motion(axis=(0.0, 0.0, 0.0)).fault()
    assert Motion(axis=(0.0, 1e-9, 0.0)).fault() == ""


def test_the_text_of_a_motion_gives_the_same_numbers():
    motion = Motion((0.1, 1 / 3, -2e-17), (0.0, 1.0, 1e300), 1e-5, (1.5, 2.5, 0.1 + 0.2))
    read = {key: eval(text) for key, text in motion.keywords().items()}  # noqa: S307
    assert Motion(**read) == motion


def test_automatic_results_follow_at_once_only_when_that_is_quick():
    updating = Updating(AUTOMATIC)
    assert not updating.is_due_now() and updating.is_due_on_pause()
    updating.took(BUDGET / 2)
    assert updating.is_due_now()
    updating.took(BUDGET * 2)
    assert not updating.is_due_now()


def test_the_preference_overrules_the_cost():
    updating = Updating(WHILE_CHANGING)
    updating.took(BUDGET * 100)
    assert updating.is_due_now()
    updating.preference = ON_PAUSE
    assert not updating.is_due_now() and updating.is_due_on_pause()
    updating.preference = ON_OK
    assert not updating.is_due_now() and not updating.is_due_on_pause()


def moved(motion: Motion, pivot, point) -> np.ndarray:
    """Where a motion about a pivot takes a point."""
    return np.add(pivot, motion.translation) + motion.matrix() @ np.subtract(point, pivot)


def test_another_pivot_tells_the_same_motion():
    motion, pivot = Motion((1.0, 2.0, 3.0), (1.0, 1.0, 0.0), 400.0), (10.0, 0.0, -5.0)
    told = motion.about(pivot, (7.0, 8.0, 9.0))
    assert moved(told, told.pivot, told.pivot) == pytest.approx((7.0, 8.0, 9.0))
    for point in ((0.0, 0.0, 0.0), (3.0, -4.0, 5.0)):
        assert moved(told, told.pivot, point) == pytest.approx(moved(motion, pivot, point))


def test_a_drag_that_only_shifts_keeps_axis_and_whole_turns():
    motion = Motion(axis=(0.0, 0.0, 2.0), angle=370.0)
    same = motion.turned((1.0, 0.0, 0.0), (0.0, 0.0, 1.0), 10.0)
    assert (same.angle, same.axis, same.translation) == (370.0, motion.axis, (1.0, 0.0, 0.0))
    other = motion.turned((0.0, 0.0, 0.0), (0.0, 1.0, 0.0), 20.0)
    assert (other.angle, other.axis) == (20.0, (0.0, 1.0, 0.0))
    back = motion.turned((0.0, 0.0, 0.0), (0.0, 0.0, 1.0), 0.0)
    assert (back.angle, back.axis) == (0.0, motion.axis)


def test_a_shift_adds_up():
    assert Motion((1.0, 0.0, 0.0)).shifted((0.5, 0.0, -2.00001)).translation == (1.5, 0.0, -2.0)


def test_every_observer_follows_a_motion_until_it_leaves():
    moving, told = Moving(lambda name: (float(len(name)), 0.0, 0.0)), []

    def observer(now, before):
        told.append((now.name, now.motion, before))

    moving.observe(observer)
    up, higher = Motion((0.0, 0.0, 5.0)), Motion((0.0, 0.0, 7.0))
    moving.choose("Tip", up)
    moving.set(up)  # which is no change
    moving.set(higher)
    moving.leave(observer)
    moving.set(up)
    assert told == [("Tip", up, None), ("Tip", higher, up)]


def test_an_observer_may_set_the_motion_again():
    """As an expression does, which drives a translation."""
    moving, drawn = Moving(lambda name: (0.0, 0.0, 0.0)), []
    moving.observe(lambda now, _: now.set(Motion((0.0, 0.0, 3.0))))
    moving.observe(lambda now, _: drawn.append(now.motion.translation))
    moving.set(Motion((9.0, 0.0, 0.0)))
    assert set(drawn) == {(0.0, 0.0, 3.0)}


def test_the_pivot_is_the_centroid_unless_the_motion_has_one():
    moving = Moving(lambda name: {"Tip": (1.0, 2.0, 3.0)}[name])
    moving.choose("Tip", Motion((0.0, 0.0, 5.0), angle=30.0), is_free=True)
    assert (moving.pivot, moving.place) == ((1.0, 2.0, 3.0), (1.0, 2.0, 8.0))
    assert moving.prescribed == Motion((0.0, 0.0, 5.0)), "the sheet turns a free handle"
    moving.choose("Other", Motion((0.0, 0.0, 5.0), angle=30.0, pivot=(4.0, 0.0, 0.0)))
    assert moving.place == (4.0, 0.0, 5.0) and moving.prescribed is moving.motion


def test_the_vertex_under_the_mouse_is_that_of_the_part_in_front():
    meshes = {"below": (SQUARE, HALVES), "above": (SQUARE + (3.0, 0.0, 1.0), HALVES)}
    down = np.array([0.0, 0.0, -1.0])
    found = grab(_core, meshes, Ray(np.array([3.6, 0.3, 9.0]), down))
    assert (found.part, found.vertex) == ("above", 0)
    assert found.point == pytest.approx((3.0, 0.0, 1.0))
    found = grab(_core, meshes, Ray(np.array([0.3, 3.8, 9.0]), down))
    assert (found.part, found.vertex) == ("below", 3)
    assert grab(_core, meshes, Ray(np.array([50.0, 0.0, 9.0]), down)) is None

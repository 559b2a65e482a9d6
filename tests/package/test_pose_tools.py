# SPDX-License-Identifier: LGPL-2.1-or-later
"""Poses as numbers, which need no FreeCAD."""

import pytest
from freecad.sheetmorph.tools.motion import Motion
from freecad.sheetmorph.tools.poses import between, blended, from_text, to_text

FIRST = Motion((1.0, 0.0, 0.0), (0.0, 0.0, 2.0), 30.0, (0.1 + 0.2, 1 / 3, -1e-17))
SECOND = Motion((3.0, 4.0, 0.0), (0.0, 0.0, -1.0), 690.0, (1.0, 1.0, 1.0))


def test_text_keeps_every_bit():
    pose = {"Region": FIRST, "Region001": Motion()}
    assert from_text(to_text(pose)) == pose
    assert from_text("") == {}


def test_the_ends_are_the_poses_themselves():
    pose = {"a": FIRST}
    assert blended(pose, {"a": SECOND}, 0.0) == pose
    assert blended(pose, {"a": SECOND}, 1.0) == {"a": SECOND}


def test_whole_turns_count_and_the_axis_is_the_one_the_user_knows():
    middle = between(FIRST, SECOND, 0.5)
    assert middle.axis == pytest.approx((0.0, 0.0, 1.0))
    assert middle.angle == pytest.approx(-330.0)
    assert middle.translation == pytest.approx((2.0, 2.0, 0.0))


def test_between_two_axes_it_turns_about_one_between():
    middle = between(Motion(axis=(1, 0, 0), angle=90.0), Motion(axis=(0, 1, 0), angle=90.0), 0.5)
    assert middle.axis == pytest.approx((0.5**0.5, 0.5**0.5, 0.0))
    assert between(Motion(angle=20.0), Motion(angle=-20.0), 0.5).angle == 0.0


def test_a_weight_beyond_goes_beyond():
    assert between(Motion(), Motion((2.0, 0.0, 0.0), angle=10.0), 1.5) == Motion(
        (3.0, 0.0, 0.0), angle=15.0
    )

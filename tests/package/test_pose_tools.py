# SPDX-License-Identifier: LGPL-2.1-or-later
"""Poses as numbers, which need no FreeCAD."""

import pytest
from freecad.sheetmorph.tools.motion import Motion, motion_from
from freecad.sheetmorph.tools.poses import between, blended, from_text, share_of, to_text
from sheetmorph.recipe.pose import entries_of, is_plainly_sound, pose_of
from sheetmorph.recipe.structure import pose_faults

FIRST = Motion((1.0, 0.0, 0.0), (0.0, 0.0, 2.0), 30.0, (0.1 + 0.2, 1 / 3, -1e-17))
SECOND = Motion((3.0, 4.0, 0.0), (0.0, 0.0, -1.0), 690.0, (1.0, 1.0, 1.0))


def test_text_keeps_every_bit():
    pose = {"Region": FIRST, "Region001": Motion()}
    assert from_text(to_text(pose)) == pose
    assert from_text("") == {}


def test_saved_text_is_what_it_was():
    assert to_text({"a": Motion((1.0, 2.0, 3.0))}) == (
        '{"a": {"translation": [1.0, 2.0, 3.0], "axis": [0.0, 0.0, 1.0], "angle": 0.0, '
        '"pivot": "centroid"}}'
    )


def test_an_entry_of_a_recipe_says_what_the_motion_says():
    for motion in (FIRST, SECOND, Motion(), Motion((0.0, 0.0, 2.0), angle=-725.5)):
        assert motion_from(motion.entry()) == motion
    assert Motion().entry() == {"translation": [0.0, 0.0, 0.0]}
    turned = Motion(None, (0.0, 0.0, 0.0), 0.0)  # a form feature that is prescribed not to turn
    assert turned.entry() == {"rotation": {"axis": [0.0, 0.0, 1.0], "degrees": 0.0}}
    assert Motion(None, None, size=12.0).entry() == {"size": 12.0}


def test_the_kernels_package_takes_a_motion_as_it_is():
    typed = {"a": FIRST, "b": SECOND, "c": Motion(), "d": Motion(None, None, size=3.0)}
    assert is_plainly_sound(typed) and pose_of(typed) == typed
    told = pose_of(entries_of(typed))
    for name, motion in typed.items():
        for key in ("translation", "pivot", "target", "size"):
            assert getattr(told[name], key) == getattr(motion, key), (name, key)
        wanted, found = motion.rotation, told[name].rotation
        assert (wanted and tuple(wanted)) == (found and (found.axis, found.radians)), name


@pytest.mark.parametrize(
    "bad",
    [
        Motion((float("nan"), 0.0, 0.0)),
        Motion((0.0, float("inf"), 0.0)),
        Motion(pivot=(1e30, 0.0, 0.0)),
        Motion(axis=(0.0, "up", 1.0), angle=3.0),
        Motion(None, None, size=-1.0),
        Motion((0.0, 0.0)),
    ],
)
def test_a_motion_that_is_no_number_is_refused_in_words(bad):
    assert not is_plainly_sound({"a": bad})
    assert [fault.where.startswith("pose.a") for fault in pose_faults({"a": bad})]


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


def test_a_share_of_a_pose_keeps_axes_pivots_and_what_has_no_object():
    entry = {"translation": [1.0, 2.0, 3.0]}
    pose = {"a": FIRST, "b": Motion(None, None, size=3.0), "point": entry}
    half = share_of(pose, 0.5)
    assert half["a"] == Motion((0.5, 0.0, 0.0), FIRST.axis, 15.0, FIRST.pivot)
    assert half["b"] == pose["b"] and half["point"] is entry
    assert share_of(pose, 1.0) == pose
    assert share_of(pose, 0.0)["a"].is_rest()

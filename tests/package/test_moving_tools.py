# SPDX-License-Identifier: LGPL-2.1-or-later
"""The motion in the panel and when results follow it; needs no FreeCAD."""

from freecad.sheetmorph.tools.motion import Motion
from freecad.sheetmorph.tools.updating import (
    AUTOMATIC,
    BUDGET,
    ON_OK,
    ON_PAUSE,
    WHILE_CHANGING,
    Updating,
)


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

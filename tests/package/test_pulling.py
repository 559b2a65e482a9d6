# SPDX-License-Identifier: LGPL-2.1-or-later
"""How far a drag has gone, and a value typed in its place; needs no FreeCAD."""

from dataclasses import replace

from freecad.sheetmorph.tools.motion import Motion, Pull

START = Motion((1.0, 0.0, 2.0))


def pulled(now: Motion, start: Motion = START) -> Pull:
    pull = Pull(start)
    pull.moved(now)
    return pull


def test_a_shift_is_told_from_where_the_drag_began():
    assert pulled(replace(START, translation=(1.0, 0.0, 14.5))).described() == "12.5 mm"


def test_a_turn_is_told_in_degrees():
    assert pulled(replace(START, angle=15.0)).described() == "15°"
    turned = replace(START, angle=20.0)
    assert pulled(replace(turned, angle=5.0), turned).described() == "-15°"


def test_a_typed_value_goes_where_the_drag_is_going():
    pull = pulled(replace(START, translation=(1.0, 0.0, 14.5)))
    assert pull.type("2") and pull.type("0") and pull.described().startswith("20")
    assert pull.with_value(20.0).translation == (1.0, 0.0, 22.0)
    down = pulled(replace(START, translation=(1.0, 0.0, -3.0)))
    assert down.with_value(4.0).translation == (1.0, 0.0, -2.0)


def test_a_typed_angle_turns_the_way_the_drag_turns():
    pull = pulled(replace(START, axis=(1.0, 0.0, 0.0), angle=-7.0))
    assert pull.is_turn and pull.with_value(30.0).angle == -30.0


def test_nothing_is_typed_before_there_is_a_direction_nor_what_is_no_value():
    assert not Pull(START).type("5")
    pull = pulled(replace(START, angle=3.0))
    assert not pull.type("x") and pull.type("5") and pull.type("") and pull.text == ""


def test_the_mouse_counts_again_when_nothing_is_typed_any_more():
    pull = pulled(replace(START, angle=3.0))
    pull.type("5")
    assert not pull.moved(replace(START, angle=4.0)) and pull.text == "5"
    pull.type("")
    assert pull.moved(replace(START, angle=4.0)) and pull.described() == "4°"

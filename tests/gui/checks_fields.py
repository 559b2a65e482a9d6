# SPDX-License-Identifier: LGPL-2.1-or-later
"""Fields keep the numbers they are given, whatever they show of them, in all units of FreeCAD."""

import FreeCAD as App
from checks_dragging import drag_up, grab_up_arrow
from checks_features import select
from checks_moving import open_panel
from desk import child, click_widget, enter, picture, press, press_tool, settled, until, xdotool
from freecad.sheetmorph import api
from freecad.sheetmorph.objects.region import motion_of
from scenes import new_morph, regions

__all__ = [
    "test_a_motion_stays_to_the_bit_while_another_number_is_typed",
    "test_ok_in_the_panel_of_a_form_feature_changes_nothing_by_itself",
    "test_lengths_are_read_in_millimetres_however_small_or_large",
    "test_a_number_without_a_unit_is_one_of_the_unit_shown",
    "test_what_is_typed_while_the_program_writes_is_read_as_typed",
    "test_a_value_beside_the_cursor_may_be_an_expression",
]
EXPRESSIONS = (("100/4", 25.0), ("10 in", 254.0), ("2*(3+1)", 8.0))
AXIS = (0.26726124191242440, 0.53452248382484879, 0.80178372573727319)
STANDARD, INCHES, CENTIMETRES, FEET = 0, 3, 4, 7


def choose_units(schema: int) -> None:
    """As in the preferences; since FreeCAD 1.0 a document has units of its own besides."""
    App.Units.setSchema(schema)
    document = App.ActiveDocument
    if hasattr(document, "UnitSystem"):
        document.UnitSystem = document.getEnumerationsOfProperty("UnitSystem")[schema]


def test_a_motion_stays_to_the_bit_while_another_number_is_typed():
    """In feet 1.23456 mm are 0.00: that was then moved."""
    yield from new_morph()
    handle = regions("handle")[0]
    try:
        for schema in (STANDARD, INCHES, CENTIMETRES, FEET):
            api.set_motion(handle, (1.23456, 0.0008, 0.0), axis=AXIS, angle=7.65432)
            App.ActiveDocument.recompute()
            choose_units(schema)
            yield from open_panel()
            yield from enter(child("translation_z"), "2 mm")
            yield from until(lambda: handle.TranslationZ.Value == 2.0, "the handle to follow")
            yield from press("OK")
            motion = motion_of(handle)
            assert motion.translation == (1.23456, 0.0008, 2.0), (schema, motion)
            assert (motion.axis, motion.angle) == (AXIS, 7.65432), (schema, motion)
    finally:
        choose_units(STANDARD)


def test_ok_in_the_panel_of_a_form_feature_changes_nothing_by_itself():
    yield from new_morph()
    hole = regions("form feature")[0]
    api.set_rotation(hole, (AXIS, 12.34567))
    api.set_size(hole, 23.45678)
    App.ActiveDocument.recompute()
    App.ActiveDocument.clearUndos()
    yield from select(hole)
    yield from press_tool("Form Feature Settings…")
    picture("fields-feature")
    yield from press("OK")
    assert tuple(hole.RotationAxis) == AXIS and hole.RotationAngle.Value == 12.34567
    assert hole.Size.Value == 23.45678
    assert App.ActiveDocument.UndoNames == [], "an undo step for nothing"


def test_lengths_are_read_in_millimetres_however_small_or_large():
    """FreeCAD says 800.00 nm, 50.00 µm and 12.35 m."""
    yield from new_morph()
    yield from open_panel()
    for typed, text, value in (
        ("0.0008", "0.0008 mm", 0.0008),
        ("0.05", "0.05 mm", 0.05),
        ("12.345678", "12.35 mm", 12.345678),
        ("12345.678 mm", "12345.68 mm", 12345.678),
        ("2 cm", "20.00 mm", 20.0),
        ("1/0", "20.00 mm", 20.0),
    ):
        yield from enter(child("translation_x"), typed)
        field = child("translation_x")
        yield from until(lambda f=field, t=text: f.text() == t, f"{typed} to be {text}")
        assert field.value() == value, (typed, field.value())
        yield from settled()
    picture("fields-small")
    yield from press("Cancel")


def test_a_number_without_a_unit_is_one_of_the_unit_shown():
    yield from new_morph()
    try:
        for schema, value in ((STANDARD, 2.0), (INCHES, 50.8), (CENTIMETRES, 20.0)):
            choose_units(schema)
            yield from open_panel()
            yield from enter(child("translation_x"), "0.0008 mm")
            yield from enter(child("translation_x"), "2")
            field = child("translation_x")
            yield from until(lambda f=field, v=value: abs(f.value() - v) < 1e-12, f"{value} mm")
            yield from press("Cancel")
    finally:
        choose_units(STANDARD)


def test_what_is_typed_while_the_program_writes_is_read_as_typed():
    """A frame, a drag or an undo writes into the fields between two keys."""
    yield from new_morph()
    yield from open_panel()
    for name in ("translation_x", "translation_z"):
        for text, value in EXPRESSIONS:
            field = child(name)
            yield from click_widget(field)
            yield from until(field.hasFocus, "the field")
            yield from xdotool("key", "ctrl+a")
            for k, key in enumerate(text):
                yield from xdotool("type", "--", key)
                typed = text[: k + 1]
                yield from until(lambda f=field, t=typed: f.text() == t, f"{typed} to arrive")
                child("translation_y").setValue(0.125 * k)
                field.setValue(0.5 * k)
            assert field.text() == text, (name, field.text())
            yield from xdotool("key", "Tab")
            yield from until(lambda f=field, v=value: abs(f.value() - v) < 1e-9, f"{text}")
            field.setValue(1.0)
            assert field.value() == 1.0, "a field that nobody edits is written to"
    yield from settled()
    yield from press("Cancel")


def test_a_value_beside_the_cursor_may_be_an_expression():
    yield from new_morph()
    yield from open_panel()
    before = 0.0
    for text, value in EXPRESSIONS:
        start = yield from grab_up_arrow((0.0, 0.0, before))
        yield from drag_up(start)
        for key in text:
            yield from xdotool("type", "--", key)
            yield from drag_up(start, 1)
        yield from xdotool("key", "Return")
        yield from xdotool("mouseup", 1)
        field = child("translation_z")
        expected = before + value
        yield from until(lambda f=field, v=expected: abs(f.value() - v) < 1e-6, f"{text}")
        yield from press_button("reset")
        yield from settled()
    yield from press("Cancel")


def press_button(name: str):
    yield from click_widget(child(name))

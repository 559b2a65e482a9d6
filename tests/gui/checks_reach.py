# SPDX-License-Identifier: LGPL-2.1-or-later
"""The Move Handle panel shows how far the value that is changed may go."""

import re

import FreeCADGui as Gui
from checks_preferences import dark_sheet
from desk import child, click_widget, enter, picture, press, press_tool, until
from freecad.sheetmorph import api
from PySide import QtGui
from scenes import assembly, new_morph, regions

__all__ = [
    "test_marks_show_how_far_a_value_may_go",
    "test_the_criteria_of_a_study_are_limits_of_the_marks",
]


def is_marked() -> bool:
    pixmap = child("reach").pixmap()
    return pixmap is not None and not pixmap.isNull()


def ends() -> tuple[float, float]:
    """The two numbers that the panel tells."""
    found = re.search(r": (-?[\d.]+) to (-?[\d.]+)", child("reach_text").text())
    assert found, child("reach_text").text()
    return float(found.group(1)), float(found.group(2))


def seen_in_marks() -> set[str]:
    """The colours of the scale, those that matter."""
    image = child("reach").pixmap().toImage()
    middle = [image.pixelColor(x, image.height() - 5).name() for x in range(image.width())]
    return set(middle) & {"#2e9e5b", "#d64545"}


def test_marks_show_how_far_a_value_may_go():
    yield from new_morph()
    yield from press_tool("Move Handle…")
    assert not is_marked() and "Change one value" in child("reach_text").text()
    yield from enter(child("translation_x"), "-20 mm")
    yield from until(is_marked, "the marks of X")
    low, high = ends()
    assert low < -20.0 < 0.0 < high and child("reach_text").text().startswith("X")
    assert "triangles flip" in child("reach_text").text()
    assert seen_in_marks() == {"#2e9e5b", "#d64545"}
    picture("reach")
    yield from enter(child("translation_x"), f"{low - 10.0:.3f} mm")
    assert ends() == (low, high), "the marks of the same value stay"
    picture("reach-beyond")
    yield from enter(child("angle"), "5")
    yield from until(lambda: child("reach_text").text().startswith("Angle"), "other marks")
    yield from press("Cancel")
    assert not Gui.Control.activeDialog()


def test_the_criteria_of_a_study_are_limits_of_the_marks():
    yield from new_morph()
    (handle,) = regions("handle")
    parameters = [("lift", handle, "TranslationZ", 0.0, 30.0)]
    api.add_study(assembly(), parameters=parameters, criteria="displacement <= 17")
    application = QtGui.QApplication.instance()
    before = application.styleSheet()
    application.setStyleSheet(dark_sheet())
    try:
        yield from press_tool("Move Handle…")
        yield from enter(child("translation_z"), "12 mm")
        yield from until(is_marked, "the marks")
        low, high = ends()
        assert abs(high - 17.0) < 0.1 and abs(low + 17.0) < 0.1, (low, high)
        assert "displacement is 17" in child("reach_text").text()
        picture("reach-dark")
        yield from click_widget(child("reset"))
        yield from press("Cancel")
    finally:
        application.setStyleSheet(before)

# SPDX-License-Identifier: LGPL-2.1-or-later
"""The preferences page, other languages, a dark theme, and what FreeCAD's Test workbench runs."""

import io
import os
import re
import unittest

import FreeCAD as App
import FreeCADGui as Gui
from desk import activate, child, enter, picture, press, press_tool, settled, until
from freecad.sheetmorph import preferences
from freecad.sheetmorph.scene import colours
from PySide import QtCore, QtGui
from scenes import new_morph

__all__ = [
    "test_the_preferences_page_changes_what_panels_begin_with",
    "test_the_window_tests_of_the_test_workbench_pass",
    "test_panels_are_readable_in_a_dark_theme_and_in_german",
]


def preferences_dialog():
    """The open dialog with the page of this workbench, and the page."""
    dialog = QtGui.QApplication.activeModalWidget()
    pages = [p for p in dialog.findChildren(QtGui.QWidget, "preferences")]
    return dialog, pages[0] if pages else None


def test_the_preferences_page_changes_what_panels_begin_with():
    yield from new_morph()
    QtCore.QTimer.singleShot(0, lambda: Gui.showPreferences("SheetMorph", 0))
    yield from until(QtGui.QApplication.activeModalWidget, "the preferences")
    yield from settled()
    dialog, page = preferences_dialog()
    picture("preferences")
    page.findChild(QtGui.QDoubleSpinBox, "CreaseAngle").setValue(17.0)
    page.findChild(QtGui.QSpinBox, "HoleRings").setValue(2)
    page.findChild(QtGui.QComboBox, "UpdateResults").setCurrentIndex(2)
    yield from enter(page.findChild(QtGui.QWidget, "SnapLength"), "2 cm")
    handle_colour = page.findChild(QtGui.QPushButton, "ColourHandle")
    handle_colour.setProperty("color", QtGui.QColor(255, 0, 128))
    boxes = dialog.findChildren(QtGui.QDialogButtonBox)
    boxes[-1].button(QtGui.QDialogButtonBox.Ok).click()
    yield from settled()
    try:
        assert preferences.get("UpdateResults") == 2
        assert preferences.get("SnapLength") == 20.0
        assert colours.css(colours.ROLES["handle"]) == "#ff0080"
        yield from press_tool("Mark Form Features…")
        assert float(child("angle").value()) == 17.0
        assert child("rings").value() == 2
        yield from press("Cancel")
    finally:
        group = App.ParamGet(preferences.PATH)
        for entry in ("CreaseAngle", "SnapLength", "HoleRings", "UpdateResults", "ColourHandle"):
            for remove in (group.RemFloat, group.RemInt, group.RemUnsigned):
                remove(entry)


def test_the_window_tests_of_the_test_workbench_pass():
    yield from activate()
    name = "freecad.sheetmorph.tests.test_workbench"
    assert name in App.__unit_test__
    said = io.StringIO()
    found = unittest.defaultTestLoader.loadTestsFromName(name)
    result = unittest.TextTestRunner(said).run(found)
    assert result.wasSuccessful() and not result.skipped, said.getvalue()


def dark_sheet() -> str:
    """A dark style sheet of this FreeCAD, which puts the colours of its preferences in for names
    like @ThemeAccentColor1; 1.1 composes its own from parameters."""
    folder = os.path.join(App.getResourceDir(), "Gui", "Stylesheets")
    for name in ("Dark-blue.qss", "FreeCAD Dark.qss"):
        path = os.path.join(folder, name)
        if os.path.exists(path):
            with open(path, encoding="utf-8") as file:
                return re.sub(
                    r"@ThemeAccentColor\d", "#5e81ac", file.read().replace("qss:", folder + "/")
                )
    return "QWidget { background-color: #2d2d2d; color: #e0e0e0; }"


ARROW = 22  # px from the left of a button that folds a group


def is_arrow_like_text(button) -> bool:
    """Whether the arrow of a button that folds a group is on the side of its ground, and about as
    far from it, that its text is on."""
    image = button.grab().toImage()
    columns = [
        [QtGui.qGray(image.pixel(x, y)) for y in range(5, image.height() - 5)]
        for x in range(5, image.width() - 5)
    ]
    greys = [grey for column in columns for grey in column]
    ground = max(set(greys), key=greys.count)
    arrow, text = (
        max((grey - ground for column in part for grey in column), key=abs)
        for part in (columns[: ARROW - 5], columns[ARROW:])
    )
    return abs(text) > 40 and arrow * text > 0.3 * text * text


def folding_buttons() -> list:
    """Those that are seen."""
    found = Gui.getMainWindow().findChildren(QtGui.QToolButton)
    return [b for b in found if b.objectName().startswith("fold_") and b.isVisible()]


def test_panels_are_readable_in_a_dark_theme_and_in_german():
    yield from new_morph()
    sheet = dark_sheet()
    before = QtGui.QApplication.instance().styleSheet()
    Gui.setLocale("German")
    QtGui.QApplication.instance().setStyleSheet(sheet)
    yield from settled()
    try:
        for tool, title, close in (
            ("Assistent", "guide", "Schließen"),
            ("Griff bewegen…", "move", "Abbrechen"),
            ("Formelemente markieren…", "region", "Abbrechen"),
            ("Ausbreitung…", "propagation", "Schließen"),
            ("Studie…", "study", "Abbrechen"),
        ):
            yield from press_tool(tool)
            yield from settled()
            picture(f"dark-{title}")
            assert len(folding_buttons()) == {"move": 3, "region": 1}.get(title, 0)
            assert all(map(is_arrow_like_text, folding_buttons()))
            assert Gui.Control.activeDialog()
            yield from press(close)
            assert not Gui.Control.activeDialog()
    finally:
        Gui.setLocale("English")
        QtGui.QApplication.instance().setStyleSheet(before)
    yield from settled()
    assert not Gui.Control.activeDialog()

# SPDX-License-Identifier: LGPL-2.1-or-later
"""Panels fit a small window, and what is wrong is said where it is seen at once."""

import random

import FreeCAD as App
import FreeCADGui as Gui
from checks_hostile import press_if_there
from checks_moving import open_panel
from desk import POLL, child, laid_out, note, panel, picture, press, settled, until
from freecad.sheetmorph.panels.base import say
from hostile_panels import PANELS, is_shown, prepared
from PySide import QtGui
from scenes import assembly, new_morph

__all__ = [
    "test_every_panel_fits_a_small_window_and_shows_what_is_wrong",
    "test_no_widget_moves_whatever_a_panel_says",
    "test_no_widget_moves_while_a_steel_sheet_is_computed",
]
SAID = ("message", "staying", "status", "reach_text", "scale_text")
WORDS = "Computing steel shape: step 7 of a thing that takes its time ".split()

FAULT = (
    "Hole 'A1' can be at most 25.1 mm: fixed region 'Base' holds the sheet around it. Take fewer "
    "vertices into 'Base'."
)


def test_every_panel_fits_a_small_window_and_shows_what_is_wrong():
    """The screen of these tests is 1000 px high, with title, menu and toolbars.

    Study has two tables and may be scrolled. Since FreeCAD 1.0 panels lie over the view and have
    two thirds of its height, so all may be. A fault must be visible without scrolling everywhere.
    """
    is_over_view = int(App.Version()[0]) >= 1
    yield from prepared()
    wrong = []
    for name, (opener, used, _) in PANELS.items():
        opener()
        yield from until(is_shown, f"the panel {name}")
        used()
        yield from settled()
        picture(f"panel-{name}")
        hidden = scrolled(panel())
        if hidden and is_over_view:
            note(f"{name}: {hidden} px are scrolled")
        elif hidden and name != "study":
            wrong.append(f"{name}: {hidden} px do not fit")
        message = panel().findChild(QtGui.QLabel, "message")
        if message is not None:
            say(message, FAULT, True)
            yield from laid_out()
            picture(f"panel-{name}-fault")
            wrong += [f"{name}: {text}" for text in unseen(message)]
        yield from press_if_there("Cancel", "Close")
        yield from until(lambda: not Gui.Control.activeDialog(), f"{name} to close")
        yield from settled()
    for text in wrong:
        note(text)
    assert not wrong, "\n".join(wrong)


def area_of(widget):
    """The scroll area around a panel."""
    areas = Gui.getMainWindow().findChildren(QtGui.QScrollArea)
    return next(area for area in areas if area.isVisible() and area.isAncestorOf(widget))


def scrolled(form) -> int:
    """How many px of a panel one has to scroll for."""
    return area_of(form).verticalScrollBar().maximum()


def unseen(message) -> list[str]:
    """What of a label cannot be read without scrolling from the top of its panel."""
    area = area_of(message)
    area.verticalScrollBar().setValue(0)
    top = message.mapTo(area.viewport(), message.rect().topLeft()).y()
    bottom = message.mapTo(area.viewport(), message.rect().bottomLeft()).y()
    found = []
    if not message.isVisible() or top < 0 or bottom > area.viewport().height():
        found.append(f"the fault lies {bottom - area.viewport().height()} px below the fold")
    if message.height() < message.heightForWidth(message.width()):
        found.append("the fault is cut off")
    return found


def places(form) -> dict:
    """Where every widget is that can be clicked or typed into, in its panel."""
    found = {}
    for widget in form.findChildren(QtGui.QWidget):
        is_used = isinstance(widget, USED) and widget.isVisible()
        if is_used and widget.objectName() and not of_a_fault(widget):
            corner = widget.mapTo(form, widget.rect().topLeft())
            found[widget.objectName()] = corner.x(), corner.y(), widget.height()
    return found


USED = (QtGui.QAbstractButton, QtGui.QAbstractSpinBox, QtGui.QComboBox, QtGui.QLineEdit)
USED += (QtGui.QAbstractItemView, QtGui.QAbstractSlider)


def of_a_fault(widget) -> bool:
    """Whether it belongs to the strip that says what is wrong."""
    strips = panel().findChildren(QtGui.QScrollArea, "notices")
    return any(strip.isAncestorOf(widget) for strip in strips)


def moved(before: dict, after: dict) -> list[str]:
    """What is elsewhere, with both places."""
    return [
        f"{name} {before[name]} {after[name]}"
        for name in before
        if after.get(name, before[name]) != before[name]
    ]


def test_no_widget_moves_whatever_a_panel_says():
    """Nothing, a word, a sentence, a paragraph, in red and not, in every label that changes."""
    yield from prepared()
    draw, wrong = random.Random(37), []
    for name, (opener, used, _) in PANELS.items():
        opener()
        yield from until(is_shown, f"the panel {name}")
        used()
        yield from settled()
        before = places(panel())
        assert before or name == "thickness", name  # which has pictures alone
        for _ in range(6):
            for label in filter(None, (panel().findChild(QtGui.QLabel, one) for one in SAID)):
                text = " ".join(draw.choices(WORDS, k=draw.choice((0, 1, 8, 16, 40))))
                say(label, text, draw.random() < 0.5)
            yield from laid_out()
            wrong += [f"{name}: {text}" for text in moved(before, places(panel()))][:3]
        yield from press_if_there("Cancel", "Close")
        yield from until(lambda: not Gui.Control.activeDialog(), f"{name} to close")
        yield from settled()
    assert not wrong, "\n".join(wrong)


def test_no_widget_moves_while_a_steel_sheet_is_computed():
    """From the preview over all its steps to the final shape, with and without colours."""
    yield from new_morph()
    assembly().Energy = "steel"
    App.ActiveDocument.recompute()
    yield from open_panel()
    for colours in (0, 1, 4):
        child("colours").setCurrentIndex(colours)
        yield from settled()
        before, seen = places(panel()), set()
        for value in (5.0, 18.0, 30.0):
            child("translation_z").setValue(value)
            for _ in range(120):
                seen.add(child("status").text()[:24])
                assert not moved(before, places(panel())), moved(before, places(panel()))
                yield POLL
            yield from settled()
            assert not moved(before, places(panel())), moved(before, places(panel()))
        assert len(seen) > 2, seen
    yield from press("Cancel")

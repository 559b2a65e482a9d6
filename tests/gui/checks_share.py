# SPDX-License-Identifier: LGPL-2.1-or-later
"""The slider from before to after shows a share of the motion, and the document keeps all of it."""

import FreeCAD as App
import numpy as np
from checks_dragging import drag_up, grab_up_arrow
from checks_moving import lifted, open_panel
from desk import (
    child,
    enter,
    on_screen,
    picture,
    press,
    settled,
    tick,
    until,
    within_reach,
    xdotool,
)
from PySide import QtCore
from scenes import drawn, new_morph, regions, stored

__all__ = [
    "test_the_slider_shows_a_share_and_changes_nothing",
    "test_a_drag_returns_the_slider_to_the_full_motion",
]


def slide(share: float):
    """Drags the slider with the mouse from where it is."""
    slider = child("share")
    yield from within_reach(slider)
    room = slider.width() - 16

    def place(value: float):
        x = 8 + round(room * value)
        return slider.mapToGlobal(QtCore.QPoint(x, slider.height() // 2))

    start, end = place(slider.value() / 100.0), place(share)
    yield from xdotool("mousemove", start.x(), start.y())
    yield from xdotool("mousedown", 1)
    for k in range(1, 5):
        yield from xdotool("mousemove", start.x() + (end.x() - start.x()) * k // 4, start.y())
    yield from xdotool("mouseup", 1)
    yield from settled()


def test_the_slider_shows_a_share_and_changes_nothing():
    yield from new_morph()
    rest = stored()
    yield from open_panel()
    yield from enter(child("translation_z"), "20")
    yield from enter(child("angle"), "30")
    yield from settled()
    moved = stored()
    yield from slide(0.5)
    share = child("share").value() / 100.0
    assert 0.3 < share < 0.7, share
    shown = lifted(rest, drawn()).mean(axis=0)
    assert np.allclose(shown, (0, 0, 20.0 * share), atol=1e-3), shown
    assert f"Shown at {100 * share:.0f} %" in child("status").text(), child("status").text()
    picture("share")
    assert child("translation_z").value() == 20.0 and np.array_equal(stored(), moved)
    yield from slide(0.0)
    assert child("share").value() == 0 and np.allclose(drawn(), rest, atol=1e-4)
    assert np.array_equal(stored(), moved)
    yield from press("OK")
    assert np.array_equal(stored(), drawn()) and np.allclose(stored(), moved, atol=1e-4)
    assert App.ActiveDocument.UndoNames == ["Move Handle"]
    yield from open_panel()
    yield from slide(0.3)
    yield from press("Cancel")
    assert np.array_equal(stored(), drawn()) and np.allclose(stored(), moved, atol=1e-4)
    App.ActiveDocument.undo()
    assert np.array_equal(stored(), rest)


def test_a_drag_returns_the_slider_to_the_full_motion():
    yield from new_morph()
    rest = stored()
    yield from open_panel()
    yield from enter(child("translation_z"), "12")
    yield from settled()
    yield from slide(0.4)
    start = yield from grab_up_arrow((0.0, 0.0, 12.0))
    yield from drag_up(start)
    yield from xdotool("mouseup", 1)
    yield from settled()
    height = child("translation_z").value()
    assert height > 14.0 and child("share").value() == 100
    yield from until(lambda: abs(lifted(rest, drawn())[0, 2] - height) < 1e-3, "all of it")
    yield from slide(0.2)
    yield from tick(child("points"))
    x, y = on_screen((60.0, 0.0, 0.0))
    yield from xdotool("mousemove", x, y - 3, "mousedown", 1)
    yield from xdotool("mouseup", 1)
    yield from settled()
    assert child("share").value() == 100 and len(regions("handle")) == 1
    yield from press("Cancel")
    assert np.array_equal(stored(), rest)

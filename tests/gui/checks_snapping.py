# SPDX-License-Identifier: LGPL-2.1-or-later
"""A drag snaps to steps and to points of parts; Ctrl and Shift reverse the choice."""

import FreeCAD as App
import numpy as np
from checks_dragging import drag_up, grab_up_arrow, handle_place, preferring
from checks_moving import lifted, open_panel
from checks_showing import found
from desk import child, on_screen, picture, press, settled, tick, until, view, xdotool
from freecad.sheetmorph.interaction import snapping
from pivy import coin
from scenes import drawn, labelled, new_assembly, new_morph, regions, stored

__all__ = [
    "test_ctrl_reverses_the_choice_of_steps_during_a_drag",
    "test_an_arrow_goes_level_with_the_vertex_under_the_mouse",
    "test_a_dragged_point_meets_a_vertex_of_another_part",
]


def marked() -> list[np.ndarray]:
    """The points that are marked as snapped to."""
    marks = [n for n in found(coin.SoAnnotation, view().getSceneGraph())]
    marks = [n for n in marks if n.getName() == snapping.MARK]
    points = [p.getValue() for m in marks for n in found(coin.SoCoordinate3, m) for p in n.point]
    return [np.array(point) for point in points]


def translation() -> np.ndarray:
    return np.array([child(f"translation_{c}").value() for c in "xyz"])


def test_ctrl_reverses_the_choice_of_steps_during_a_drag():
    with preferring(SnapLength=2.0):
        yield from new_morph()
        yield from open_panel()
        assert not child("snap").isChecked()
        start = yield from grab_up_arrow()
        yield from xdotool("keydown", "ctrl")
        yield from drag_up(start)
        with_key = translation()
        yield from xdotool("keyup", "ctrl")
        yield from drag_up(start, 6)
        without_key = translation()
        yield from xdotool("mouseup", 1)
        assert with_key[2] >= 4.0 and with_key[2] % 2.0 == 0.0, with_key
        assert without_key[2] > with_key[2] and without_key[2] % 2.0 > 0.0, without_key
        yield from press("Cancel")


def test_an_arrow_goes_level_with_the_vertex_under_the_mouse():
    yield from new_morph()
    rest = stored()
    yield from open_panel()
    start = yield from grab_up_arrow()
    yield from xdotool("keydown", "shift")
    yield from drag_up(start, 1)
    yield from settled()
    corner = np.array([0.0, 60.0, 20.0])
    yield from xdotool("mousemove", *on_screen(corner))
    yield from until(lambda: len(marked()) == 1, "the mark")
    picture("snap-level")
    assert np.allclose(marked()[0], corner, atol=1e-4), marked()
    wanted = (0.0, 0.0, corner[2] - handle_place()[2])
    assert np.allclose(translation(), wanted, atol=1e-3), translation()
    yield from until(lambda: np.allclose(lifted(rest, drawn()), wanted, atol=1e-3), "the view")
    yield from xdotool("mouseup", 1, "keyup", "shift")
    yield from settled()
    assert np.allclose(translation(), wanted, atol=1e-3) and not marked()
    yield from press("OK")
    assert np.allclose(lifted(rest, stored()), wanted, atol=1e-3)
    App.ActiveDocument.undo()
    assert np.array_equal(stored(), rest)


def test_a_dragged_point_meets_a_vertex_of_another_part():
    yield from new_assembly(is_joined=True)
    rest = stored()
    target = stored(labelled("bracket")).max(axis=0)
    yield from open_panel()
    yield from tick(child("points"))
    yield from tick(child("snap_points"))
    grabbed = np.array([120.0, 55.0, 15.0])
    yield from xdotool("mousemove", *on_screen(grabbed))
    yield from xdotool("mousedown", 1)
    yield from settled()
    x, y = on_screen(target)
    yield from xdotool("mousemove", x + 40, y, "mousemove", x + 3, y)
    yield from until(lambda: len(marked()) == 1, "the mark")
    picture("snap-point")
    assert np.allclose(marked()[0], target, atol=1e-4), marked()
    assert np.allclose(translation(), target - grabbed, atol=1e-3), translation()
    yield from xdotool("key", "Escape")
    yield from settled()
    assert np.allclose(translation(), 0.0) and not marked()
    yield from xdotool("mouseup", 1)
    yield from press("Cancel")
    assert np.array_equal(stored(), rest) and len(regions("handle")) == 1

# SPDX-License-Identifier: LGPL-2.1-or-later
"""A handle moves along its own axes, and the choice alone changes nothing."""

import gc

import FreeCAD as App
import numpy as np
from checks_moving import lifted, open_panel
from desk import child, choose_below, enter, on_screen, picture, press, settled, until, xdotool
from freecad.sheetmorph import api
from freecad.sheetmorph.interaction.handle_drag import HandleDrag
from freecad.sheetmorph.objects import model
from scenes import assembly, drawn, handle_vertices, new_morph, part, regions, stored
from shapes import sheet

__all__ = [
    "test_a_typed_length_goes_along_the_normal_of_the_handle",
    "test_the_arrows_follow_the_axes_of_the_handle",
    "test_an_expression_keeps_the_global_axes",
]


def test_a_typed_length_goes_along_the_normal_of_the_handle():
    """The flange at x = 120 stands up: its normal is along x, its longest direction along y."""
    yield from new_morph()
    rest = stored()
    yield from open_panel()
    assert child("axes").currentText() == "Global axes"
    yield from enter(child("translation_y"), "3")
    yield from settled()
    yield from choose_below(child("axes"), 1)
    assert np.isclose(abs(child("translation_x").value()), 3.0)
    assert child("translation_y").value() == child("translation_z").value() == 0.0
    assert np.allclose(lifted(rest, drawn()), (0, 3, 0), atol=1e-4)
    yield from enter(child("translation_x"), "0")
    yield from enter(child("translation_z"), "5")
    yield from settled()
    shown = lifted(rest, drawn())
    assert np.allclose(np.abs(shown), (5, 0, 0), atol=1e-4), shown[0]
    picture("local-axes")
    yield from choose_below(child("axes"), -1)
    assert abs(child("translation_x").value()) == 5.0
    yield from choose_below(child("axes"), 1)
    yield from press("OK")
    assert abs(regions("handle")[0].TranslationX.Value) == 5.0
    assert App.ActiveDocument.UndoNames == ["Move Handle"]
    App.ActiveDocument.undo()
    assert np.array_equal(stored(), rest)
    yield from open_panel()
    assert child("axes").currentText() == "Local axes", "the choice is remembered"
    yield from press("Cancel")
    assert np.array_equal(stored(), rest)


def test_the_arrows_follow_the_axes_of_the_handle():
    yield from new_morph()
    points, _ = sheet()
    api.remove(regions("handle")[0])
    api.add_handle(assembly(), part(), handle_vertices() + vertices_of_fold(points))
    App.ActiveDocument.recompute()
    rest = stored()
    yield from open_panel()
    yield from choose_below(child("axes"), 1)
    axes = axes_in_use()
    normal = axes[:, 2]
    moved = model.vertices(regions("handle")[0])
    place = np.mean(rest[moved], axis=0)
    start, end = on_screen(place), on_screen(place + 10.0 * normal)
    way = np.array(end) - start
    way = way / np.linalg.norm(way)
    grab = np.array(start) + 40.0 * way
    yield from xdotool("mousemove", *(int(v) for v in np.round(grab)))
    yield from xdotool("mousedown", 1)
    for step in range(1, 6):
        yield from xdotool("mousemove", *(int(v) for v in np.round(grab + 8.0 * step * way)))
    picture("local-arrows")
    shift = np.array([child(f"translation_{c}").value() for c in "xyz"])
    yield from xdotool("mouseup", 1)
    yield from settled()
    assert shift[2] > 2.0 and np.allclose(shift[:2], 0.0, atol=1e-6), shift
    shown = (drawn() - rest)[moved]
    assert np.allclose(shown, shift[2] * normal, atol=1e-3), shown[0]
    yield from press("Cancel")
    assert np.array_equal(stored(), rest)


def vertices_of_fold(points) -> list[int]:
    """A strip of the floor next to the flange, so that the normal of both is oblique."""
    return np.flatnonzero((points[:, 0] >= 110.0) & (points[:, 2] == 0.0)).tolist()


def axes_in_use() -> np.ndarray:
    """The axes of the drag of the open panel."""
    drags = [one for one in gc.get_objects() if isinstance(one, HandleDrag)]
    (drag,) = [one for one in drags if not one._owner.session.is_over]
    return drag._moving.axes


def test_an_expression_keeps_the_global_axes():
    yield from new_morph()
    regions("handle")[0].setExpression("TranslationY", "4 mm")
    App.ActiveDocument.recompute()
    yield from open_panel()
    assert not child("axes").isEnabled() and child("axes").currentText() == "Global axes"
    yield from until(lambda: child("translation_y").value() == 4.0, "the expression")
    yield from press("Cancel")

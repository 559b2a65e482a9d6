# SPDX-License-Identifier: LGPL-2.1-or-later
"""Regions are picked by figures drawn on the screen, and by the tools that go with them."""

import math
import time

import FreeCADGui as Gui
import numpy as np
from desk import child, click_point, click_widget, colour_at, draw_along, enter, on_screen, picture
from desk import press, press_tool, settled, tick, until, view, xdotool
from freecad.sheetmorph import api
from freecad.sheetmorph.bridge import kernel
from freecad.sheetmorph.objects import model
from freecad.sheetmorph.scene.figure import Figure
from freecad.sheetmorph.scene.viewport import Listener, Viewport
from PySide import QtCore, QtGui
from scenes import fit, handle_vertices, labelled, new_assembly, new_morph, part, regions
from shapes import HOLES, sheet

__all__ = [
    "test_the_camera_maps_points_to_where_the_view_shows_them",
    "test_a_lasso_takes_what_it_runs_round",
    "test_a_lasso_keeps_its_corners_while_the_view_is_slow",
    "test_rectangles_replace_add_and_remove",
    "test_a_brush_paints_as_wide_as_the_wheel_says",
    "test_what_another_part_hides_is_taken_only_when_asked_for",
    "test_escape_ends_a_figure_and_enter_is_ok",
    "test_a_click_on_another_part_changes_to_it_as_long_as_nothing_is_picked",
    "test_hover_shows_what_a_click_takes_and_vertices_are_picked_singly",
    "test_faces_end_at_the_angle_and_invert_takes_the_rest",
]


def top() -> None:
    """The whole morph from above."""
    view().viewTop()
    fit()


def ring(x: float, y: float, radius: float) -> list[tuple]:
    """Places around a point, closed."""
    angles = [2.0 * math.pi * k / 24 for k in range(25)]
    return [(x + radius * math.cos(a), y + radius * math.sin(a), 0.0) for a in angles]


def picked_in(role: str, which=None) -> np.ndarray:
    """The rest positions of the vertices of the newest region of a role."""
    return api.rest_mesh(which or part())[0][model.vertices(regions(role)[-1])]


def start(command: str, tool: str):
    """Opens a picking panel, seen from above, with a tool chosen."""
    top()
    yield from settled()
    yield from press_tool(command)
    yield from click_widget(child(tool))


def px_per_mm() -> float:
    """Of the view from above."""
    return math.dist(on_screen((0, 0, 0)), on_screen((100, 0, 0))) / 100.0


def test_the_camera_maps_points_to_where_the_view_shows_them():
    yield from new_morph()
    frame = Gui.getMainWindow().findChild(QtGui.QMdiArea).subWindowList()[0]
    frame.showNormal()
    for kind in ("Orthographic", "Perspective"):
        for size in ((700, 400), (300, 520)):
            view().setCameraType(kind)
            frame.resize(*size)
            view().viewIsometric()
            Gui.SendMsgToActiveView("ViewFit")
            yield from settled()
            viewport = Viewport(view(), Listener())
            camera, widget = viewport.camera(), viewport.widget
            screen = QtGui.QImage(picture("camera"))
            for point, strongest in (((0, 30, 12), "blue"), ((120, 30, 12), "red")):
                x, y, _ = kernel.core().Screen(*vars(camera).values()).seen(point)
                near, far = camera.line(x, y)
                off = np.cross(np.subtract(point, near), (far - near) / np.linalg.norm(far - near))
                assert np.linalg.norm(off) < 1e-3
                place = widget.mapToGlobal(QtCore.QPoint(round(x), widget.height() - 1 - round(y)))
                colour = screen.pixelColor(place)
                seen = {"red": colour.red(), "green": colour.green(), "blue": colour.blue()}
                assert max(seen, key=seen.get) == strongest, (kind, size, seen)
                assert max(seen.values()) > 2 * min(seen.values()), (kind, size, seen)
            viewport.remove()
    view().setCameraType("Orthographic")
    frame.showMaximized()
    yield from settled()


def test_a_lasso_takes_what_it_runs_round():
    yield from new_morph()
    yield from start("Mark Form Features…", "lasso")
    x, y, radius = HOLES[0]
    yield from draw_along(ring(x, y, radius + 6))
    picture("picking-lasso")
    yield from press("OK")
    away = np.linalg.norm(sheet()[0][:, :2] - (x, y), axis=1)
    taken = np.isin(np.arange(len(away)), model.vertices(regions("form feature")[-1]))
    assert taken[away < radius + 5.5].all() and not taken[away > radius + 6.3].any()
    assert np.count_nonzero(taken) > 40


def test_a_lasso_keeps_its_corners_while_the_view_is_slow():
    yield from new_morph()
    yield from start("Mark Form Features…", "lasso")
    x, y, radius = HOLES[0]
    corners = [on_screen(place) for place in ring(x, y, radius + 6)]
    quick = Figure.show_outline

    def slow(figure, outline):
        time.sleep(0.05)
        quick(figure, outline)

    Figure.show_outline = slow
    try:
        yield from xdotool("mousemove", *corners[0], "mousedown", 1)
        moves = [word for place in corners for word in ("mousemove", *place)]
        yield from xdotool(*moves, "mouseup", 1)
        yield from until(lambda: "piece" in child("count").text(), "the figure to be taken")
    finally:
        Figure.show_outline = quick
    yield from press("OK")
    away = np.linalg.norm(sheet()[0][:, :2] - (x, y), axis=1)
    taken = np.isin(np.arange(len(away)), model.vertices(regions("form feature")[-1]))
    assert taken[away < radius + 5.5].all() and not taken[away > radius + 6.3].any()
    compress = QtCore.Qt.AA_CompressHighFrequencyEvents
    assert QtCore.QCoreApplication.testAttribute(compress), "only while a figure is drawn"


def test_rectangles_replace_add_and_remove():
    yield from new_morph()
    yield from start("Mark Handle…", "rectangle")
    yield from draw_along([(101, 41, 0), (111, 52, 0)])
    yield from draw_along([(11, 41, 0), (21, 52, 0)])
    first = child("count").text()
    assert ", 1 piece" in first, "a figure without a key starts anew"
    yield from draw_along([(101, 11, 0), (111, 19, 0)], "shift")
    assert ", 2 piece" in child("count").text()
    yield from draw_along([(9, 39, 0), (23, 54, 0)], "ctrl")
    yield from draw_along([(60, 100, 0), (70, 110, 0)])
    assert ", 1 piece" in child("count").text(), "an empty figure changes nothing"
    yield from click_widget(child("mode_add"))
    yield from draw_along([(11, 41, 0), (21, 52, 0)])
    assert ", 2 piece" in child("count").text()
    yield from press("OK")
    points = picked_in("handle")
    assert set(points[:, 0]) == {12.5, 15.0, 17.5, 20.0, 102.5, 105.0, 107.5, 110.0}
    assert set(points[points[:, 0] > 60, 1]) == {12.5, 15.0, 17.5}


def test_a_brush_paints_as_wide_as_the_wheel_says():
    yield from new_morph()
    yield from start("Mark Fixed Region…", "brush")
    before = child("radius").value()
    height = view().getCameraNode().getField("height").get()
    yield from xdotool("mousemove", *on_screen((60, 8, 0)))
    yield from xdotool("click", 4, "click", 4)
    radius = child("radius").value()
    assert radius > before
    assert view().getCameraNode().getField("height").get() == height, "the wheel does not zoom now"
    yield from draw_along([(20, 8, 0), (100, 8, 0)])
    picture("picking-brush")
    yield from xdotool("click", 5, "click", 5)
    yield from draw_along([(60, 2, 0), (60, 4, 0)], "ctrl")
    width = radius / px_per_mm()
    yield from press("OK")
    points, ends = sheet()[0], np.array([[20.0, 8.0], [100.0, 8.0]])
    along = np.clip(points[:, 0], ends[0, 0], ends[1, 0])
    away = np.hypot(points[:, 0] - along, points[:, 1] - 8.0)
    taken = np.isin(np.arange(len(points)), model.vertices(regions("fixed")[-1]))
    erased = np.hypot(points[:, 0] - 60, points[:, 1] - 3) < width
    assert taken[(away < width - 0.5) & ~erased].all() and not taken[away > width + 0.5].any()
    assert not taken[np.hypot(points[:, 0] - 60, points[:, 1] - 3) < 2].any()


def test_what_another_part_hides_is_taken_only_when_asked_for():
    yield from new_assembly()
    Gui.Selection.clearSelection()
    yield from start("Mark Fixed Region…", "rectangle")
    box = [(45, 41, 0), (73, 58, 0)]
    for is_through in (False, True):
        if is_through:
            yield from tick(child("through"))
        yield from draw_along(box)
        yield from press("OK")
        yield from start("Mark Fixed Region…", "rectangle")
    yield from press("Cancel")
    seen, all_of_it = (api.rest_mesh(part())[0][model.vertices(r)] for r in regions("fixed")[-2:])
    hidden = [(p[:, 0] >= 52.0) & (p[:, 0] <= 66.0) & (p[:, 1] >= 45.0) for p in (seen, all_of_it)]
    assert not hidden[0].any() and hidden[1].sum() > 20 and len(seen) > 20
    assert len(seen) + hidden[1].sum() == len(all_of_it)


def test_escape_ends_a_figure_and_enter_is_ok():
    yield from new_morph()
    yield from start("Mark Handle…", "lasso")
    yield from xdotool("mousemove", *on_screen((20, 10, 0)), "mousedown", 1)
    for place in ring(60, 30, 40)[::2]:
        yield from xdotool("mousemove", *on_screen(place))
    picture("picking-drawing")
    yield from xdotool("key", "Escape")
    yield from xdotool("mouseup", 1)
    yield from settled()
    assert Gui.Control.activeDialog() and "Nothing" in child("count").text()
    yield from draw_along(ring(100, 45, 8))
    assert "nothing" not in child("count").text()
    yield from xdotool("key", "Return")
    yield from until(lambda: not Gui.Control.activeDialog(), "the panel to close")
    assert len(picked_in("handle")) > 10 and len(regions("handle")) == 2


def test_a_click_on_another_part_changes_to_it_as_long_as_nothing_is_picked():
    yield from new_assembly(is_joined=True)
    Gui.Selection.clearSelection()
    yield from start("Mark Follower…", "facet")
    assert part().Label in child("part").text()
    on_bracket = (59.3, 95.2, 1)
    yield from click_point(on_bracket)
    bracket = labelled("bracket")
    assert bracket.Label in child("part").text() and "Nothing" in child("count").text()
    yield from click_point(on_bracket)
    yield from click_point((20.5, 12.0, 0))
    assert bracket.Label in child("part").text(), "something is picked: the part stays"
    yield from press("OK")
    (follower,) = regions("follower")
    assert follower.Part == bracket and len(model.vertices(follower)) == 3


def test_hover_shows_what_a_click_takes_and_vertices_are_picked_singly():
    yield from new_morph()
    yield from start("Mark Fixed Region…", "face")
    place = (20.5, 12.0, 0)
    before = colour_at(place)
    x, y = on_screen(place)
    yield from xdotool("mousemove", x - 2, y - 2, "mousemove", x, y)
    yield from settled()

    def is_yellow() -> bool:
        red, _, blue = colour_at((30.5, 50.0, 0))
        return blue < before[2] - 20 and red > blue + 60

    yield from until(is_yellow, "the face under the mouse to be yellow")
    yield from click_widget(child("vertex"))
    yield from click_point((20.5, 12.2, 0))
    yield from click_point((45.3, 9.8, 0), "shift")
    yield from press("OK")
    assert picked_in("fixed")[:, :2].tolist() == [[20.0, 12.5], [45.0, 10.0]]


def picked_vertices() -> int:
    """What the panel says: "Picked: 93 vertices, 1 piece"."""
    return int(child("count").text().split()[1])


def test_faces_end_at_the_angle_and_invert_takes_the_rest():
    yield from new_morph()
    yield from start("Mark Fixed Region…", "face")
    yield from click_point((20.5, 12.0, 0))
    yield from until(lambda: "piece" in child("count").text(), "the face to be picked")
    flat = picked_vertices()
    yield from click_widget(child("invert"))
    rest = picked_vertices()
    assert flat + rest == len(sheet()[0]) - len(handle_vertices())
    assert regions("handle")[0].Label in child("message").text(), "whose the others are"
    assert ", 1 piece" in child("count").text(), "the other flange"
    yield from enter(child("angle"), "95")
    yield from click_point((20.5, 12.0, 0))
    assert f"{flat + rest} vertices" in child("count").text()
    yield from click_widget(child("clear"))
    assert "Nothing" in child("count").text()
    yield from press("Cancel")

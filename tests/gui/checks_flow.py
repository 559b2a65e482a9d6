# SPDX-License-Identifier: LGPL-2.1-or-later
"""The complete flow on the examples, by mouse: mark, drag, type, undo, save, reopen, drag again.

What is done is recorded as a macro; replayed without a window it gives the same bits.
"""

import os

import FreeCAD as App
import FreeCADGui as Gui
import numpy as np
from checks_finding import press_ok
from checks_macro import Replay, calls_in, start_recording, stop_recording
from checks_moving import open_panel
from desk import WORK, activate, child, click_point, click_widget, draw_along, enter, import_files
from desk import on_screen, picture, press, press_tool, settled, tick, view, xdotool
from freecad.sheetmorph import api, paths
from freecad.sheetmorph.actions import DOCUMENT, call, name, record
from freecad.sheetmorph.commands import exchange
from freecad.sheetmorph.objects import model
from freecad.sheetmorph.qt import QtWidgets
from scenes import assembly, contacts, drawn, fit, labelled, largest, regions, stored
from scenes import stored_of_all

__all__ = [
    "test_the_door_mirror_from_files_to_a_second_drag",
    "test_the_frame_of_14_parts_from_regions_to_a_second_drag",
]


def count_of_parts() -> int:
    """How many parts the document has; none without a document."""
    objects = App.ActiveDocument.Objects if App.ActiveDocument else []
    return sum(model.kind(obj) == model.PART for obj in objects)


def import_mirror():
    """Import Part… without a document, its dialog answered."""
    folder = os.path.join(paths.examples(), "door_mirror")
    files = [os.path.join(folder, file) for file in ("cover.obj", "frame.ply", "foot.obj")]
    yield from import_files(files, 0.0, lambda: count_of_parts() == 3)


def select(obj) -> None:
    """As a click in the tree does."""
    Gui.Selection.clearSelection()
    Gui.Selection.addSelection(obj)


def look(direction: str):
    """Front, Top or Isometric, everything in the view."""
    getattr(view(), f"view{direction}")()
    fit()
    yield from settled()


def loop_round(points: np.ndarray, axes, margin: float) -> list[tuple]:
    """A closed outline around points (n, 3), a margin outside of their box along two axes."""
    low, high = points.min(axis=0) - margin, points.max(axis=0) + margin
    first, second = axes
    places = []
    for a, b in ((0, 0), (1, 0), (1, 1), (0, 1), (0, 0)):
        place = points.mean(axis=0)
        place[first], place[second] = (low, high)[a][first], (low, high)[b][second]
        places.append(tuple(place))
    return places


def stroke_along(points: np.ndarray, along: int) -> list[tuple]:
    """From one end of points (n, 3) to the other along an axis, through their middle."""
    ends = np.repeat(points.mean(axis=0)[None], 2, axis=0)
    ends[:, along] = points[:, along].min(), points[:, along].max()
    return [tuple(end) for end in ends]


def draw_region(part, command: str, tool: str, figure: list):
    """Marks a region of a part with a figure drawn through everything."""
    select(part)
    yield from press_tool(command)
    yield from click_widget(child(tool))
    yield from tick(child("through"))
    yield from draw_along(figure)
    assert "Picked" in child("count").text(), (command, child("count").text())
    picture(f"flow-{tool}")
    yield from press("OK")
    yield from settled()


def click_rims(part, rims: list, image: str):
    """Marks holes of a part as form features: a click into each, near its rim.

    On the rim itself another part with the same hole may hide it, by less than a pixel.
    """
    select(part)
    points = api.rest_mesh(part)[0]
    yield from press_tool("Mark Form Features…")
    for rim, key in zip(rims, ["", *["shift"] * len(rims)]):
        yield from click_point((points[rim[0]] + points[rim].mean(axis=0)) / 2.0, key)
    picture(image)
    yield from press("OK")
    made = [model.vertices(r).tolist() for r in regions("form feature") if r.Part == part]
    assert sorted(made) == sorted(rims)


def handle_place() -> tuple[int, int]:
    """Where the handle's arrows are, pixels of the screen."""
    handle = regions("handle")[0]
    shift = (handle.TranslationX, handle.TranslationY, handle.TranslationZ)
    return on_screen(np.array(tuple(api.pivot(handle))) + [float(s.Value) for s in shift])


def bring_beside_the_panel():
    """Zooms out until the handle is seen: since FreeCAD 1.0 a panel may lie over the 3D view."""
    viewport = view().graphicsView().viewport()
    while viewport != QtWidgets.QApplication.widgetAt(*handle_place()):
        view().zoomOut()
        yield from settled()


def pull_arrow_up(pixels: int = 48):
    """Drags the arrow that points up on the screen, whatever stands before it, and lets go."""
    x, y = handle_place()
    before = child("translation_z").value()
    yield from xdotool("mousemove", x, y - 30, "mousedown", 1)
    for step in range(12, pixels + 1, 12):
        yield from xdotool("mousemove", x, y - 30 - step)
    yield from xdotool("mouseup", 1)
    yield from settled()
    assert child("translation_z").value() > before + 1.0, "the arrow was not dragged"


def drag_arrow_up(pixels: int = 48):
    """The same, and waits until all that follows from it is known."""
    yield from pull_arrow_up(pixels)
    yield from settled()


def move(words: dict, image: str):
    """Drags the triad, types numbers, OK."""
    yield from open_panel()
    yield from bring_beside_the_panel()
    yield from drag_arrow_up()
    for field, text in words.items():
        yield from enter(child(field), text)
    yield from settled()
    picture(image)
    yield from press_ok()


def close_and_open(file: str):
    """Saves, closes and opens the active document."""
    path = os.path.join(WORK, file)
    App.ActiveDocument.saveAs(path)
    App.closeDocument(App.ActiveDocument.Name)
    yield from settled()
    App.openDocument(path)
    yield from settled()


def move_replay_and_reopen(words: dict, flow: str):
    """From marked regions to a second drag, in a macro that is being recorded."""
    rest = stored_of_all()
    yield from move(words, f"{flow}-dragged")
    moved = stored_of_all()
    assert largest(moved - rest) > 5.0
    yield from stop_recording(flow)
    assert calls_in(flow)[-1] == "set_motion"
    replayed = Replay(flow)
    App.ActiveDocument.undo()
    assert np.array_equal(stored_of_all(), rest)
    App.ActiveDocument.redo()
    assert np.array_equal(stored_of_all(), moved)
    yield from close_and_open(f"{flow}.FCStd")
    assert np.array_equal(stored_of_all(), moved)
    yield from move({}, f"{flow}-again")
    assert largest(stored_of_all() - moved) > 1.0
    for part in model.parts(assembly()):
        assert part.State == ["Up-to-date"] and np.array_equal(stored(part), drawn(part))
    yield from replayed.finish()


def test_the_door_mirror_from_files_to_a_second_drag():
    yield from activate()
    yield from start_recording("mirror")
    yield from import_mirror()
    cover = labelled("cover")
    points = api.rest_mesh(cover)[0]
    share = (points[:, 0] - points[:, 0].min()) / np.ptp(points[:, 0])
    yield from look("Front")
    inboard, tip = points[share < 0.12], points[share > 0.9]
    yield from draw_region(cover, "Mark Fixed Region…", "lasso", loop_round(inboard, (0, 2), 4.0))
    yield from draw_region(cover, "Mark Handle…", "brush", stroke_along(tip, 2))
    yield from click_rims(cover, api.hole_rims(cover), "mirror-loops")
    yield from press_tool("Find Contacts…")
    count = Gui.Control.activeDialog() and child("count").text()
    assert count.endswith("selected parts only"), count
    yield from press("Cancel")
    Gui.Selection.clearSelection()
    yield from press_tool("Find Contacts…")
    yield from press_ok()
    assert len(contacts()) > 1 and assembly().Unreached == []
    yield from look("Isometric")
    yield from move_replay_and_reopen({"translation_y": "12 mm", "angle": "-6"}, "mirror")


def test_the_frame_of_14_parts_from_regions_to_a_second_drag():
    yield from activate()
    yield from start_recording("frame")
    assert exchange.open_recipe(exchange.example_recipes()["Welded Frame"], "Frame")
    rail = labelled("rail left")
    points = api.rest_mesh(rail)[0]
    old = [r for r in model.regions(assembly()) if r.Part == rail]
    ends = {r.Role: points[model.vertices(r)] for r in old if r.Role != "form feature"}
    record(*[call("remove", name(r)) for r in old], f"{DOCUMENT}.recompute()")
    yield from look("Top")
    held, pulled = loop_round(ends["fixed"], (0, 1), 4.0), stroke_along(ends["handle"], 1)
    yield from draw_region(rail, "Mark Fixed Region…", "lasso", held)
    yield from draw_region(rail, "Mark Handle…", "brush", pulled)
    seen = [rim for rim in api.hole_rims(rail) if np.ptp(points[rim][:, 2]) == 0.0]
    yield from click_rims(rail, seen, "frame-loops")
    assert len(seen) == 4 and len(model.parts(assembly())) == 14 and assembly().Unreached == []
    yield from look("Isometric")
    yield from move_replay_and_reopen({"translation_x": "0.5 cm"}, "frame")

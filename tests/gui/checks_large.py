# SPDX-License-Identifier: LGPL-2.1-or-later
"""How long picking takes on 20 parts of together a million facets, and opening a document of 100
form features on 100,000 vertices. It is reported."""

import os
import time

import FreeCAD as App
import FreeCADGui as Gui
import numpy as np
from checks_finding import press_ok
from desk import WORK, activate, child, click_point, click_widget, draw_along, note, on_screen
from desk import picture, settled, until, view, xdotool
from freecad.sheetmorph import api
from freecad.sheetmorph.bridge import conversion
from freecad.sheetmorph.interaction.pick_mouse import PickMouse
from shapes import grid_triangles

__all__ = [
    "test_picking_on_20_parts_of_50000_facets_is_measured",
    "test_opening_100_features_on_100000_vertices_is_measured",
]


class Stopwatch:
    """How long the picking tools take for what the mouse does, ms by name of the method: by the
    clock, and of the processor."""

    def __init__(self):
        self.taken = {name: [] for name in ("on_move", "on_click", "on_drag", "on_release")}

    def __enter__(self):
        self._before = {name: getattr(PickMouse, name) for name in self.taken}
        for name, method in self._before.items():
            setattr(PickMouse, name, self._timed(name, method))
        return self

    def __exit__(self, *_):
        for name, method in self._before.items():
            setattr(PickMouse, name, method)

    def _timed(self, name, method):
        def timed(*arguments):
            begin = time.perf_counter(), time.process_time()
            method(*arguments)
            ends = time.perf_counter(), time.process_time()
            self.taken[name].append([1000.0 * (end - start) for start, end in zip(begin, ends)])

        return timed

    def told(self, name: str, what: str) -> str:
        """Median and worst of what was done since the last time, in words."""
        taken, self.taken[name] = self.taken[name], []
        wall, own = np.transpose(taken)
        worst = f"worst {wall.max():.0f}, of processor {np.median(own):.1f}"
        return f"{what} {np.median(wall):.1f} ({worst})"


def twenty_sheets():
    """A morph of 20 curved parts of 50,562 facets each, five in a row."""
    yield from activate()
    document = App.newDocument("Twenty")
    side = 160
    x, y = np.meshgrid(np.linspace(0, 95, side), np.linspace(0, 95, side), indexing="ij")
    flat = np.stack([x.ravel(), y.ravel(), 4.0 * np.sin(x.ravel() / 15.0)], axis=1)
    writer = conversion.MeshWriter(grid_triangles(side, side).astype(np.int32))
    morph = api.create_assembly(document)
    for k in range(20):
        source = document.addObject("Mesh::Feature", f"Sheet{k}")
        source.Mesh = writer.mesh(flat + (100.0 * (k % 5), 100.0 * (k // 5), 0.0))
        api.add_part(morph, source)
    document.recompute()
    view().viewTop()
    Gui.SendMsgToActiveView("ViewFit")
    yield from settled()


def test_picking_on_20_parts_of_50000_facets_is_measured():
    yield from twenty_sheets()
    with Stopwatch() as watch:
        begin = time.monotonic(), time.process_time()
        Gui.runCommand("SheetMorph_MarkFixed")
        wall, own = time.monotonic() - begin[0], time.process_time() - begin[1]
        told = [f"open {1000.0 * wall:.0f} (of processor {1000.0 * own:.0f})"]
        yield from settled()
        places = [on_screen((4.0 * k + 5.0, 45.0, 0.0)) for k in range(20)]
        for tool in ("face", "rim", "facet"):
            yield from click_widget(child(tool))
            watch.taken["on_move"].clear()
            yield from xdotool(*[word for place in places for word in ("mousemove", *place)])
            yield from xdotool(*[w for p in places for w in ("mousemove", *p, "sleep", 0.03)])
            told.append(watch.told("on_move", f"hover {tool}"))
        yield from click_point((45.0, 45.0, 0.0))
        told.append(watch.told("on_click", "click"))
        for tool in ("brush", "lasso", "rectangle"):
            yield from click_widget(child(tool))
            corners = [(10, 10), (80, 15), (85, 80), (12, 82)]
            path = [(x, y, 0.0) for x, y in corners[:: 2 if tool == "rectangle" else 1]]
            yield from draw_along(path)
            told += [watch.told("on_drag", f"draw {tool}"), watch.told("on_release", "take")]
        picture("picking-20-parts")
        yield from press_ok()
    note("picking on 20 parts of 50,562 facets, ms: " + "; ".join(told))


def save_100_features(path: str) -> None:
    """A document with a part of 100,489 vertices and 100 patches of 5 x 5 of them as features."""
    side = 317
    x, y = np.meshgrid(np.arange(side), np.arange(side), indexing="ij")
    points = np.stack([x.ravel(), y.ravel(), 4.0 * np.sin(x.ravel() / 15.0)], axis=1)
    document = App.newDocument("Hundred")
    source = document.addObject("Mesh::Feature", "Sheet")
    source.Mesh = conversion.MeshWriter(grid_triangles(side, side).astype(np.int32)).mesh(points)
    morph = api.create_assembly(document)
    part = api.add_part(morph, source)
    index = np.arange(side * side).reshape(side, side)
    for row in range(12, 312, 30):
        for column in range(12, 312, 30):
            api.add_feature(morph, part, index[row : row + 5, column : column + 5].ravel())
    document.saveAs(path)
    App.closeDocument(document.Name)


def test_opening_100_features_on_100000_vertices_is_measured():
    path = os.path.join(WORK, "hundred.FCStd")
    yield from activate()
    save_100_features(path)
    yield from settled()
    begin = (time.monotonic(), time.thread_time())
    document = App.openDocument(path)
    features = [o for o in document.Objects if getattr(o, "Role", "") == "form feature"]
    yield from until(lambda: all(f.ViewObject.Proxy.is_drawn for f in features), "all to be drawn")
    wall, own = time.monotonic() - begin[0], time.thread_time() - begin[1]
    view().viewTop()
    Gui.SendMsgToActiveView("ViewFit")
    yield from settled()
    picture("hundred-features")
    assert len(features) == 100
    drawn = [feature.ViewObject.Proxy.is_drawn for feature in features]
    assert all(drawn), f"{drawn.count(False)} of the regions are not drawn"
    note(
        f"opening 100 features on 100,489 vertices: {wall:.1f} s, {own:.1f} s without the renderer"
    )

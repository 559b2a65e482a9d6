# SPDX-License-Identifier: LGPL-2.1-or-later
"""How fast a drag is: frames a second, kernel and nodes apart from the renderer. It is reported."""

import time

import FreeCAD as App
import numpy as np
from checks_finding import press_ok
from checks_moving import open_panel
from desk import POLL, activate, child, note, on_screen, settled, view, xdotool
from freecad.sheetmorph import api
from freecad.sheetmorph.bridge import conversion
from freecad.sheetmorph.interaction.live_update import LiveUpdate
from scenes import drawn, largest, look, stored
from shapes import grid_triangles

__all__ = ["test_a_drag_of_100000_vertices_is_measured"]

SIDE = 317  # vertices along an edge: 100,489 in all


class Watch:
    """Keeps what every frame took, in ms."""

    def __init__(self):
        self.update, self.begin = [], 0.0

    def __enter__(self):
        self._before = LiveUpdate.on_answer

        def watched(live, answer):
            self._before(live, answer)
            self.update.append((live.kernel_ms, live.draw_ms, time.monotonic()))

        LiveUpdate.on_answer = watched
        return self

    def __exit__(self, *_):
        LiveUpdate.on_answer = self._before


def big_sheet():
    """A morph of one curved sheet: fixed at one edge, a handle at the other."""
    yield from activate()
    document = App.newDocument("Big")
    x, y = np.meshgrid(np.linspace(0, 600, SIDE), np.linspace(0, 400, SIDE), indexing="ij")
    points = np.stack([x.ravel(), y.ravel(), 15.0 * np.sin(x.ravel() / 60.0)], axis=1)
    source = document.addObject("Mesh::Feature", "Big")
    source.Mesh = conversion.MeshWriter(grid_triangles(SIDE, SIDE).astype(np.int32)).mesh(points)
    morph = api.create_assembly(document)
    part = api.add_part(morph, source)
    api.add_fixed(morph, part, np.flatnonzero(points[:, 0] < 20.0))
    api.add_handle(morph, part, np.flatnonzero(points[:, 0] > 580.0))
    document.recompute()
    look()
    yield from settled()


def render_ms(count: int = 5) -> float:
    """What drawing the view once takes, with nothing changed but the camera."""
    taken = []
    for _ in range(count):
        view().getCameraNode().touch()
        begin = time.monotonic()
        view().graphicsView().viewport().repaint()
        taken.append(1000.0 * (time.monotonic() - begin))
        yield POLL
    return float(np.median(taken))


def test_a_drag_of_100000_vertices_is_measured():
    yield from big_sheet()
    rest = stored()
    with Watch() as watch:
        yield from open_panel()
        child("results").setCurrentIndex(3)  # on OK: the frames alone
        handle = App.ActiveDocument.getObjectsByLabel("Handle")[0]
        x, y = on_screen(tuple(api.pivot(handle)))
        yield from xdotool("mousemove", x, y - 30, "mousedown", 1)
        yield from xdotool("mousemove", x, y - 36)
        yield from settled()  # the responses are worked out in the background meanwhile
        watch.update.clear()
        moves = [word for k in range(120) for word in ("mousemove", x, y - 40 - k, "sleep", 0.016)]
        yield from xdotool(*moves)
        frames = list(watch.update)
        yield from xdotool("mouseup", 1)
        render = yield from render_ms()
        yield from press_ok()
    assert len(frames) >= 3, len(frames)  # on a loaded machine with a software renderer
    assert largest(drawn() - rest) > 5.0
    kernel, nodes = (float(np.median([frame[k] for frame in frames])) for k in (0, 1))
    rate = (len(frames) - 1) / (frames[-1][2] - frames[0][2])
    note(
        f"drag of {SIDE * SIDE} vertices: {rate:.0f} frames/s; update {kernel + nodes:.1f} ms "
        f"(kernel {kernel:.1f}, nodes {nodes:.1f}); render {render:.0f} ms"
    )
    assert np.array_equal(drawn(), stored())

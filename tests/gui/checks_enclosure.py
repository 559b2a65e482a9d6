# SPDX-License-Identifier: LGPL-2.1-or-later
"""A sheet-metal enclosure of 38 parts, from its STEP file to a document that is opened again, by
mouse. How long each step takes, and how long FreeCAD stands still meanwhile, is reported."""

import os
import time

import FreeCAD as App
import FreeCADGui as Gui
import numpy as np
from checks_flow import count_of_parts, draw_region, look, loop_round, pull_arrow_up, select
from checks_finding import rows_shown
from checks_moving import open_panel
from checks_propagation import dialog
from desk import HERE, POLL, WORK, activate, child, import_files, note, picture, press, press_tool
from desk import laid_out, settled, until, view
from freecad.sheetmorph import api
from freecad.sheetmorph.objects import model
from hostile_panels import is_shown
from PySide import QtCore
from scenes import assembly, contacts, labelled, regions

__all__ = ["test_the_enclosure_from_step_to_a_saved_drag_is_measured"]

SHARED = os.environ.get("SHEETMORPH_SHARED", os.path.join(HERE, *[".."] * 3, "shared"))
STEP = os.path.join(SHARED, "data", "03-laser4diy-enclosure", "Enclosure_v3_v9.step")
BEAT = 20  # ms
LONGEST = 200.0  # seconds to wait for a step


class Steps:
    """The time of every step, and the longest time in it in which no event was handled.

    The processor time of the window's thread in such a time does not depend on what else the
    machine does.
    """

    def __init__(self, title: str):
        self.told, self._title = [], title
        self._beats = QtCore.QTimer()
        self._beats.timeout.connect(self._beat)
        self._beats.start(BEAT)

    def _beat(self) -> None:
        now = time.monotonic()
        self._still, self._last = max(self._still, now - self._last), now
        now = time.thread_time()
        self._busy, self._used = max(self._busy, now - self._used), now

    def step(self, title: str, action, is_done):
        """Does what a generator does and waits; a picture shows the progress, if there is any."""
        self._still, begin, own = 0.0, time.monotonic(), time.process_time()
        self._busy, self._used, self._last = 0.0, time.thread_time(), begin
        yield from action
        is_pictured = False
        while not is_done():
            assert time.monotonic() - begin < LONGEST, (title, under_way())
            if not is_pictured and dialog() is not None and dialog().isVisible():
                self._beat()
                picture(f"{self._name()}-progress-{len(self.told)}")
                self._last = time.monotonic()  # FreeCAD stood still for the picture
                self._used = time.thread_time()
                is_pictured = True
            yield POLL
        self._beat()
        taken, own = time.monotonic() - begin, time.process_time() - own
        progress = ", progress shown" if is_pictured else ""
        still = f"still for {self._still:.2f} s, {self._busy:.2f} of its own{progress}"
        still = f"{own:.1f} s of processor, {still}"
        self.told.append(f"{title} {taken:.1f} s ({still})")
        note(f"{self._title}: {self.told[-1]}")
        picture(f"{self._name()}-{len(self.told)}")

    def _name(self) -> str:
        return self._title.split()[-1]


def under_way() -> list:
    """What is under way: a step of a command, a recompute, a search whose progress is shown."""
    if App.ActiveDocument is None:
        return ["no document"]
    found = [App.getActiveTransaction()] if App.getActiveTransaction() else []
    found += ["recompute"] * App.ActiveDocument.Recomputing
    return found + ["progress"] * (dialog() is not None and dialog().isVisible())


def is_quiet() -> bool:
    """Whether nothing is under way."""
    return not under_way()


def has_followed() -> bool:
    """Whether what was dragged is drawn; the step of the open panel stays open."""
    is_told = child("status").text().startswith("Computed")
    return is_told and not App.ActiveDocument.Recomputing and "progress" not in under_way()


def mark_the_ends(steps: Steps):
    """The right side of the main sheet stays, its left end is the handle."""
    sheet = labelled("MainEnclosure.MainSheet")
    points = api.rest_mesh(sheet)[0]
    x = points[:, 0]
    yield from look("Front")
    for command, chosen in (("Mark Fixed Region…", x > 400.0), ("Mark Handle…", x < 10.0)):
        figure = [loop_round(points[chosen], (0, 2), 2.0)[k] for k in (0, 2)]
        closed = lambda: not Gui.Control.activeDialog() and is_quiet()  # noqa: E731
        yield from steps.step(command, draw_region(sheet, command, "rectangle", figure), closed)
    yield from look("Isometric")
    select(regions("handle")[0])


def found(command: str, steps: Steps):
    """Searches, and takes everything that is found."""
    Gui.Selection.clearSelection()
    opened = lambda: is_shown() and is_quiet() and rows_shown() > 100  # noqa: E731
    yield from steps.step(command, press_tool(command, laid_out), opened)
    closed = lambda: not Gui.Control.activeDialog() and is_quiet()  # noqa: E731
    yield from steps.step(f"OK of {command}", press("OK", laid_out), closed)


def reopened(path: str, steps: Steps):
    def close_and_open():
        App.closeDocument(App.ActiveDocument.Name)
        App.openDocument(path)
        yield POLL

    def save():
        App.ActiveDocument.saveAs(path)
        yield POLL

    yield from steps.step("save", save(), is_quiet)
    yield from steps.step("close and open", close_and_open(), is_quiet)


def test_the_enclosure_from_step_to_a_saved_drag_is_measured():
    if not os.path.isfile(STEP):
        note("the enclosure: its STEP file is not at hand; SHEETMORPH_SHARED names the folder")
        return
    yield from activate()
    steps = Steps("the enclosure")
    has_parts = lambda: is_quiet() and count_of_parts() == 38  # noqa: E731
    yield from steps.step("STEP in", import_files([STEP], 0.0, lambda: True), has_parts)
    yield from until(is_shown, "Prepare Mesh to be offered")
    yield from settled()  # the view fits, and is drawn
    yield from press("Cancel")
    yield from until(lambda: not Gui.Control.activeDialog(), "Prepare Mesh to close")
    yield from found("Find Features…", steps)
    yield from found("Find Contacts…", steps)
    yield from mark_the_ends(steps)
    yield from steps.step("Move Handle", open_panel(), lambda: is_shown() and is_quiet())
    yield from steps.step("a drag", pull_arrow_up(), has_followed)
    yield from steps.step("admissible range", settled(), lambda: True)
    yield from steps.step(
        "OK", press("OK", laid_out), lambda: not Gui.Control.activeDialog() and is_quiet()
    )
    wanted = (len(regions("form feature")), len(contacts()))
    moved = {part.Name: part.Mesh.BoundBox.DiagonalLength for part in model.parts(assembly())}
    yield from reopened(os.path.join(WORK, "enclosure.FCStd"), steps)
    assert (len(regions("form feature")), len(contacts())) == wanted and min(wanted) > 100
    again = {part.Name: part.Mesh.BoundBox.DiagonalLength for part in model.parts(assembly())}
    assert np.allclose(list(again.values()), list(moved.values()))
    view().viewIsometric()

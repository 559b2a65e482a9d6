# SPDX-License-Identifier: LGPL-2.1-or-later
"""Covers of a robot, one STL file in metres with slivers: what is offered and found is taken as it
is, up to a drag, by mouse."""

import os

import FreeCADGui as Gui
import numpy as np
from checks_enclosure import SHARED, Steps, has_followed, is_quiet
from checks_flow import count_of_parts, draw_region, look, loop_round, pull_arrow_up, select
from checks_finding import rows_shown
from checks_moving import open_panel
from desk import activate, child, import_files, laid_out, note, picture, press, press_tool, settled
from freecad.sheetmorph import api
from freecad.sheetmorph.objects import model
from hostile_panels import is_shown
from scenes import assembly, contacts, regions

__all__ = ["test_the_covers_from_stl_to_a_drag_with_what_is_offered_and_found"]

STL = os.path.join(SHARED, "data", "05-robotnik-summit-stl", "summit_xl_covers.stl")


def is_closed() -> bool:
    return not Gui.Control.activeDialog() and is_quiet()


def taken(command: str, steps: Steps, least: int):
    """Searches, and takes everything that is found."""
    Gui.Selection.clearSelection()
    opened = lambda: is_shown() and is_quiet() and rows_shown() >= least  # noqa: E731
    yield from steps.step(command, press_tool(command, laid_out), opened)
    yield from steps.step(f"OK of {command}", press("OK", laid_out), is_closed)


def mark_the_ends(steps: Steps):
    """Both ends along x of the piece that is the primary."""
    primary = assembly().Primary
    points = api.rest_mesh(primary)[0]
    x = points[:, 0]
    yield from look("Front")
    ends = (("Mark Fixed Region…", x < x.min() + 8.0), ("Mark Handle…", x > x.max() - 8.0))
    for command, chosen in ends:
        figure = [loop_round(points[chosen], (0, 2), 2.0)[k] for k in (0, 2)]
        yield from steps.step(
            command, draw_region(primary, command, "rectangle", figure), is_closed
        )
    yield from look("Isometric")
    select(regions("handle")[0])


def test_the_covers_from_stl_to_a_drag_with_what_is_offered_and_found():
    if not os.path.isfile(STL):
        note("the covers: their STL file is not at hand; SHEETMORPH_SHARED names the folder")
        return
    yield from activate()
    steps = Steps("the covers")
    offered = lambda: is_quiet() and is_shown()  # noqa: E731
    yield from steps.step(
        "STL in", import_files([STL], 0.0, lambda: count_of_parts() == 1), offered
    )
    ticked = [key for key in ("scale", "weld", "remesh", "thin", "split") if child(key).isChecked()]
    assert ticked == ["scale", "weld", "remesh", "thin", "split"], ticked
    assert "10 pieces" in child("split").text()
    picture("covers-offered")
    yield from steps.step(
        "OK of Prepare Mesh", press("OK", laid_out), lambda: is_closed() and count_of_parts() > 1
    )
    assert count_of_parts() == 10
    yield from taken("Find Features…", steps, 30)
    yield from taken("Find Contacts…", steps, 10)
    yield from mark_the_ends(steps)
    yield from steps.step("Move Handle", open_panel(), lambda: is_shown() and is_quiet())
    yield from steps.step("a drag", pull_arrow_up(), has_followed)
    yield from steps.step("admissible range", settled(), lambda: True)
    yield from steps.step("OK", press("OK", laid_out), is_closed)
    moved = {
        part.Label: float(np.abs(api.deform(assembly())[part.Name] - api.rest_mesh(part)[0]).max())
        for part in model.parts(assembly())
    }
    note(f"the covers: moved by {({k: round(v, 2) for k, v in moved.items()})}")
    assert sum(value > 0.1 for value in moved.values()) >= 5
    worst = max(contact.GapChange.Value for contact in contacts())
    note(f"the covers: contacts open by {worst:.3g} mm at most")
    assert worst < 5.0
    picture("covers-dragged")

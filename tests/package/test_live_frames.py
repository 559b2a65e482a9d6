# SPDX-License-Identifier: LGPL-2.1-or-later
"""Frames of a drag are those of the exact solve, to a millionth of the size."""

from __future__ import annotations

import numpy as np
import pytest

from plates import plate, recipe_of
from sheetmorph import Drag, LiveFrames, PartMesh, RecipeError, Session


@pytest.fixture(name="session")
def fixture_session() -> Session:
    """A plate with three holes whose right end is the handle "tip"."""
    part = plate()
    return Session(recipe_of(part, "plate.obj"), {"plate": PartMesh(part.points, part.triangles)})


def handle_of(session: Session) -> str:
    """The name of its handle."""
    return session.model.of_kind("handle")[0].name


def pose(session: Session, degrees: float) -> dict:
    """The handle lifted and turned."""
    turn = {"axis": [0.2, 1.0, 0.0], "degrees": degrees}
    return {handle_of(session): {"translation": [0.0, 0.0, 9.0], "rotation": turn}}


@pytest.mark.parametrize("degrees", [0.0, 35.0, 120.0])
def test_a_drag_gives_the_exact_shape(session: Session, degrees: float):
    wanted = pose(session, degrees)
    exact = session.deform(wanted).positions["plate"]
    drag = session.begin_drag([handle_of(session)])
    early = np.array(drag.deform(wanted).positions["plate"])
    drag.wait()
    assert drag.is_ready
    late = drag.deform(wanted).positions["plate"]
    assert np.abs(early - exact).max() < 1e-6 * session.size
    assert np.abs(late - exact).max() < 1e-6 * session.size


@pytest.mark.parametrize("is_ready", [False, True])
def test_a_frame_that_is_kept_stays_as_it_is(session: Session, is_ready: bool):
    drag = session.begin_drag([handle_of(session)])
    if is_ready:
        drag.wait()
    kept = [drag.deform(pose(session, 5.0 * k)).positions["plate"] for k in range(6)]
    copies = [np.array(positions) for positions in kept]
    for k in range(6):
        drag.deform(pose(session, 100.0 + 5.0 * k))
    for positions, copy in zip(kept, copies):
        np.testing.assert_array_equal(positions, copy)
    assert np.abs(kept[5] - kept[0]).max() > 1.0


def test_the_memory_of_frames_that_were_dropped_is_used_again(session: Session):
    drag = session.begin_drag([handle_of(session)])
    drag.wait()
    places = set()
    for k in range(10):
        frame = drag.deform(pose(session, 5.0 * k)).positions["plate"]
        places.add(frame.ctypes.data)
    assert len(places) <= 2


def test_a_frame_of_a_refined_part_says_that_it_is_a_preview():
    part = plate()
    recipe = {**recipe_of(part, "plate.obj"), "refine": True}
    session = Session(recipe, {"plate": PartMesh(part.points, part.triangles)})
    wanted = pose(session, -90.0)
    drag = session.begin_drag([handle_of(session)])
    assert drag.deform(wanted).previews == ("plate",)
    drag.wait()
    assert drag.deform(wanted).previews == ("plate",)
    assert session.deform(wanted, exact=False).previews == ("plate",)
    assert session.deform(wanted).previews == ()


def test_a_frame_of_another_part_is_none(session: Session):
    drag = session.begin_drag([handle_of(session)])
    assert drag.deform(pose(session, 10.0)).previews == ()
    drag.wait()
    assert drag.failure == ""
    assert LiveFrames(session).failure == ""


def test_what_the_learning_failed_with_is_told_without_waiting(session: Session):
    class Failed:
        failure = "not enough memory"
        is_ready = True

    assert Drag(session, Failed()).failure == "not enough memory"


def test_live_frames_begin_a_drag_by_themselves(session: Session):
    frames = LiveFrames(session)
    for moved in ([], [handle_of(session)], [handle_of(session), "root"]):
        for degrees in (20.0, 40.0):
            wanted = pose(session, degrees)
            live = frames.deform(wanted, moved).positions["plate"]
            exact = session.deform(wanted).positions["plate"]
            assert np.abs(live - exact).max() < 1e-6 * session.size


def test_a_drag_refuses_what_the_recipe_does_not_have(session: Session):
    with pytest.raises(RecipeError):
        session.begin_drag(["nose"])
    with pytest.raises(RecipeError):
        session.begin_drag([handle_of(session)]).deform({"nose": {"translation": [0, 0, 1]}})

# SPDX-License-Identifier: LGPL-2.1-or-later
"""Frames of a drag are those of the exact solve, to a millionth of the size."""

from __future__ import annotations

import numpy as np
import pytest

from plates import plate, recipe_of
from sheetmorph import LiveFrames, PartMesh, RecipeError, Session


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


def test_the_next_frame_overwrites_the_last_one(session: Session):
    drag = session.begin_drag([handle_of(session)])
    drag.wait()
    first = drag.deform(pose(session, 10.0)).positions["plate"]
    kept = np.array(first)
    second = drag.deform(pose(session, 50.0)).positions["plate"]
    assert np.abs(second - kept).max() > 1.0


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

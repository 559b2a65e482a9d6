# SPDX-License-Identifier: LGPL-2.1-or-later
"""Frames while handles are dragged: 1e-6 of the size, as fast as the kernel can."""

from __future__ import annotations

from collections.abc import Collection

from .recipe.pose import Pose
from .session import Drag, Result, Session


class LiveFrames:
    """Live frames of a session; a drag begins by itself when other handles move."""

    def __init__(self, session: Session):
        self._session = session
        self._handles = frozenset(entry.name for entry in session.model.of_kind("handle"))
        self._moved: frozenset[str] = frozenset()
        self._drag: Drag | None = None

    @property
    def failure(self) -> str:
        """What the learning of the present drag has failed with, empty if it has not."""
        return "" if self._drag is None else self._drag.failure

    def deform(self, pose: Pose, moved: Collection[str]) -> Result:
        """All parts in a pose; `moved`: names of what differs from one frame to the next.

        Raises RecipeError.
        """
        handles = self._handles & frozenset(moved)
        if not handles:
            return self._session.deform(pose, exact=False)
        if self._drag is None or handles != self._moved:
            self._drag = self._session.begin_drag(sorted(handles), pose)
            self._moved = handles
        return self._drag.deform(pose)

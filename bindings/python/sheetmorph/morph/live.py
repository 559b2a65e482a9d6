# SPDX-License-Identifier: LGPL-2.1-or-later
"""Fast frames while the user drags handles, accurate to 1e-6 of the size."""

from __future__ import annotations

from collections.abc import Collection

from ..recipe.pose import Pose
from .session import Drag, Result, Session


class LiveFrames:
    """Live frames of a session; a new drag starts when the set of moving handles changes.

    Parameters
    ----------
    session : Session
        The factorised morph.
    """

    def __init__(self, session: Session):
        self._session = session
        self._handles = frozenset(entry.name for entry in session.model.of_kind("handle"))
        self._moved: frozenset[str] = frozenset()
        self._drag: Drag | None = None

    @property
    def failure(self) -> str:
        """Error of the background work of the current drag, or an empty string."""
        return "" if self._drag is None else self._drag.failure

    def deform(self, pose: Pose, moved: Collection[str]) -> Result:
        """Return all parts in a pose, computed fast and not exactly.

        Parameters
        ----------
        pose : dict
            The pose, as in a recipe.
        moved : collection of str
            Names of the entries that change from frame to frame.

        Returns
        -------
        Result
            Positions (n, 3) of every part, mm, accurate to 1e-6 of the size.

        Raises
        ------
        RecipeError
            If the pose is invalid.
        """
        handles = self._handles & frozenset(moved)
        if not handles:
            return self._session.deform(pose, exact=False)
        if self._drag is None or handles != self._moved:
            self._drag = self._session.begin_drag(sorted(handles), pose)
            self._moved = handles
        return self._drag.deform(pose)

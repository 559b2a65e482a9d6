# SPDX-License-Identifier: LGPL-2.1-or-later
"""Frames while handles are dragged: 1e-6 of the size, as fast as the kernel can."""

from __future__ import annotations

from collections.abc import Collection
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from .session import Result, Session


class Drag:
    """Live frames of handles that are dragged, begun by Session.begin_drag().

    In the background the kernel works out how the parts answer to the handles; until a part is
    done, and in poses that turn more than two of its handles, frames take longer, not other values.
    """

    def __init__(self, session: Session, kernel_drag: Any):
        self._session = session
        self._drag = kernel_drag

    @property
    def is_ready(self) -> bool:
        """Whether the background work is done."""
        return bool(self._drag.is_ready)

    def wait(self) -> None:
        """Return when the background work is done."""
        self._drag.wait()

    def deform(self, pose: dict[str, Any]) -> Result:
        """All parts in a pose, from rest; its positions are overwritten by the next frame.

        Raises RecipeError.
        """
        return self._session.dragged(self._drag, pose)


class LiveFrames:
    """Live frames of a session; a drag begins by itself when other handles move."""

    def __init__(self, session: Session):
        self._session = session
        self._handles = frozenset(entry.name for entry in session.model.of_kind("handle"))
        self._moved: frozenset[str] = frozenset()
        self._drag: Drag | None = None

    def deform(self, pose: dict[str, Any], moved: Collection[str]) -> Result:
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

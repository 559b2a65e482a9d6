# SPDX-License-Identifier: LGPL-2.1-or-later
"""The observer of one document while a session is open."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager

import FreeCAD


class Watch:
    """A document observer until `stop`, which FreeCAD calls in the middle of changes."""

    def __init__(self, session):
        """Start to observe the document of a session.

        `session` has document, end_soon, on_deleted, on_changed, on_close_of_step, on_undo and
        on_redo.
        """
        self._session = session
        self._document = session.document
        self._is_paused = False
        FreeCAD.addDocumentObserver(self)

    def stop(self) -> None:
        """Stop observing."""
        FreeCAD.removeDocumentObserver(self)
        self._session = self._document = None

    @contextmanager
    def pause(self) -> Iterator[None]:
        """Ignore the changes that the session makes in this context."""
        self._is_paused = True
        try:
            yield
        finally:
            self._is_paused = False

    def slotDeletedObject(self, obj) -> None:
        """Report that an object is about to be deleted, also by an undo."""
        if self._is_heard(obj.Document):
            self._session.on_deleted(obj)

    def slotChangedObject(self, obj, name: str) -> None:
        """Report a changed mesh or placement, also by an undo."""
        if name in ("Mesh", "Placement") and self._is_heard(obj.Document):
            self._session.on_changed(obj)

    def slotBeforeCloseTransaction(self, is_abort: bool) -> None:
        """Report that a step of any document will be committed or aborted."""
        if not self._is_paused:
            self._session.on_close_of_step(is_abort)

    def slotUndoDocument(self, document) -> None:
        """Report an undo."""
        if self._is_heard(document):
            self._session.on_undo()

    def slotRedoDocument(self, document) -> None:
        """Report a redo."""
        if self._is_heard(document):
            self._session.on_redo()

    def slotDeletedDocument(self, document) -> None:
        """End the session when its document closes."""
        if self._is_heard(document):
            self._session.end_soon()

    def _is_heard(self, document) -> bool:
        return not self._is_paused and document == self._document

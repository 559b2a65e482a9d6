# SPDX-License-Identifier: LGPL-2.1-or-later
"""What FreeCAD tells of one document while a session is open."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager

import FreeCAD


class Watch:
    """A document observer until `stop`; it is called in the midst of changes."""

    def __init__(self, session):
        """`session` has document, end_soon, and on_deleted, on_changed, on_close_of_step, on_undo
        and on_redo, as they are called below."""
        self._session = session
        self._document = session.document
        self._is_paused = False
        FreeCAD.addDocumentObserver(self)

    def stop(self) -> None:
        """Hear nothing any more."""
        FreeCAD.removeDocumentObserver(self)
        self._session = self._document = None

    @contextmanager
    def pause(self) -> Iterator[None]:
        """Hear nothing of what the session itself does."""
        self._is_paused = True
        try:
            yield
        finally:
            self._is_paused = False

    def slotDeletedObject(self, obj) -> None:
        """FreeCAD calls this before an object goes, also in undo."""
        if self._is_heard(obj.Document):
            self._session.on_deleted(obj)

    def slotChangedObject(self, obj, name: str) -> None:
        """FreeCAD calls this after every change of a property, also in undo."""
        if name in ("Mesh", "Placement") and self._is_heard(obj.Document):
            self._session.on_changed(obj)

    def slotBeforeCloseTransaction(self, is_abort: bool) -> None:
        """FreeCAD calls this before it commits or takes back a step of whatever document."""
        if not self._is_paused:
            self._session.on_close_of_step(is_abort)

    def slotUndoDocument(self, document) -> None:
        """FreeCAD calls this after an undo."""
        if self._is_heard(document):
            self._session.on_undo()

    def slotRedoDocument(self, document) -> None:
        """FreeCAD calls this after a redo."""
        if self._is_heard(document):
            self._session.on_redo()

    def slotDeletedDocument(self, document) -> None:
        """FreeCAD calls this when a document is closed."""
        if self._is_heard(document):
            self._session.end_soon()

    def _is_heard(self, document) -> bool:
        return not self._is_paused and document == self._document

# SPDX-License-Identifier: LGPL-2.1-or-later
"""The editing session: what an open panel has of the program, and gives back in one way.

OK, Cancel, Esc, closeDialog(), a document that is closed, an undo beyond the beginning, a deletion
of what the panel is about: all of them come to `end`, and `end` comes once.
"""

from contextlib import ExitStack, contextmanager, nullcontext

import FreeCAD as App
import FreeCADGui as Gui

from freecad.sheetmorph.editing.pending import Pending
from freecad.sheetmorph.editing.view_of import is_alive, mdi_area, shown_view
from freecad.sheetmorph.editing.watch import Watch
from freecad.sheetmorph.qt import QtCore, QtWidgets


BUSY = 20  # ms between two looks whether FreeCAD is still at it
LOOK = 50  # ms after which the widgets of a window that was closed are gone


class Session(QtCore.QObject):
    """What an open panel owns, until ``end``.

    ``over`` is sent when it has ended, ``ending`` when that is certain but not done yet.
    """

    over = QtCore.Signal()
    ending = QtCore.Signal()

    def __init__(self):
        super().__init__()
        self.is_over = self.is_ending = False
        self._stack = ExitStack()
        self._aside = []

    def at_end(self, function) -> None:
        """Calls a function when the session ends; the last one given comes first."""
        self._stack.callback(function)

    def show(self, drawing):
        """Owns a drawing, or a tool, with ``remove()``; returns it."""
        self.at_end(drawing.remove)
        return drawing

    def put_selection_aside(self) -> None:
        """Takes the colour of the selection out of the view until the end."""
        self._aside = [(obj.Document.Name, obj.Name) for obj in Gui.Selection.getSelection()]
        if self._aside:  # else a line of the macro for nothing
            Gui.Selection.clearSelection()
        self.over.connect(self._select_again)

    def end(self) -> None:
        """Takes back what is pending and everything that was shown; a second call does nothing."""
        if self.is_over:
            return
        self._announce()
        self.is_over = True
        try:
            self._stack.close()
        finally:
            self.over.emit()

    def end_soon(self, *_) -> None:
        """Ends when FreeCAD has done what it is doing: from where it tells of changes."""
        if not self.is_ending:
            self._announce()
            self.later(self.end)

    def later(self, action) -> None:
        """Calls a function when the event loop is free and nothing is under way."""

        def act() -> None:
            if self.is_busy():
                QtCore.QTimer.singleShot(BUSY, act)
            else:
                action()

        QtCore.QTimer.singleShot(0, act)

    def when_free(self, action) -> None:
        """Calls a function so later, unless the session ends before: what timers of panels do."""
        self.later(lambda: None if self.is_ending else action())

    def is_busy(self) -> bool:
        """Whether something is under way that handles events in between: FreeCAD asks a question
        in the midst of a command, whose undo step must not be taken for one of ours.

        When the question is gone the rest of the command, and its step, are yet to come.
        """
        is_within = QtCore.QThread.currentThread().loopLevel() > 1
        is_asked = QtWidgets.QApplication.activeModalWidget() is not None
        return is_asked or (is_within and App.getActiveTransaction() is not None)

    def _announce(self) -> None:
        if not self.is_ending:
            self.is_ending = True
            self.ending.emit()

    def _select_again(self) -> None:
        for document, name in self._aside:
            if document in App.listDocuments() and App.getDocument(document).getObject(name):
                Gui.Selection.addSelection(document, name)


class EditingSession(Session):
    """On one document, its undo steps and one of its 3D views.

    ``changed`` is sent when somebody else has changed what the panel shows.
    """

    changed = QtCore.Signal()

    def __init__(self, document, needed=(), *, goes_with_undo: bool = False):
        """``needed``: the objects without which there is nothing to edit, with the meshes of parts.

        ``goes_with_undo``: undo and redo of whatever step are changes to show, not an end.
        """
        super().__init__()
        self.document = document
        self.pending = None
        self._name, self._goes_with_undo = document.Name, goes_with_undo
        meshes = [getattr(obj, link, None) for obj in needed for link in ("Source", "Original")]
        self._meshes = {mesh.Name for mesh in meshes if mesh is not None}
        self._needed = {obj.Name for obj in needed} | self._meshes
        self.view = shown_view(document)
        # Not by a signal of the view's widgets: PySide would keep their wrappers, and take a widget
        # that is made later at the same address for the one that is gone.
        mdi_area().subWindowActivated.connect(self._look_for_view)
        self.at_end(self._forget_view)
        self._watch = Watch(self)
        self.at_end(self._watch.stop)

    def edit(self, title: str, read, write) -> Pending:
        """Lets the panel change the document in a step with a title; see Pending."""
        self.pending = Pending(self.document, title, read, write)
        self.at_end(self._take_back)
        return self.pending

    @property
    def goes_along(self) -> bool:
        """Whether the parts may get another shape under the panel."""
        return self._goes_with_undo or self.pending is not None

    @contextmanager
    def aside(self):
        """In this context the panel may do an undo step of its own."""
        with self._watch.pause(), self.pending.aside() if self.pending else nullcontext():
            yield

    def is_busy(self) -> bool:
        """A recompute handles events too, and so does the opening of a document."""
        mine, is_open = self.document, self.is_document_open()
        return super().is_busy() or (
            is_open and (mine.Recomputing or mine.Restoring or mine.Transacting)
        )

    def is_document_open(self) -> bool:
        """Whether the document is still there, and the same."""
        return App.listDocuments().get(self._name) == self.document

    def _take_back(self) -> None:
        if self.is_document_open():
            self.pending.take_back()
        else:
            self.pending.abandon()

    def _look_for_view(self, *_) -> None:
        QtCore.QTimer.singleShot(LOOK, self._end_without_view)

    def _end_without_view(self) -> None:
        if self.view is not None and not is_alive(self.view):
            self.end()

    def _forget_view(self) -> None:
        mdi_area().subWindowActivated.disconnect(self._look_for_view)
        self.view = None

    # -- what the watch tells, while FreeCAD is at it

    def on_deleted(self, obj) -> None:
        """An object of the document goes."""
        if obj.Name in self._needed:
            if self.pending is not None:
                self.pending.on_deletion()
            self.end_soon()
        elif self._goes_with_undo:
            self._soon(self.changed.emit)

    def on_changed(self, obj) -> None:
        """The mesh or the placement of an object is another one: if parts rest on it, so is all
        that a panel knows of them, or it ends."""
        if not self._is_mesh(obj):
            return
        if self.pending is not None or self._goes_with_undo:
            self._soon(self.changed.emit)
        else:
            self.end_soon()

    def _is_mesh(self, obj) -> bool:
        """Whether it is a mesh that a part rests on, or contains one."""
        if obj.Name in self._meshes or not obj.hasExtension("App::GeoFeatureGroupExtension"):
            return obj.Name in self._meshes
        return any(inner.Name in self._meshes for inner in obj.OutListRecursive)

    def on_close_of_step(self, is_abort: bool) -> None:
        """An undo step is closed."""
        if self.pending is not None and self.pending.on_close(is_abort):
            self._soon(self._resume)

    def on_undo(self) -> None:
        """A step was undone."""
        if self.pending is not None and self.pending.on_undo():
            self._soon(self._resume)
        else:
            self._show_or_end()

    def on_redo(self) -> None:
        """A step was redone."""
        if self.pending is not None and self.pending.can_go_forward:
            self._soon(self._go_forward)
        else:
            self._show_or_end()

    def _show_or_end(self) -> None:
        if self._goes_with_undo:
            self._soon(self.changed.emit)
        else:
            self.end_soon()

    def _soon(self, action) -> None:
        def act() -> None:
            if not self.is_ending:
                with self._watch.pause():
                    action()

        self.later(act)

    def _resume(self) -> None:
        if self.pending.resume():
            self.changed.emit()

    def _go_forward(self) -> None:
        self.pending.go_forward()
        self.changed.emit()

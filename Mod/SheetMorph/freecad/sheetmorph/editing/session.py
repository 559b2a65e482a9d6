# SPDX-License-Identifier: LGPL-2.1-or-later
"""The editing session, which owns the resources of an open panel and releases them together.

OK, Cancel, Esc, closeDialog(), a closed document, an undo past the start and the deletion of a
needed object all call `end`, which acts only once.
"""

from contextlib import ExitStack, contextmanager, nullcontext

import FreeCAD as App
import FreeCADGui as Gui

from freecad.sheetmorph import generations
from freecad.sheetmorph.editing.pending import Pending
from freecad.sheetmorph.editing.view_of import is_alive, mdi_area, shown_view
from freecad.sheetmorph.editing.watch import Watch
from freecad.sheetmorph.qt import QtCore, QtWidgets


BUSY = 20  # ms between two checks whether FreeCAD is busy
LOOK = 50  # ms after which the widgets of a closed window are gone


class Session(QtCore.QObject):
    """The resources of an open panel until `end`.

    The signal `ending` announces the end; `over` follows when everything is released.
    """

    over = QtCore.Signal()
    ending = QtCore.Signal()

    def __init__(self):
        super().__init__()
        self.is_over = self.is_ending = False
        self._stack = ExitStack()
        self._aside = []

    def at_end(self, function) -> None:
        """Register a function to call at the end; the last one registered is called first."""
        self._stack.callback(function)

    def show(self, drawing):
        """Own a drawing or tool with a `remove()` method, and return it."""
        self.at_end(drawing.remove)
        return drawing

    def put_selection_aside(self) -> None:
        """Clear the selection, so that its colour hides nothing, until the end."""
        self._aside = [(obj.Document.Name, obj.Name) for obj in Gui.Selection.getSelection()]
        if self._aside:  # avoids an unnecessary line in the macro
            Gui.Selection.clearSelection()
        self.over.connect(self._select_again)

    def end(self) -> None:
        """Undo pending changes and remove all drawings; a second call does nothing."""
        if self.is_over:
            return
        self._announce()
        self.is_over = True
        try:
            self._stack.close()
        finally:
            self.over.emit()

    def end_soon(self, *_) -> None:
        """End once FreeCAD has finished; for use in observers of changes."""
        if not self.is_ending:
            self._announce()
            self.later(self.end)

    def later(self, action) -> None:
        """Call a function when the event loop is free and no command is running."""

        def act() -> None:
            if self.is_busy():
                QtCore.QTimer.singleShot(BUSY, act)
            else:
                action()

        QtCore.QTimer.singleShot(0, act)

    def when_free(self, action) -> None:
        """Call a function later, unless the session ends first; for timers of panels."""
        self.later(lambda: None if self.is_ending else action())

    def is_busy(self) -> bool:
        """Return whether a command is running, even if it waits for a dialog.

        After the dialog, the rest of the command and its undo step are still to come. That step
        must not be mistaken for one of the session.
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
            found = generations.document_named(document)
            if found is not None and found.getObject(name):
                Gui.Selection.addSelection(document, name)


class EditingSession(Session):
    """A session on one document, with its undo steps and one of its 3D views.

    The signal `changed` means that somebody else has changed the displayed objects.
    """

    changed = QtCore.Signal()

    def __init__(self, document, needed=(), *, goes_with_undo: bool = False):
        """Start a session that needs the given objects and the meshes of parts among them.

        With `goes_with_undo`, any undo or redo is a change to display; otherwise it ends the
        session.
        """
        super().__init__()
        self.document = document
        self.pending = None
        self._name, self._goes_with_undo = document.Name, goes_with_undo
        meshes = [getattr(obj, link, None) for obj in needed for link in ("Source", "Original")]
        self._meshes = {mesh.Name for mesh in meshes if mesh is not None}
        self._needed = {obj.Name for obj in needed} | self._meshes
        self.view = shown_view(document)
        # Signals of the view's widgets will not do: PySide would keep their wrappers, and mistake a
        # later widget at the same address for the deleted one.
        mdi_area().subWindowActivated.connect(self._look_for_view)
        self.at_end(self._forget_view)
        self._watch = Watch(self)
        self.at_end(self._watch.stop)

    def edit(self, title: str, read, write) -> Pending:
        """Let the panel change the document in a step with a title; see Pending."""
        self.pending = Pending(self.document, title, read, write)
        self.at_end(self._take_back)
        return self.pending

    @property
    def goes_along(self) -> bool:
        """Whether the shape of parts may change under the panel."""
        return self._goes_with_undo or self.pending is not None

    @contextmanager
    def aside(self):
        """Let the panel make a separate undo step in this context."""
        with self._watch.pause(), self.pending.aside() if self.pending else nullcontext():
            yield

    def is_busy(self) -> bool:
        """Return whether a command, recompute, undo or document restore is running."""
        mine, is_open = self.document, self.is_document_open()
        return super().is_busy() or (
            is_open and (mine.Recomputing or mine.Restoring or mine.Transacting)
        )

    def is_document_open(self) -> bool:
        """Return whether the same document is still open."""
        return generations.document_named(self._name) == self.document

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

    # -- called by the watch in the middle of FreeCAD's changes

    def on_deleted(self, obj) -> None:
        """Handle the deletion of an object of the document."""
        if obj.Name in self._needed:
            if self.pending is not None:
                self.pending.on_deletion()
            self.end_soon()
        elif self._goes_with_undo:
            self._soon(self.changed.emit)

    def on_changed(self, obj) -> None:
        """Handle another mesh or placement of an object.

        If parts depend on it, the session announces the change or, without undo steps, ends.
        """
        if not self._is_mesh(obj):
            return
        if self.pending is not None or self._goes_with_undo:
            self._soon(self.changed.emit)
        else:
            self.end_soon()

    def _is_mesh(self, obj) -> bool:
        """Return whether an object is, or contains, a mesh on which a part depends."""
        if obj.Name in self._meshes or not obj.hasExtension("App::GeoFeatureGroupExtension"):
            return obj.Name in self._meshes
        return any(inner.Name in self._meshes for inner in obj.OutListRecursive)

    def on_close_of_step(self, is_abort: bool) -> None:
        """Handle the end of an undo step."""
        if self.pending is not None and self.pending.on_close(is_abort):
            self._soon(self._resume)

    def on_undo(self) -> None:
        """Handle an undo."""
        if self.pending is not None and self.pending.on_undo():
            self._soon(self._resume)
        else:
            self._show_or_end()

    def on_redo(self) -> None:
        """Handle a redo."""
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

# SPDX-License-Identifier: LGPL-2.1-or-later
"""The background computation of a morph's final shape after its panel closes.

The document has the new pose at once. Until the final shape arrives, the parts are due, the view
keeps the last frame, and the status of the morph says so. A recompute by a command or a script
waits for the final shape.
"""

import time
from functools import lru_cache

import FreeCAD as App
import FreeCADGui as Gui

from freecad.sheetmorph import generations
from freecad.sheetmorph.bridge import kernel, solving
from freecad.sheetmorph.interaction.finishing_bar import FinishingBar
from freecad.sheetmorph.interaction.frame_worker import FrameWorker
from freecad.sheetmorph.objects import model
from freecad.sheetmorph.objects.errors import MorphError
from freecad.sheetmorph.qt import QtCore, QtWidgets, connect, translate

PATIENCE = 0.06  # s that OK may wait, so that a small morph gets its final shape at once
LARGE = 20_000  # vertices of a morph above which OK does not wait
NAP = 0.002  # s between two checks during this wait
LOOK = 20  # ms between two checks whether a document is free
COMPUTED = "Computing: the parts still have an earlier shape."
STOPPED = "Not computed: recompute the document to get the final shape."


class Finish(QtCore.QObject):
    """The computation of one morph until its parts have their final shape, or until it stops."""

    def __init__(self, assembly, is_quiet: bool):
        super().__init__()
        self.is_quiet = is_quiet
        self._document, self._name = assembly.Document, assembly.Name
        self._document_name = assembly.Document.Name
        self.label = assembly.Label
        self.is_over = False
        self.task, self._fraction = "", 0.0
        self._scene = self._expected = None
        self._cache = solving.cache_of(assembly)
        self._worker = FrameWorker(self._compute, self)  # last, because it must be stopped

    def take(self, scene) -> None:
        """Own a LiveScene and show it until the final shape arrives."""
        self.drop_scene()
        self._scene = scene

    def expect(self, morph) -> None:
        """Compute this morph first, which very likely equals that of the document.

        Reading the document takes long with many regions.
        """
        self._expected = morph

    def drop_scene(self) -> None:
        """Show the meshes of the document again."""
        if self._scene is not None:
            self._scene.remove()
        self._scene = None

    @property
    def percent(self) -> int:
        """The progress of the present task."""
        return round(100.0 * self._fraction)

    @property
    def is_computing(self) -> bool:
        """Whether the thread is running."""
        return not self._worker.is_idle

    def end(self) -> None:
        """Stop computing and displaying, without waiting."""
        self.is_over = True
        self._worker.stop()
        self.drop_scene()

    def stop(self) -> None:
        """Stop at the user's request; the parts stay due."""
        self.end()
        if self.assembly() is not None:
            solving.tell_status(self.assembly(), STOPPED)

    def assembly(self):
        """Return the morph, None if it no longer exists."""
        is_open = generations.document_named(self._document_name) == self._document
        return self._document.getObject(self._name) if is_open else None

    def is_in(self, document) -> bool:
        """Return whether the morph belongs to a document."""
        return self._document == document

    def look(self) -> None:
        """Continue as far as possible without waiting; the document must be free."""
        if not self._worker.is_idle:
            return
        expected, self._expected = self._expected, None
        if expected is not None and not self._cache.is_known(expected):
            self._ask(expected)
            return
        try:
            morph = solving.read_morph(self.assembly())
        except (MorphError, *solving.FAILURES):
            self.apply()  # the recompute reports the error
            return
        if self._cache.is_known(morph) or not morph.is_held():
            self.apply()
        else:
            self._ask(morph)

    def _ask(self, morph) -> None:
        solving.tell_status(self.assembly(), COMPUTED)
        self._worker.ask(morph)

    def is_answered(self, seconds: float) -> bool:
        """Wait in the window thread for the answer; return whether it came in time."""
        end = time.monotonic() + seconds
        try:
            morph = solving.read_morph(self.assembly())
        except (MorphError, *solving.FAILURES):
            return True
        if not morph.is_held() or self._cache.is_known(morph):
            return True
        if self._worker.is_idle:
            self._worker.ask(morph)
        while time.monotonic() < end:
            if self._cache.is_known(morph):
                return True
            time.sleep(NAP)
        return False

    def apply(self) -> None:
        """Give the parts their shape."""
        self.is_over = True
        assembly = self.assembly()
        solving.make_due(assembly)
        self._document.recompute()
        self.end()
        fault = model.failure_of(assembly)
        if fault:
            self._tell(fault)

    def _tell(self, fault: str) -> None:
        if not self.is_quiet:
            tell(self.label, fault)

    def _compute(self, morph):
        """Compute the morph in the worker thread."""
        return self._cache.compute(morph, self._goes_on)

    def _goes_on(self, fraction: float, task: str) -> bool:
        """Return whether to continue; runs in the worker thread."""
        self._fraction = fraction
        self._worker.tell(task)
        return self._worker.is_free

    # -- called by the worker

    def on_answer(self, _outcome) -> None:
        """Do nothing, since the next look finds the answer."""

    def on_fault(self, text: str) -> None:
        """Stop, since no answer will come."""
        self.stop()
        self._tell(text)

    def on_progress(self, task: str) -> None:
        """Store the present task."""
        self.task = task


class Finishing(QtCore.QObject):
    """All morphs of the application whose final shape is being computed.

    The signal `finished` has a morph whose parts have their final shape, or will not get it.
    """

    finished = QtCore.Signal(object)

    def __init__(self):
        super().__init__()
        self._jobs: dict[tuple[str, str], Finish] = {}
        self._holds: list = []
        self._opened: list = []  # documents that are being opened
        self._bar = None
        self._timer = QtCore.QTimer(self)
        self._timer.setInterval(LOOK)
        connect(self._timer, "timeout()", self._look)

    def finish(self, assembly, *, is_quiet: bool = False) -> Finish:
        """Compute the shape of a morph's present pose in the background.

        With `is_quiet`, a fault goes to the report view only.
        """
        key = assembly.Document.Name, assembly.Name
        job = self._jobs.get(key)
        if job is None or job.is_over:
            job = self._jobs[key] = Finish(assembly, is_quiet)
        self._timer.start()
        return job

    def look_at(self, document) -> None:
        """Compute the final shapes that are missing in a document once it is open."""
        if document not in self._opened:
            self._opened.append(document)
            self._timer.start()

    def is_quick(self, assembly) -> bool:
        """Return whether a recompute is instant, after waiting for PATIENCE at most.

        Otherwise the solution of a small morph continues in the background.
        """
        if vertices_of(assembly) > LARGE:
            return False
        begin = time.monotonic()
        job = self._jobs.get((assembly.Document.Name, assembly.Name))
        if job is None or job.is_over:
            job = Finish(assembly, is_quiet=False)
            self._jobs[assembly.Document.Name, assembly.Name] = job
        is_known = job.is_answered(PATIENCE - (time.monotonic() - begin))
        if is_known:
            job.end()
        self._timer.start()
        return is_known

    def is_under_way(self) -> bool:
        """Return whether a final shape is being computed and can be applied."""
        jobs = self._jobs.values()
        return bool(self._opened) or any(not j.is_over and not self._is_held(j) for j in jobs)

    def is_due(self, assembly) -> bool:
        """Return whether the parts of a morph still have an earlier shape."""
        return any(job.assembly() == assembly for job in self._jobs.values() if not job.is_over)

    def drop_scene(self, assembly) -> None:
        """Remove the display of a morph before a panel shows it."""
        for job in self._jobs.values():
            if job.assembly() == assembly:
                job.drop_scene()

    def hold(self, session) -> None:
        """Register the session of an open panel, see `_is_held`."""
        self._holds.append(session)

    def release(self, session) -> None:
        """Remove a session that has ended."""
        self._holds = [one for one in self._holds if one is not session]

    def stop_all(self) -> None:
        """Stop all computations at the user's request."""
        for job in self._jobs.values():
            if not job.is_over:
                job.stop()

    def _is_held(self, job) -> bool:
        """Return whether an open panel keeps shapes out of its document.

        A panel that moves handles shows the parts in its own preview.
        """
        return any(
            job.is_in(session.document)
            and (not session.goes_along or (job.is_quiet and session.pending is not None))
            for session in self._holds
        )

    def _look(self) -> None:
        for document in [one for one in self._opened if not one.Restoring]:
            self._opened.remove(document)
            if document in App.listDocuments().values():
                self.slotUndoDocument(document)
        for key, job in list(self._jobs.items()):
            if not job.is_over and job.assembly() is None:
                job.end()
            if not job.is_over and is_free(job) and not self._is_held(job):
                job.look()
            if job.is_over:
                self._jobs.pop(key, None)
                if job.assembly() is not None:
                    self.finished.emit(job.assembly())
        if not (self._jobs or self._opened):
            self._timer.stop()
        self._show_bar()

    def _show_bar(self) -> None:
        job = next((one for one in self._jobs.values() if one.is_computing), None)
        if job is None and self._bar is not None:
            self._bar.remove()
            self._bar = None
        elif job is not None:
            if self._bar is None:
                self._bar = FinishingBar(self.stop_all)
            self._bar.tell(job.label, job.task, job.percent)

    # -- called by FreeCAD in the middle of changes

    def slotUndoDocument(self, document) -> None:
        """Recompute the meshes that came after the step, which an undo does not restore."""
        for assembly in due_in(document):
            self.finish(assembly, is_quiet=True)

    slotRedoDocument = slotUndoDocument

    def slotDeletedDocument(self, document) -> None:
        """Stop the computations for a closed document."""
        self._opened = [one for one in self._opened if one != document]
        for job in self._jobs.values():
            if job.is_in(document) and not job.is_over:
                job.end()


def is_free(job) -> bool:
    """Return whether no recompute, open step or dialog prevents a change of the document."""
    document = job.assembly().Document
    if document.Recomputing or document.Restoring or document.Transacting:
        return False
    if document.HasPendingTransaction or App.getActiveTransaction() is not None:
        return False
    return QtWidgets.QApplication.activeModalWidget() is None


def vertices_of(assembly) -> int:
    """Return the number of vertices of a morph's parts."""
    sources = [part.Source for part in model.parts(assembly)]
    return sum(source.Mesh.CountPoints for source in sources if source is not None)


def due_in(document) -> list:
    """Return the morphs of a document with parts that are due, none without the kernel."""
    if not kernel.is_available():
        return []
    morphs = [obj for obj in document.Objects if model.kind(obj) == model.ASSEMBLY]
    return [morph for morph in morphs if is_due(morph)]


def is_due(assembly) -> bool:
    """Return whether an input of the parts has changed since the last recompute."""
    deformation = model.deformation_of(assembly)
    if deformation is None:
        return False
    concerned = [deformation, *deformation.OutList, *model.parts(assembly)]
    return any("Touched" in obj.State for obj in concerned)


def tell(label: str, text: str) -> None:
    """Report a failed shape in a window that blocks nothing."""
    App.Console.PrintError(f"SheetMorph: {text}\n")
    title = translate("SheetMorph_panels", "The shape of {0} could not be computed").format(label)
    box = QtWidgets.QMessageBox(
        QtWidgets.QMessageBox.Warning, title, text, parent=Gui.getMainWindow()
    )
    box.setAttribute(QtCore.Qt.WA_DeleteOnClose)
    box.setModal(False)
    box.show()


@lru_cache(maxsize=1)
def finishing() -> Finishing:
    """Return the only instance of this process, created in the window thread."""
    found = Finishing()
    App.addDocumentObserver(found)
    return found

# SPDX-License-Identifier: LGPL-2.1-or-later
"""Computes the final shape of a morph in the background after its panel was closed.

The document has the new pose at once. Until the final shape arrives, its parts are due, the view
keeps the last frame, and the status of the morph says so. A recompute by a command or a script
waits for the final shape.
"""

import time
from functools import lru_cache

import FreeCAD as App
import FreeCADGui as Gui

from freecad.sheetmorph.bridge import kernel, solving
from freecad.sheetmorph.interaction.finishing_bar import FinishingBar
from freecad.sheetmorph.interaction.frame_worker import FrameWorker
from freecad.sheetmorph.objects import model
from freecad.sheetmorph.objects.errors import MorphError
from freecad.sheetmorph.qt import QtCore, QtWidgets, connect, translate

PATIENCE = 0.06  # seconds that OK may wait for a shape, so that a small morph has it at once
LARGE = 20_000  # vertices of a morph whose shape OK does not wait for
NAP = 0.002  # seconds between two looks meanwhile
LOOK = 20  # ms between two looks whether a document is free
COMPUTED = "Being computed: the parts still have an earlier shape."
STOPPED = "Not computed: recompute the document to get the final shape."


class Finish(QtCore.QObject):
    """Computes one morph until its parts have their final shape, or it is stopped."""

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
        self._worker = FrameWorker(self._compute, self)  # last: it has to be stopped

    def take(self, scene) -> None:
        """Owns a LiveScene: it is shown until the final shape is."""
        self.drop_scene()
        self._scene = scene

    def expect(self, morph) -> None:
        """Computes this morph first. It most likely equals the document, and reading that takes
        long with many regions."""
        self._expected = morph

    def drop_scene(self) -> None:
        """Shows the meshes as the document has them."""
        if self._scene is not None:
            self._scene.remove()
        self._scene = None

    @property
    def percent(self) -> int:
        """How much of the present task is done."""
        return round(100.0 * self._fraction)

    @property
    def is_computing(self) -> bool:
        """Whether its thread is at work."""
        return not self._worker.is_idle

    def end(self) -> None:
        """Computes and shows nothing any more, and waits for nothing."""
        self.is_over = True
        self._worker.stop()
        self.drop_scene()

    def stop(self) -> None:
        """The user does not want to wait: the parts stay due."""
        self.end()
        if self.assembly() is not None:
            solving.tell_status(self.assembly(), STOPPED)

    def assembly(self):
        """The morph, None if it is gone."""
        is_open = App.listDocuments().get(self._document_name) == self._document
        return self._document.getObject(self._name) if is_open else None

    def is_in(self, document) -> bool:
        """Whether it is a morph of a document."""
        return self._document == document

    def look(self) -> None:
        """Goes on as far as it can at once; the document is free."""
        if not self._worker.is_idle:
            return
        expected, self._expected = self._expected, None
        if expected is not None and not self._cache.is_known(expected):
            self._ask(expected)
            return
        try:
            morph = solving.read_morph(self.assembly())
        except (MorphError, *solving.FAILURES):
            self.apply()  # the recompute says what is wrong
            return
        if self._cache.is_known(morph) or not morph.is_held():
            self.apply()
        else:
            self._ask(morph)

    def _ask(self, morph) -> None:
        solving.tell_status(self.assembly(), COMPUTED)
        self._worker.ask(morph)

    def is_answered(self, seconds: float) -> bool:
        """Whether the answer is there within some seconds; in the thread of the window."""
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
        """Gives the parts their shape."""
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
        """In the thread."""
        return self._cache.compute(morph, self._goes_on)

    def _goes_on(self, fraction: float, task: str) -> bool:
        """In the thread: whether to go on."""
        self._fraction = fraction
        self._worker.tell(task)
        return self._worker.is_free

    # -- what the worker calls

    def on_answer(self, _outcome) -> None:
        """The next look finds the answer."""

    def on_fault(self, text: str) -> None:
        """There will be no answer."""
        self.stop()
        self._tell(text)

    def on_progress(self, task: str) -> None:
        """What is under way."""
        self.task = task


class Finishing(QtCore.QObject):
    """All morphs of the program whose final shape is on its way.

    ``finished`` is sent with a morph whose parts have got it, or will not.
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
        """Lets the parts of a morph follow its present pose in the background. ``is_quiet``: a
        fault is left to the report view."""
        key = assembly.Document.Name, assembly.Name
        job = self._jobs.get(key)
        if job is None or job.is_over:
            job = self._jobs[key] = Finish(assembly, is_quiet)
        self._timer.start()
        return job

    def look_at(self, document) -> None:
        """A document is opened: what was saved before its final shape was there gets it."""
        if document not in self._opened:
            self._opened.append(document)
            self._timer.start()

    def is_quick(self, assembly) -> bool:
        """Whether a recompute of a morph takes no time, after a wait of `PATIENCE` at most. The
        solve of a small one goes on in the background otherwise."""
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
        """Whether a final shape is on its way and may come."""
        jobs = self._jobs.values()
        return bool(self._opened) or any(not j.is_over and not self._is_held(j) for j in jobs)

    def is_due(self, assembly) -> bool:
        """Whether the parts of a morph still have an earlier shape."""
        return any(job.assembly() == assembly for job in self._jobs.values() if not job.is_over)

    def drop_scene(self, assembly) -> None:
        """A panel is going to show the morph itself."""
        for job in self._jobs.values():
            if job.assembly() == assembly:
                job.drop_scene()

    def hold(self, session) -> None:
        """A panel with a session is open: see `_is_held`."""
        self._holds.append(session)

    def release(self, session) -> None:
        """That session is over."""
        self._holds = [one for one in self._holds if one is not session]

    def stop_all(self) -> None:
        """The user does not want to wait."""
        for job in self._jobs.values():
            if not job.is_over:
                job.stop()

    def _is_held(self, job) -> bool:
        """Whether an open panel keeps shapes out of its document: one that moves handles shows the
        parts itself."""
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

    # -- what FreeCAD calls, in the midst of changes

    def slotUndoDocument(self, document) -> None:
        """The meshes that came after the step are not undone with it."""
        for assembly in due_in(document):
            self.finish(assembly, is_quiet=True)

    slotRedoDocument = slotUndoDocument

    def slotDeletedDocument(self, document) -> None:
        """Stops what was computed for it."""
        self._opened = [one for one in self._opened if one != document]
        for job in self._jobs.values():
            if job.is_in(document) and not job.is_over:
                job.end()


def is_free(job) -> bool:
    """Whether no recompute, open step or dialog is in the way of changing the document."""
    document = job.assembly().Document
    if document.Recomputing or document.Restoring or document.Transacting:
        return False
    if document.HasPendingTransaction or App.getActiveTransaction() is not None:
        return False
    return QtWidgets.QApplication.activeModalWidget() is None


def vertices_of(assembly) -> int:
    """How many vertices the parts of a morph have."""
    sources = [part.Source for part in model.parts(assembly)]
    return sum(source.Mesh.CountPoints for source in sources if source is not None)


def due_in(document) -> list:
    """The morphs of a document whose parts have an earlier shape; none without the kernel."""
    if not kernel.is_available():
        return []
    morphs = [obj for obj in document.Objects if model.kind(obj) == model.ASSEMBLY]
    return [morph for morph in morphs if is_due(morph)]


def is_due(assembly) -> bool:
    """Whether something that the parts depend on was changed since the last recompute."""
    deformation = model.deformation_of(assembly)
    if deformation is None:
        return False
    concerned = [deformation, *deformation.OutList, *model.parts(assembly)]
    return any("Touched" in obj.State for obj in concerned)


def tell(label: str, text: str) -> None:
    """Reports that a shape failed, in a window that blocks nothing."""
    App.Console.PrintError(f"SheetMorph: {text}\n")
    title = translate("SheetMorph_panels", "The shape of {0} failed").format(label)
    box = QtWidgets.QMessageBox(
        QtWidgets.QMessageBox.Warning, title, text, parent=Gui.getMainWindow()
    )
    box.setAttribute(QtCore.Qt.WA_DeleteOnClose)
    box.setModal(False)
    box.show()


@lru_cache(maxsize=1)
def finishing() -> Finishing:
    """The one of this process, made in the thread of the window."""
    found = Finishing()
    App.addDocumentObserver(found)
    return found

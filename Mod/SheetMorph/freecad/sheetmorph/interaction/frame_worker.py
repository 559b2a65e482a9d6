# SPDX-License-Identifier: LGPL-2.1-or-later
"""Computation in a separate thread, so that a slow frame never blocks the window."""

import os
import sys
import threading
from concurrent import futures

from freecad.sheetmorph import actions
from freecad.sheetmorph.bridge.faults import fault_of
from freecad.sheetmorph.garbage import collecting
from freecad.sheetmorph.objects.errors import Fault
from freecad.sheetmorph.qt import QtCore, translate

NICENESS = 10  # of 19: a thread at 0 gets ten times as much processor time
ENDING: set = set()
"""Stopped workers with a running thread; they stay here until it ends."""


class FrameWorker(QtCore.QObject):
    """A worker that answers one question at a time and replaces the waiting one by a newer.

    `compute(question)` runs in the worker thread. The listener's `on_answer(answer)` or
    `on_fault(text)` runs in the window thread before the next question begins. `on_progress(task)`
    receives the texts that `compute` passes to `tell`. An exception in either thread is a fault,
    and does not prevent the next answer. The owner must call `stop`: until then only the window
    thread collects garbage.
    """

    _computed = QtCore.Signal(object, object)
    _told = QtCore.Signal(str)
    _ended = QtCore.Signal()

    def __init__(self, compute, listener):
        super().__init__()
        self._compute, self._listener = compute, listener
        self._waiting, self._is_busy = None, False
        self._thread = futures.ThreadPoolExecutor(max_workers=1, initializer=give_way)
        self._is_running = True
        collecting().hold()
        self._last_told = ""
        self._computed.connect(self._deliver, QtCore.Qt.QueuedConnection)
        self._told.connect(self._pass_on, QtCore.Qt.QueuedConnection)
        self._ended.connect(self._let_go, QtCore.Qt.QueuedConnection)

    @property
    def is_idle(self) -> bool:
        """Whether no computation with a listener is running."""
        return self._listener is None or not self._is_busy

    @property
    def is_free(self) -> bool:
        """Whether the current computation still matters.

        It does while there is a listener and no newer question waits.
        """
        return self._listener is not None and self._waiting is None

    def ask(self, question) -> None:
        """Start to answer a question, or let it wait in place of another one."""
        if self._is_busy:
            self._waiting = question
        else:
            self._begin(question)

    def tell(self, task: str) -> None:
        """Report the present task, once each; runs in the worker thread."""
        if task != self._last_told:
            self._last_told = task
            self._told.emit(task)

    def hush(self) -> None:
        """Deliver nothing more."""
        self._waiting = self._listener = None

    def stop(self) -> None:
        """Deliver nothing more, and return without waiting for the thread.

        The running computation ends at its next check of `is_free`.
        """
        self.hush()
        if self._is_running:
            self._is_running = False
            if not self._is_busy:
                self._thread.shutdown(wait=True)
                self._let_go()
                return
            ENDING.add(self)
            self._thread.submit(self._ended.emit)
            self._thread.shutdown(wait=False)

    def _let_go(self) -> None:
        """Release the resources after the thread has ended."""
        ENDING.discard(self)
        self._compute = None
        collecting().release()

    def _begin(self, question) -> None:
        self._is_busy = True
        self._thread.submit(self._run, question)

    def _run(self, question) -> None:
        try:
            answer, fault = self._compute(question), ""
        except Exception as error:  # any error is shown, and the next frame is tried
            answer, fault = None, sentence_of(error)
        self._computed.emit(answer, fault)

    def _pass_on(self, task: str) -> None:
        if self._listener is not None:
            self._listener.on_progress(task)

    def _deliver(self, answer, fault: str) -> None:
        if self._listener is None:
            return
        if not fault:
            try:
                self._listener.on_answer(answer)
            except Exception as error:  # as above: the worker must not stay busy for ever
                fault = sentence_of(error)
        if fault and self._listener is not None:
            self._listener.on_fault(fault)
        waiting, self._waiting, self._is_busy = self._waiting, None, False
        if waiting is not None:
            self._begin(waiting)


def give_way() -> None:
    """Lower the priority of the current thread, so that the window's thread runs first.

    Only Linux has priorities of single threads.
    """
    if sys.platform == "linux":
        os.setpriority(os.PRIO_PROCESS, threading.get_native_id(), NICENESS)


def sentence_of(error: Exception) -> Fault:
    """Return an error as a fault for the panel."""
    if isinstance(error, MemoryError):
        text = translate(
            "SheetMorph_panels",
            "There is not enough memory for this shape. Close other documents, or "
            "use a coarser mesh.",
        )
        return Fault(text)
    if isinstance(error, actions.FAULTS) and str(error):
        return fault_of(error)
    text = translate(
        "SheetMorph_panels",
        "This shape could not be computed for an unknown reason ({0}). Please " "report it.",
    )
    return Fault(text.format(" ".join(f"{type(error).__name__} {error}".split())))

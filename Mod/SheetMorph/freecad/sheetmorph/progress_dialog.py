# SPDX-License-Identifier: LGPL-2.1-or-later
"""Shows how far long work is, and lets the user cancel it."""

import time
from concurrent import futures

import FreeCADGui as Gui

from freecad.sheetmorph.garbage import collecting
from freecad.sheetmorph.qt import QtCore, QtWidgets, connect, translate

PATIENCE = 0.4  # seconds until the dialog appears
LOOK = 0.03  # seconds between two looks at what is done in a thread
SHARE = 0.25  # of the time at most, to handle events
LONGEST = 0.3  # seconds without a look


class Progress:
    """Called with how far work is, until ``close``; the dialog appears only if it takes long.

    Meanwhile the views keep their picture: FreeCAD would draw each of them, a million facets
    perhaps, whenever events are handled.
    """

    def __init__(self, title: str):
        self._title = title
        self._begin = time.monotonic()
        self._dialog = None
        self._next = 0.0
        self._told = 0.0, ""
        self.is_cancelled = False
        self._views = Gui.getMainWindow().centralWidget()
        self._views.setUpdatesEnabled(False)

    def __call__(self, fraction: float, task: str) -> bool:
        """``fraction`` 0..1 is done, ``task`` is next; False if the user has cancelled.

        A thread may call it; widgets belong to FreeCAD's.
        """
        self._told = fraction, task
        if is_window_thread():
            self._look()
        return not self.is_cancelled

    def wait_for(self, work):
        """Returns or raises what ``work(progress)`` does, in a thread, while events are handled.

        It must not touch what belongs to the thread of the window: documents, widgets, nodes.
        """
        if not is_window_thread():
            return work(self)
        collecting().hold()
        try:
            with futures.ThreadPoolExecutor(max_workers=1) as thread:
                return self._result(thread.submit(work, self))
        finally:
            collecting().release()

    def _result(self, found):
        """What a future brings; whatever events do, the thread is not left alone."""
        try:
            while not found.done():
                futures.wait([found], timeout=LOOK)
                self._look()
            self._look(at_last=True)  # Cancel counts if it was pressed in time
        except BaseException:
            self.is_cancelled = True
            raise
        return found.result()

    def _look(self, at_last: bool = False) -> None:
        """Shows how far it is, if it takes long, and sees whether Cancel was pressed."""
        begin = time.monotonic()
        if self._dialog is None and begin - self._begin > PATIENCE:
            self._open()
        if self._dialog is None or (begin < self._next and not at_last):
            return
        fraction, task = self._told
        self._dialog.tell(fraction, task)
        QtWidgets.QApplication.processEvents()
        self.is_cancelled = self.is_cancelled or self._dialog.is_cancelled
        now = time.monotonic()
        self._next = now + min(LONGEST, (now - begin) / SHARE)

    def close(self) -> None:
        """Takes the dialog away, and lets the views be drawn."""
        self._views.setUpdatesEnabled(True)
        if self._dialog is not None:
            self._dialog.hide()
            self._dialog.deleteLater()
            self._dialog = None

    def _open(self) -> None:
        self._dialog = ProgressDialog(self._title)
        self._dialog.show()


class ProgressDialog(QtWidgets.QProgressDialog):
    """Keeps the window shut until it is taken away, also after Cancel: what is under way ends when
    it next looks, and until then nobody else may touch what it works on.

    Only a click or Escape cancels: Return or a space typed before the dialog came is for the field
    that had the keyboard then.
    """

    def __init__(self, title: str):
        cancel = translate("SheetMorph_actions", "Cancel")
        super().__init__(title, cancel, 0, 100, Gui.getMainWindow())
        self.is_cancelled = False
        self.setObjectName("SheetMorphProgress")
        self.setWindowTitle(title)
        self.setWindowModality(QtCore.Qt.ApplicationModal)
        self.setAutoClose(False)
        self.setAutoReset(False)
        self.setMinimumWidth(380)
        self.setMinimumDuration(0)
        self.setCursor(QtCore.Qt.ArrowCursor)
        self._button = self.findChild(QtWidgets.QPushButton)
        self._button.setAutoDefault(False)
        self._button.setFocusPolicy(QtCore.Qt.NoFocus)
        hides = QtCore.SIGNAL("canceled()"), self, QtCore.SLOT("cancel()")
        QtCore.QObject.disconnect(self, *hides)
        connect(self, "canceled()", self._cancel)

    def tell(self, fraction: float, task: str) -> None:
        """Shows how far it is, 0..1, and what is next."""
        if not self.is_cancelled:
            self.setLabelText(task)
            self.setValue(round(100 * fraction))

    def closeEvent(self, event) -> None:
        """The window's own button cancels, too."""
        event.ignore()
        self._cancel()

    def reject(self) -> None:
        """Escape, where no shortcut takes it."""
        self._cancel()

    def _cancel(self) -> None:
        self.is_cancelled = True
        self._button.setEnabled(False)
        self.setLabelText(translate("SheetMorph_actions", "Cancelling…"))


def is_window_thread() -> bool:
    """Whether this is the thread of FreeCAD's window."""
    return QtCore.QThread.currentThread() == QtWidgets.QApplication.instance().thread()

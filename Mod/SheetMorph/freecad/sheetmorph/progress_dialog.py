# SPDX-License-Identifier: LGPL-2.1-or-later
"""A progress dialog for long work, with Cancel."""

import time
from concurrent import futures

import FreeCADGui as Gui

from freecad.sheetmorph.garbage import collecting
from freecad.sheetmorph.qt import QtCore, QtWidgets, connect, translate

PATIENCE = 0.4  # s until the dialog appears
LOOK = 0.03  # s between two checks of a thread's progress
SHARE = 0.25  # largest share of the time for handling events
LONGEST = 0.3  # s without a check


class Progress:
    """A callable that receives progress until `close`, with a dialog for long work.

    The views are frozen meanwhile. FreeCAD would otherwise redraw each of them, possibly with a
    million facets, whenever events are handled.
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
        """Set the done `fraction` (0 to 1) and the next `task`; return False after Cancel.

        Any thread may call it; only the window thread uses widgets.
        """
        self._told = fraction, task
        if is_window_thread():
            self._look()
        return not self.is_cancelled

    def wait_for(self, work):
        """Return or raise the result of `work(progress)` in a thread, while handling events.

        The work must not use documents, widgets or nodes, which belong to the window thread.
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
        """Return the result of a future; after an exception the thread is cancelled."""
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
        """Show the progress if the work takes long, and check for Cancel."""
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
        """Remove the dialog and let the views be drawn."""
        self._views.setUpdatesEnabled(True)
        if self._dialog is not None:
            self._dialog.hide()
            self._dialog.deleteLater()
            self._dialog = None

    def _open(self) -> None:
        self._dialog = ProgressDialog(self._title)
        self._dialog.show()


class ProgressDialog(QtWidgets.QProgressDialog):
    """A modal dialog that stays until it is removed, also after Cancel.

    The work ends at its next check, and until then its data must not change. Only a click or Escape
    cancels, because Return or a space may be meant for the field that had the keyboard before.
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
        """Show the progress, 0 to 1, and the next task."""
        if not self.is_cancelled:
            self.setLabelText(task)
            self.setValue(round(100 * fraction))

    def closeEvent(self, event) -> None:
        """Cancel when the window's close button is pressed."""
        event.ignore()
        self._cancel()

    def reject(self) -> None:
        """Cancel on Escape, if no shortcut consumes it."""
        self._cancel()

    def _cancel(self) -> None:
        self.is_cancelled = True
        self._button.setEnabled(False)
        self.setLabelText(translate("SheetMorph_actions", "Cancelling…"))


def is_window_thread() -> bool:
    """Return whether this is the thread of FreeCAD's window."""
    return QtCore.QThread.currentThread() == QtWidgets.QApplication.instance().thread()

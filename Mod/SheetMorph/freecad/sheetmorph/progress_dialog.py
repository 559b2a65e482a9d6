# SPDX-License-Identifier: LGPL-2.1-or-later
"""Shows how far long work is, and lets the user cancel it."""

import time

import FreeCADGui as Gui

from freecad.sheetmorph.qt import QtCore, QtWidgets

PATIENCE = 1.0  # seconds until the dialog appears
SHARE = 0.1  # of the time at most, to handle events: each look may draw a view of a million facets


class Progress:
    """Called by the kernel with how far it is; the dialog appears only if it takes long."""

    def __init__(self, title: str):
        self._title = title
        self._begin = time.monotonic()
        self._dialog = None
        self._next = 0.0
        self.is_cancelled = False

    def __call__(self, fraction: float, task: str) -> bool:
        """``fraction`` 0..1 is done, ``task`` is next; False if the user has cancelled.

        The kernel may call it from threads of its own; widgets belong to FreeCAD's.
        """
        if QtCore.QThread.currentThread() != QtWidgets.QApplication.instance().thread():
            return not self.is_cancelled
        if self._dialog is None and time.monotonic() - self._begin > PATIENCE:
            self._open()
        if self._dialog is not None and time.monotonic() >= self._next:
            self._tell(fraction, task)
        return not self.is_cancelled

    def _tell(self, fraction: float, task: str) -> None:
        """Shows how far it is, and sees whether Cancel was pressed."""
        begin = time.monotonic()
        self._dialog.setLabelText(task)
        self._dialog.setValue(round(100 * fraction))
        QtWidgets.QApplication.processEvents()
        self.is_cancelled = self.is_cancelled or self._dialog.wasCanceled()
        now = time.monotonic()
        self._next = now + min(1.0, (now - begin) / SHARE)

    def close(self) -> None:
        """Takes the dialog away."""
        if self._dialog is not None:
            self._dialog.reset()
            self._dialog.deleteLater()
            self._dialog = None

    def _open(self) -> None:
        self._dialog = QtWidgets.QProgressDialog(self._title, "Cancel", 0, 100, Gui.getMainWindow())
        self._dialog.setObjectName("SheetMorphProgress")
        self._dialog.setWindowTitle(self._title)
        self._dialog.setWindowModality(QtCore.Qt.ApplicationModal)
        self._dialog.setAutoClose(False)
        self._dialog.setAutoReset(False)
        self._dialog.setMinimumWidth(380)
        self._dialog.setMinimumDuration(0)
        self._dialog.setCursor(QtCore.Qt.ArrowCursor)
        self._dialog.show()

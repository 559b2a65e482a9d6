# SPDX-License-Identifier: LGPL-2.1-or-later
"""Garbage collection in the window thread only, while another thread runs Python.

Python's collector runs in whichever thread allocates. Widgets and scene nodes in the cycles of a
closed panel would be destroyed in the wrong thread, and FreeCAD would crash later.
"""

import gc

from freecad.sheetmorph.qt import QtCore, connect

PERIOD = 500  # ms between two checks
OLDEST = 1  # generation: older garbage is left to the automatic collector afterwards


class Collecting(QtCore.QObject):
    """The collector: automatic outside of `hold` and `release`, from the event loop in between."""

    def __init__(self):
        super().__init__()
        self._holds = 0
        self._was_automatic = False
        self._timer = QtCore.QTimer(self)
        self._timer.setInterval(PERIOD)
        connect(self._timer, "timeout()", self.collect)

    def hold(self) -> None:
        """Switch to the event loop before a thread begins; call it in the window thread."""
        self._holds += 1
        if self._holds == 1:
            self._was_automatic = gc.isenabled()
            gc.disable()
            self._timer.start()

    def release(self) -> None:
        """Return to automatic collection after the thread ends; call it in the window thread."""
        self._holds -= 1
        if self._holds == 0:
            self._timer.stop()
            if self._was_automatic:
                gc.enable()

    def collect(self) -> None:
        """Collect the generations that the automatic collector would have collected by now."""
        counts, limits = gc.get_count(), gc.get_threshold()
        due = [k for k in range(OLDEST + 1) if 0 < limits[k] < counts[k]]
        if due:
            gc.collect(due[-1])


_collecting: list = []  # one, created in the window thread on first use


def collecting() -> Collecting:
    """Return the only instance of this process."""
    if not _collecting:
        _collecting.append(Collecting())
    return _collecting[0]

# SPDX-License-Identifier: LGPL-2.1-or-later
"""While a thread of ours runs Python, garbage is collected in the thread of the window alone.

Python's collector runs in whatever thread happens to allocate. The widgets and scene nodes in the
cycles that a closed panel leaves would be destroyed in a thread that they do not belong to, and
FreeCAD would die of it some other time.
"""

import gc

from freecad.sheetmorph.qt import QtCore, connect

PERIOD = 500  # ms between two looks
OLDEST = 1  # generation: all garbage is left to the automatic collector afterwards


class Collecting(QtCore.QObject):
    """Automatic outside of ``hold`` and ``release``, from the event loop in between."""

    def __init__(self):
        super().__init__()
        self._holds = 0
        self._was_automatic = False
        self._timer = QtCore.QTimer(self)
        self._timer.setInterval(PERIOD)
        connect(self._timer, "timeout()", self.collect)

    def hold(self) -> None:
        """Before a thread begins; in the thread of the window."""
        self._holds += 1
        if self._holds == 1:
            self._was_automatic = gc.isenabled()
            gc.disable()
            self._timer.start()

    def release(self) -> None:
        """After it has ended; in the thread of the window."""
        self._holds -= 1
        if self._holds == 0:
            self._timer.stop()
            if self._was_automatic:
                gc.enable()

    def collect(self) -> None:
        """What the automatic collector would have done by now."""
        counts, limits = gc.get_count(), gc.get_threshold()
        due = [k for k in range(OLDEST + 1) if 0 < limits[k] < counts[k]]
        if due:
            gc.collect(due[-1])


_collecting: list = []  # one, made in the thread of the window when it is first needed


def collecting() -> Collecting:
    """The one for this process."""
    if not _collecting:
        _collecting.append(Collecting())
    return _collecting[0]

# SPDX-License-Identifier: LGPL-2.1-or-later
"""Whether FreeCAD has done what it was asked: what a test waits for in place of a time.

Timers and threads of the workbench are seen as they begin; nothing of them is changed.
"""

import time
import weakref

import FreeCAD as App
import FreeCADGui as Gui
from PySide import QtCore, QtGui

LONGEST = 3000  # ms: what is put off for longer is no part of an answer
LOOKS = 3  # in which nothing has changed

_later = QtCore.QTimer.singleShot  # as it was before the watch
_due = {"last": 0.0}  # when the last timer that was started is over
_workers = weakref.WeakSet()


class Documents:
    """The open documents: App.listDocuments of FreeCAD 0.20 leaks memory, and tests ask all the
    time."""

    def __init__(self):
        self.found = list(App.listDocuments().values())
        App.addDocumentObserver(self)

    def slotCreatedDocument(self, document) -> None:
        self.found.append(document)

    def slotDeletedDocument(self, document) -> None:
        self.found.remove(document)


DOCUMENTS = Documents()


def watch() -> None:
    """From now on; before the first test."""
    from freecad.sheetmorph.interaction.frame_worker import FrameWorker

    single_shot, start, make = QtCore.QTimer.singleShot, QtCore.QTimer.start, FrameWorker.__init__

    def noted_shot(delay, *arguments):
        note(delay)
        return single_shot(delay, *arguments)

    def noted_start(timer, *delay):
        if timer.isSingleShot():
            note(delay[0] if delay else timer.interval())
        return start(timer, *delay)

    def noted_worker(worker, *arguments):
        make(worker, *arguments)
        _workers.add(worker)

    QtCore.QTimer.singleShot = staticmethod(noted_shot)
    QtCore.QTimer.start = noted_start
    FrameWorker.__init__ = noted_worker


def note(delay: int) -> None:
    if delay <= LONGEST:
        _due["last"] = max(_due["last"], time.monotonic() + delay / 1000.0)


def due() -> float:
    """When, of time.monotonic(), all that was put off so far will have been done."""
    return _due["last"]


class Looks:
    """Called again and again between events: true when nothing happens any more."""

    def __init__(self, is_under_way):
        self._is_under_way = is_under_way
        self._before, self._alike = None, 0

    def __call__(self) -> bool:
        now = seen()
        is_alike = now == self._before and not self._is_under_way()
        self._before, self._alike = now, self._alike + 1 if is_alike else 0
        return self._alike >= LOOKS


def is_anything_due() -> bool:
    """Whether something was put off for a moment."""
    return time.monotonic() < _due["last"]


def is_at_work() -> bool:
    """Whether FreeCAD or the workbench does something for which the window waits."""
    if any(one.Recomputing or one.Restoring or one.Transacting for one in DOCUMENTS.found):
        return True
    from freecad.sheetmorph.interaction.finishing import finishing

    if finishing().is_under_way():
        return True
    modal = QtGui.QApplication.activeModalWidget()
    if modal is not None and modal.objectName() == "SheetMorphProgress":
        return True
    return is_anything_due()


def is_under_way() -> bool:
    """Whether something of FreeCAD or the workbench has yet to end."""
    return is_at_work() or any(not worker.is_idle for worker in list(_workers))


def on_screen(widget) -> tuple:
    """Where a widget is on the screen: since FreeCAD 1.0 a panel may slide in with all round it."""
    corner = widget.mapToGlobal(QtCore.QPoint(0, 0))
    return corner.x(), corner.y(), widget.width(), widget.height()


def seen() -> tuple:
    """Where things are on the screen."""
    from freecad.sheetmorph.generations import viewer_of

    window = Gui.getMainWindow()
    docks = window.findChildren(QtGui.QDockWidget)
    places = [on_screen(dock) for dock in docks if dock.isVisible()]
    view = Gui.ActiveDocument.ActiveView if Gui.ActiveDocument else None
    renderer = viewer_of(view).getSoRenderManager() if hasattr(view, "getViewer") else None
    camera = renderer.getCamera() if renderer else None
    if camera:  # a view that closes has none, and FreeCAD dies of the question for it
        places += [view.getSize(), camera.position.getValue().getValue()]
        places += [camera.orientation.getValue().getValue()]
    return window.geometry().getRect(), QtGui.QApplication.activeWindow() is None, tuple(places)


def receive() -> None:
    """Lets FreeCAD read what the screen has for it; it is handled before the next look.

    In a timer of its own: a dialog that it opens and that waits for its end would otherwise wait
    inside the test, which could not answer it.
    """
    _later(0, QtGui.QGuiApplication.sync)

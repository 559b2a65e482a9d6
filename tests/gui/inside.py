# SPDX-License-Identifier: LGPL-2.1-or-later
"""Runs inside FreeCAD: a test is a generator that yields how many ms the event loop shall run."""

import importlib
import os
import sys
import time
import traceback

import FreeCAD as App
import FreeCADGui as Gui
from PySide import QtCore, QtGui

later = QtCore.QTimer.singleShot  # as it was before the watch on timers
HERE = os.path.dirname(os.path.abspath(__file__))
WORK = os.environ["SHEETMORPH_GUI_WORK"]
CLAIMS = os.environ["SHEETMORPH_GUI_CLAIMS"]  # a folder that those who run beside us know too
LIMIT = 600  # seconds, then a test hangs; the longest takes 20 on an idle machine
if os.environ["SHEETMORPH_GUI_TESTS"] in ("large", "vandal"):
    LIMIT = 2900

if HERE not in sys.path:
    sys.path.insert(0, HERE)


class Runner:
    """Drives the tests from timers, so that FreeCAD's event loop is never blocked."""

    def __init__(self, tests):
        self._tests = list(tests)
        self._results = open(os.path.join(WORK, "results"), "w", encoding="utf-8")
        self._name, self._steps, self._start = "", None, 0.0
        self._failed = False
        self._spent = self._last = 0.0

    def next_test(self) -> None:
        """Starts the next test that nobody else has begun, or ends FreeCAD."""
        while self._tests and not claim(self._tests[0][0]):
            self._tests.pop(0)
        if not self._tests:
            self._results.write("END\n")
            self._results.close()
            os._exit(1 if self._failed else 0)
        self._name, function = self._tests.pop(0)
        with open(os.path.join(WORK, "running"), "w", encoding="utf-8") as running:
            running.write(f"{self._name}\n")
        self._start = self._last = time.monotonic()
        self._spent = 0.0
        self._steps = function()
        later(100, self.step)

    def step(self) -> None:
        """Runs a test up to its next pause; a recompute, which handles events too, is let be."""
        if any(document.Recomputing for document in settling.DOCUMENTS.found):
            later(20, self.step)
            return
        try:
            begin = time.monotonic()
            pause = next(self._steps)
            # What another program has stopped counts little.
            self._spent += min(begin - self._last, 5.0) + min(time.monotonic() - begin, 60.0)
            self._last = time.monotonic()
            if self._spent > LIMIT:
                self._steps.throw(
                    TimeoutError(f"after {LIMIT} s it waits for {desk.WAITED['for']}")
                )
        except StopIteration:
            said = desk.report_view()
            is_clean = "Traceback" not in said
            self.report("PASS" if is_clean else "FAIL", "" if is_clean else f"\n{said}")
        except Exception:  # noqa: B902 - whatever a test raises is its result
            self.report("FAIL", "\n" + traceback.format_exc())
        else:
            later(int(pause or 0), self.step)

    def report(self, verdict: str, text: str) -> None:
        """Notes the result, then closes what the test left open."""
        seconds = time.monotonic() - self._start
        self._results.write(f"{verdict} {self._name} ({seconds:.1f} s){text}\n")
        while desk.NOTES:
            self._results.write(f"NOTE {desk.NOTES.pop(0)}\n")
        self._results.flush()
        if verdict == "FAIL":
            self._failed = True
            desk.picture(f"failed-{self._name}")
        self.clean_up()

    def clean_up(self) -> None:
        """Closes what the test left open, as soon as nothing modal would block the next one."""
        modal = QtGui.QApplication.activeModalWidget()
        if modal is not None:  # one that shows progress stays until the work has ended
            modal.close()
            later(20, self.clean_up)
            return
        if Gui.Control.activeDialog():
            Gui.Control.closeDialog()
        desk.Recorder.stop()
        for name in list(App.listDocuments()):
            App.closeDocument(name)
        desk.clear_report_view()
        forget_preferences()
        later(100, self.next_test)


def claim(name: str) -> bool:
    """Claims a test; false if somebody else has it."""
    try:
        os.mkdir(os.path.join(CLAIMS, name))
    except FileExistsError:
        return False
    return True


def forget_preferences() -> None:
    """What one test chose is no concern of the next."""
    from freecad.sheetmorph import preferences

    preferences.reset()


def collect():
    """The tests of the module that the environment names, in their order."""
    module = importlib.import_module("tests_" + os.environ["SHEETMORPH_GUI_TESTS"])
    only = os.environ.get("SHEETMORPH_GUI_ONLY", "")
    return [
        (name, function)
        for name, function in vars(module).items()
        if name.startswith("test_") and only in name
    ]


def prepared() -> Runner:
    """The runner, or the reason why there is none: FreeCAD itself would go on waiting."""
    try:
        tests = collect()
    except Exception:  # noqa: B902
        with open(os.path.join(WORK, "results"), "w", encoding="utf-8") as results:
            results.write(f"FAIL the tests cannot be loaded\n{traceback.format_exc()}\n")
        os._exit(1)
    return Runner(tests)


if __name__ != "__main__":  # FreeCAD imports the script, and runs it again if that fails
    import desk
    import settling

    Gui.getMainWindow().showMaximized()
    settling.watch()
    runner = prepared()  # kept: a timer does not keep the object whose method it calls
    later(500, runner.next_test)

# SPDX-License-Identifier: LGPL-2.1-or-later
"""OK, Cancel and Esc answer at once, however long the shape takes; nothing is lost meanwhile.

Every solve for an exact shape takes some seconds here and looks at no wish to stop it. Measured is
the time from the click until the event loop has nothing to do, and apart from it how long the
views draw.
"""

import os
import threading
import time

import FreeCAD as App
import FreeCADGui as Gui
import numpy as np
from checks_moving import lifted, open_panel
from desk import WORK, buttons_called, child, clear_report_view, laid_out, note, panel, picture
from desk import press, settled, until
from freecad.sheetmorph import api
from freecad.sheetmorph.bridge import kernel
from freecad.sheetmorph.interaction import finishing
from freecad.sheetmorph.interaction.live_scene import STRETCH
from freecad.sheetmorph.objects import model
from hostile_panels import PANELS, is_shown, prepared
from painting import Painting
from PySide import QtCore, QtGui
from scenes import assembly, drawn, largest, new_morph, part, regions, stored

__all__ = [
    "test_ok_of_move_handle_does_not_wait_for_the_shape",
    "test_ok_keeps_the_shape_that_was_shown_as_final",
    "test_ok_and_undo_and_redo_at_once",
    "test_ok_and_the_part_is_deleted_at_once",
    "test_ok_and_the_document_is_closed_at_once",
    "test_ok_and_a_saved_document_is_opened_again_before_the_shape_is_there",
    "test_a_script_has_the_right_shape_while_it_is_computed_in_the_background",
    "test_a_document_under_steel_is_opened_again_and_is_final_in_its_panel",
    "test_a_stopped_shape_comes_with_the_next_recompute",
    "test_a_shape_that_fails_after_ok_is_told",
    "test_ok_of_every_panel_answers_while_solves_are_slow",
    "test_cancel_and_escape_of_every_panel_answer_while_solves_are_slow",
]
SLOW = 4.0  # seconds of a solve
BOUND = 1.5  # seconds: far below SLOW, far above what a loaded machine needs


class SlowSolves:
    """In this context every exact solve lasts; ``count`` says how many have begun."""

    def __init__(self, seconds: float = SLOW, fault=None):
        self._seconds, self._fault = seconds, fault
        self.count, self._ended = 0, threading.Event()

    def __enter__(self):
        self._kind = kernel.load().Session
        self._before = self._kind.deform
        before = self._before

        def deform(session, pose=None, exact=True, progress=None):
            if exact:
                self.count += 1
                self._ended.wait(self._seconds)
                if self._fault is not None:
                    raise self._fault
            return before(session, pose, exact, progress)

        self._kind.deform = deform
        return self

    def __exit__(self, *_):
        self._ended.set()
        self._kind.deform = self._before


def timed(act, act_name: str, bound: float = BOUND):
    """Does something and waits until the event loop is idle. Notes how long closing the panel
    takes, the time until idle, and the drawing of the 3D view, which the bound leaves out."""
    found, begin = [], time.monotonic()

    def is_idle() -> None:
        found.extend((time.monotonic() - begin - painting.seconds, painting.seconds))

    with Painting() as painting:
        act()
        closed = 1000.0 * (time.monotonic() - begin)
        QtCore.QTimer.singleShot(0, lambda: QtCore.QTimer.singleShot(0, is_idle))
        yield from until(lambda: found, f"{act_name} to be answered")
    taken, drawn = found[0], 1000.0 * found[1]
    note(f"{act_name}: {closed:.0f} ms, idle after {1000.0 * taken:.0f}, {drawn:.0f} of drawing")
    assert taken < bound, f"{act_name}: {taken:.2f} s"


def click(text: str, bound: float = BOUND):
    """Clicks a button of the task view and measures until the event loop is idle."""
    (button,) = buttons_called(text)
    yield from timed(button.click, f"{text} of {panel().objectName()}", bound)


def escape(bound: float = BOUND):
    """Presses Escape in the panel and measures until the event loop is idle."""
    form = panel()
    name = form.objectName()

    def act() -> None:
        key = QtGui.QKeyEvent(QtCore.QEvent.KeyPress, QtCore.Qt.Key_Escape, QtCore.Qt.NoModifier)
        QtGui.QApplication.sendEvent(form, key)

    yield from timed(act, f"Esc of {name}", bound)


def moved(height: str = "20"):
    """The open panel with a handle that was moved, and its first frame."""
    yield from open_panel()
    child("translation_z").setValue(float(height))
    yield from until(lambda: child("status").text().startswith("Computed"), "a frame")


def is_final() -> bool:
    return not finishing.finishing().is_due(assembly())


def shown_bar() -> list:
    bars = Gui.getMainWindow().findChildren(QtGui.QWidget, "SheetMorphFinishing")
    return [bar for bar in bars if bar.isVisible()]


def test_ok_of_move_handle_does_not_wait_for_the_shape():
    yield from new_morph()
    rest = stored()
    with SlowSolves() as solves:
        yield from moved()
        yield from click("OK")
        assert not Gui.Control.activeDialog() and App.ActiveDocument.UndoNames == ["Move Handle"]
        yield from until(shown_bar, "the bar")
        picture("answering-computed")
        assert np.array_equal(stored(), rest) and not is_final()
        assert "Computing" in assembly().Status
        assert np.allclose(lifted(rest, drawn()), (0, 0, 20), atol=1e-3), "the view keeps it"
        yield from until(is_final, "the final shape")
        assert solves.count == 1
    assert np.allclose(lifted(rest, stored()), (0, 0, 20), atol=1e-3)
    assert assembly().Status == "Up to date." and not shown_bar()
    assert largest(drawn() - stored()) == 0.0
    picture("answering-final")


def test_ok_keeps_the_shape_that_was_shown_as_final():
    yield from new_morph()
    rest = stored()
    with SlowSolves() as solves:
        yield from moved()
        yield from settled()
        assert solves.count == 1, "the pause"
        final = stored()
        assert np.allclose(lifted(rest, final), (0, 0, 20), atol=1e-3)
        yield from click("OK")
        yield from until(is_final, "the end")
        App.ActiveDocument.recompute()
        App.ActiveDocument.undo()
        yield from settled()
        App.ActiveDocument.redo()
        yield from settled()
        assert np.array_equal(stored(), final)
        assert solves.count <= 2, "the shape at rest may have to be solved, the final one not"


def test_ok_and_undo_and_redo_at_once():
    yield from new_morph()
    rest = stored()
    with SlowSolves():
        yield from moved()
        yield from click("OK")
        yield from timed(App.ActiveDocument.undo, "undo after OK")
        assert regions("handle")[0].TranslationZ.Value == 0.0
        yield from until(is_final, "the shape at rest")
        assert largest(stored() - rest) < 1e-3 and largest(drawn() - rest) < 1e-3
        yield from timed(App.ActiveDocument.redo, "redo")
        yield from until(is_final, "the final shape")
    assert np.allclose(lifted(rest, stored()), (0, 0, 20), atol=1e-3)
    assert App.ActiveDocument.UndoNames == ["Move Handle"]


def test_ok_and_the_part_is_deleted_at_once():
    yield from new_morph()
    with SlowSolves():
        yield from moved()
        yield from click("OK")
        api.remove(part())
        yield from until(lambda: not finishing.finishing().is_under_way(), "the end")
    assert model.parts(assembly()) == [] and not shown_bar()
    App.ActiveDocument.recompute()
    yield from settled()
    clear_report_view()


def test_ok_and_the_document_is_closed_at_once():
    yield from new_morph()
    with SlowSolves():
        yield from moved()
        yield from click("OK")
        yield from until(shown_bar, "the bar")
        yield from timed(lambda: App.closeDocument(App.ActiveDocument.Name), "closing after OK")
        yield from until(lambda: not shown_bar(), "the bar to go")
        assert not finishing.finishing().is_under_way()
    yield from settled()


def test_ok_and_a_saved_document_is_opened_again_before_the_shape_is_there():
    yield from new_morph()
    rest, path = stored(), os.path.join(WORK, "answering.FCStd")
    with SlowSolves():
        yield from moved()
        yield from click("OK")
        App.ActiveDocument.saveAs(path)
        App.closeDocument(App.ActiveDocument.Name)
        yield from timed(lambda: App.openDocument(path), "opening")
        assert regions("handle")[0].TranslationZ.Value == 20.0
        yield from until(shown_bar, "the bar")
        assert not is_final() and np.array_equal(stored(), rest)
        yield from until(is_final, "the final shape")
    assert np.allclose(lifted(rest, stored()), (0, 0, 20), atol=1e-3)


def test_a_document_under_steel_is_opened_again_and_is_final_in_its_panel():
    """Its colours ask for a frame before anything is moved: a linear preview."""
    yield from new_morph()
    api.set_energy(assembly(), "steel")
    App.ActiveDocument.recompute()
    yield from open_panel()
    child("translation_z").setValue(18.0)
    yield from until(lambda: "Final steel shape" in child("status").text(), "the steel")
    yield from press("OK")
    shape, path = stored(), os.path.join(WORK, "steel.FCStd")
    App.ActiveDocument.saveAs(path)
    App.closeDocument(App.ActiveDocument.Name)
    App.openDocument(path)
    yield from settled()
    yield from open_panel()
    child("colours").setCurrentIndex(STRETCH)
    yield from until(lambda: "Final steel shape" in child("status").text(), "the steel")
    assert largest(drawn() - shape) < 1e-3
    picture("answering-steel")
    yield from press("Cancel")


def test_a_script_has_the_right_shape_while_it_is_computed_in_the_background():
    yield from new_morph()
    rest = stored()
    with SlowSolves() as solves:
        yield from moved()
        yield from click("OK")
        yield from until(shown_bar, "the bar")
        App.ActiveDocument.recompute()
        assert np.allclose(lifted(rest, stored()), (0, 0, 20), atol=1e-3)
        assert solves.count == 1, "it waits for what is under way"
        yield from until(is_final, "the end")
        regions("handle")[0].TranslationZ = 25.0
        App.ActiveDocument.recompute()
    assert np.allclose(lifted(rest, stored()), (0, 0, 25), atol=1e-3)


def test_a_stopped_shape_comes_with_the_next_recompute():
    yield from new_morph()
    rest = stored()
    with SlowSolves():
        yield from moved()
        yield from click("OK")
        yield from until(shown_bar, "the bar")
        (stop,) = Gui.getMainWindow().findChildren(QtGui.QPushButton, "stop_finishing")
        yield from timed(stop.click, "Stop")
        yield from until(lambda: not shown_bar(), "the bar to go")
        assert "Not computed" in assembly().Status and np.array_equal(stored(), rest)
        assert largest(drawn() - rest) < 1e-3
    App.ActiveDocument.recompute()
    assert np.allclose(lifted(rest, stored()), (0, 0, 20), atol=1e-3)
    assert assembly().Status == "Up to date."


def message_boxes() -> list:
    boxes = QtGui.QApplication.topLevelWidgets()
    return [box for box in boxes if isinstance(box, QtGui.QMessageBox) and box.isVisible()]


def test_a_shape_that_fails_after_ok_is_told():
    yield from new_morph()
    with SlowSolves(0.5, ValueError("handle 'Handle': nothing fits")):
        yield from moved()
        yield from click("OK")
        yield from until(message_boxes, "the message")
        assert "nothing fits" in message_boxes()[0].text()
        picture("answering-failed")
        message_boxes()[0].close()
    assert "nothing fits" in model.failure_of(assembly())
    regions("handle")[0].TranslationZ = 8.0
    App.ActiveDocument.recompute()
    assert model.failure_of(assembly()) == ""
    yield from settled()  # until FreeCAD has said it
    clear_report_view()


def begin(name: str):
    """A panel that was used, in a fresh document."""
    for document in list(App.listDocuments()):
        App.closeDocument(document)
    yield from prepared()
    opened, used, _ = PANELS[name]
    opened()
    yield from until(is_shown, f"the panel {name}")
    yield from settled()
    used()
    yield from laid_out()  # what the panel begins by itself after a pause is under way


def test_ok_of_every_panel_answers_while_solves_are_slow():
    """Prepare Mesh makes a new mesh, which it does with a progress dialog."""
    for name in sorted(PANELS.keys() - {"prepare", "study"}):
        yield from begin(name)
        with SlowSolves():
            for text in ("OK", "Close"):
                if is_shown() and len(buttons_called(text)) == 1:
                    yield from click(text)
            yield from until(lambda: not finishing.finishing().is_under_way(), "the end")
        if Gui.Control.activeDialog():  # it says what is missing
            yield from press("Cancel")
        yield from settled()
        clear_report_view()


def test_cancel_and_escape_of_every_panel_answer_while_solves_are_slow():
    for name in sorted(PANELS.keys() - {"guide"}):
        for is_escape in (False, True):
            with SlowSolves():
                yield from begin_slow(name)
                text = next(t for t in ("Cancel", "Close") if len(buttons_called(t)) == 1)
                yield from (escape() if is_escape else click(text))
            yield from until(lambda: not is_shown(), f"{name} to close")
            yield from settled()
            clear_report_view()


def begin_slow(name: str):
    """A panel that is used while solves are slow already."""
    if App.ActiveDocument is None or not App.ActiveDocument.Name.startswith("hostile"):
        yield from prepared()
    opened, used, _ = PANELS[name]
    opened()
    yield from until(is_shown, f"the panel {name}")
    used()
    yield from laid_out()

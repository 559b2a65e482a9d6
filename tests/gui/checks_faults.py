# SPDX-License-Identifier: LGPL-2.1-or-later
"""What is wrong with a morph is one sentence in the panel, with buttons that show and mend it."""

import threading
import time
from pathlib import Path

import FreeCAD as App
import FreeCADGui as Gui
import numpy as np
from checks_moving import lifted, open_panel
from checks_tutorial import answer, menu
from desk import WORK, answered, child, clear_report_view, click_point, click_widget, enter, panel
from desk import picture, press, press_tool, report_view, settled, until
from freecad.sheetmorph import api
from freecad.sheetmorph.interaction.frame_worker import FrameWorker
from freecad.sheetmorph.objects import model
from hostile_panels import is_shown
from PySide import QtGui
from scenes import assembly, drawn, handle_vertices, look, new_assembly, new_morph, part, regions
from scenes import patience, stored
from shapes import sheet

__all__ = [
    "test_two_handles_on_one_vertex_are_shown_and_taken_apart",
    "test_ok_waits_until_what_is_wrong_is_mended",
    "test_a_piece_that_nothing_holds_is_shown_and_left_at_rest",
    "test_a_region_that_cannot_be_is_refused_in_its_panel",
    "test_a_pick_leaves_out_what_another_handle_has_and_says_so",
    "test_a_recipe_keeps_the_meshes_that_it_reads",
    "test_whatever_a_frame_raises_is_shown_and_the_next_one_follows",
    "test_what_is_under_way_ends_when_nobody_listens",
]


class Listener:
    """Notes what a worker delivers; raises what it is told to when it draws."""

    def __init__(self):
        self.answers, self.faults = [], []

    def on_answer(self, answer):
        if isinstance(answer, BaseException):
            raise answer
        self.answers.append(answer)

    def on_fault(self, text):
        self.faults.append(text)

    def on_progress(self, _task):
        pass


RAISED = [
    ValueError("v"), RuntimeError("r"), OSError(28, "full"), TypeError("t"), KeyError("k"),
    MemoryError(), ArithmeticError("a"), ZeroDivisionError("z"), OverflowError("o"),
    FloatingPointError("f"), AssertionError(), AttributeError("x"), BufferError("b"),
    EOFError(), ImportError("i"), IndexError("n"), NameError("m"), RecursionError("d"),
    ReferenceError("e"), StopIteration(), SystemError("s"), UnicodeError("u"),
    np.linalg.LinAlgError("singular"), Exception(),
]  # fmt: skip


def test_whatever_a_frame_raises_is_shown_and_the_next_one_follows():
    def compute(question):
        where, error = question
        if where == "thread":
            raise error
        return error

    listener = Listener()
    worker = FrameWorker(compute, listener)
    try:
        for where in ("thread", "window"):
            for count, error in enumerate(RAISED, 1):
                worker.ask((where, error))
                yield from until(lambda n=count: len(listener.faults) == n, repr(error))
                assert listener.faults[-1].strip(), repr(error)
                worker.ask(("", where))
                yield from until(lambda n=count: len(listener.answers) == n, "the next frame")
            listener.faults.clear()
            listener.answers.clear()
    finally:
        worker.stop()


def test_what_is_under_way_ends_when_nobody_listens():
    begun = threading.Event()

    def compute(_question):
        begun.set()
        while worker.is_free:
            time.sleep(0.001)
        return "ended"

    listener = Listener()
    worker = FrameWorker(compute, listener)
    worker.ask("what takes for ever")
    yield from until(begun.is_set, "the thread")
    worker.stop()
    yield from settled()
    assert listener.answers == [] and listener.faults == []


def add_overlapping_handle():
    """A second handle that has a corner of the first one, moved otherwise; none of it undone."""
    points = sheet()[0]
    (first,) = regions("handle")
    corner = [k for k in handle_vertices() if points[k][1] < 20.0]
    other = np.flatnonzero((points[:, 0] == 80) & (points[:, 1] < 20.0)).tolist()
    second = api.add_handle(assembly(), part(), corner + other, "Second")
    App.ActiveDocument.recompute()
    App.ActiveDocument.clearUndos()
    yield from settled()
    clear_report_view()  # what FreeCAD says about a recompute that failed
    return first, second


def sentence() -> str:
    """What the panel says is wrong."""
    return child("message").text() if child("message").isVisible() else ""


def test_two_handles_on_one_vertex_are_shown_and_taken_apart():
    yield from new_morph()
    rest = stored()
    yield from open_panel()
    assert not child("show_fault").isVisible() and not child("mend_fault").isVisible()
    yield from press("Cancel")
    first, second = yield from add_overlapping_handle()
    Gui.Selection.addSelection(first)
    yield from open_panel()
    yield from enter(child("translation_z"), "15")
    yield from until(lambda: "both move" in sentence(), "the sentence")
    assert report_view().count("both move") == 1, report_view()
    assert "Traceback" not in report_view(), report_view()
    assert child("mend_fault").text() == "Remove from “Second”"
    before = part().ViewObject.RootNode.getNumChildren()
    yield from click_widget(child("show_fault"))
    assert part().ViewObject.RootNode.getNumChildren() == before, "it was painted already"
    picture("fault-shown")
    yield from click_widget(child("mend_fault"))
    yield from until(lambda: not sentence(), "nothing to be wrong")
    tip = sheet()[0][handle_vertices()][:, 1] > 40.0
    yield from until(lambda: np.allclose(lifted(rest, drawn())[tip][:, 2], 15, atol=1e-3), "lift")
    assert not child("mend_fault").isVisible() and not child("show_fault").isVisible()
    yield from press("OK")
    assert set(api.vertices(first)).isdisjoint(api.vertices(second))
    names = App.ActiveDocument.UndoNames
    assert names == ["Move Handle", "Remove from “Second”"], names
    clear_report_view()


def test_ok_waits_until_what_is_wrong_is_mended():
    yield from new_morph()
    first, _ = yield from add_overlapping_handle()
    Gui.Selection.addSelection(first)
    yield from open_panel()
    yield from enter(child("translation_z"), "15")
    yield from press("OK")
    yield from settled()
    assert is_shown() and "both move" in sentence()
    yield from click_widget(child("mend_fault"))
    yield from until(lambda: not sentence(), "nothing to be wrong")
    yield from press("OK")
    yield from until(lambda: not Gui.Control.activeDialog(), "the panel to close")
    assert first.TranslationZ.Value == 15.0 and model.failure_of(assembly()) == ""
    clear_report_view()  # what FreeCAD says about the recompute that failed


def add_a_piece(document) -> None:
    """The sheet once more, 40 mm above, in one mesh with it."""
    source = document.getObject("sheet")
    both, above = source.Mesh.copy(), source.Mesh.copy()
    above.translate(0, 0, 40)
    both.addMesh(above)
    source.Mesh = both


def test_a_piece_that_nothing_holds_is_shown_and_left_at_rest():
    yield from new_morph(add_a_piece)
    assert model.failure_of(assembly()) == "", "it stays at rest"
    api.set_unheld(assembly(), "refuse")
    App.ActiveDocument.recompute()
    yield from settled()  # until FreeCAD has said it
    clear_report_view()  # what FreeCAD says about a recompute that failed
    look()
    yield from open_panel()
    yield from until(lambda: "nothing constrains" in sentence(), "the sentence")
    assert child("mend_fault").text() == "Leave at rest"
    yield from click_widget(child("show_fault"))
    picture("fault-loose")
    yield from click_widget(child("mend_fault"))
    yield from until(lambda: not sentence(), "nothing to be wrong")
    yield from enter(child("translation_z"), "9")
    yield from press("OK")
    assert len(regions("fixed")) == 2 and model.failure_of(assembly()) == ""


def test_a_region_that_cannot_be_is_refused_in_its_panel():
    yield from new_assembly(is_joined=True)
    before = model.regions(assembly())
    Gui.Selection.clearSelection()
    Gui.Selection.addSelection(part())
    yield from press_tool("Mark Form Features…")
    yield from click_widget(child("whole"))
    yield from click_point((60.5, 12.0, 0))
    with patience():
        yield from press("OK")
        yield from until(lambda: "touches both" in sentence(), "the sentence")
    assert panel().objectName() == "region" and child("show_fault").isVisible()
    assert "Traceback" not in report_view(), report_view()
    picture("fault-refused")
    assert model.regions(assembly()) == before and model.failure_of(assembly()) == ""
    assert App.ActiveDocument.UndoNames == []
    yield from press("Cancel")
    clear_report_view()


def test_a_pick_leaves_out_what_another_handle_has_and_says_so():
    yield from new_morph()
    (handle,) = regions("handle")
    Gui.Selection.addSelection(part())
    yield from press_tool("Mark Handle…")
    yield from click_widget(child("whole"))
    yield from click_point((60.5, 12.0, 0))
    yield from until(lambda: handle.Label in sentence(), "whose they are")
    assert regions("fixed")[0].Label in sentence()
    picture("fault-left-out")
    yield from press("OK")
    assert len(regions("handle")) == 2 and model.failure_of(assembly()) == ""


def test_a_recipe_keeps_the_meshes_that_it_reads():
    """Parts exported into its folder would be deformed twice by who imports it."""
    yield from new_morph()
    regions("handle")[0].TranslationZ = 12.0
    App.ActiveDocument.recompute()
    moved, folder = stored(), Path(WORK, "recipe_and_parts")
    folder.mkdir()
    yield from menu("SheetMorph", "Export Recipe…")
    yield from answer(str(folder / "recipe.json"))
    yield from until((folder / "recipe.json").is_file, "the recipe")
    kept = {path.name: path.read_bytes() for path in folder.iterdir()}
    asked = []

    def overwrite(box) -> None:
        yes = box.button(QtGui.QMessageBox.Yes)
        asked.append(box.text())
        box.accept() if yes is None else yes.click()

    with answered(overwrite):
        yield from menu("SheetMorph", "Export Parts…")
        yield from answer(str(folder))
        yield from until(lambda: "reads this file" in report_view(), "the refusal")
    assert "did not write their current content" in asked[0], asked
    assert 'the recipe "recipe.json" next to it reads this file' in report_view()
    assert {path.name: path.read_bytes() for path in folder.iterdir()} == kept
    yield from menu("File", "Std_New")
    yield from menu("SheetMorph", "Import Recipe…")
    yield from answer(str(folder / "recipe.json"))
    yield from until(lambda: App.ActiveDocument.Objects, "the morph")
    yield from settled()
    assert np.abs(stored() - moved).max() < 1e-4

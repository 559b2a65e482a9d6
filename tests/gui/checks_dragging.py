# SPDX-License-Identifier: LGPL-2.1-or-later
"""Handles and points are dragged with the real mouse; the last event wins, Escape takes back."""

import contextlib
import gc
import random
import subprocess
import threading

import FreeCAD as App
import FreeCADGui as Gui
import numpy as np
import settling
from checks_moving import lifted, open_panel
from desk import POLL, child, click_widget, enter, on_screen, picture, press, settled, tick, until
from desk import view, xdotool
from freecad.sheetmorph import api, generations, preferences
from freecad.sheetmorph.bridge import live_session
from freecad.sheetmorph.interaction.handle_drag import HandleDrag
from freecad.sheetmorph.objects import model
from freecad.sheetmorph.scene.handle_marks import HandleMarks
from freecad.sheetmorph.tools.updating import AUTOMATIC, ON_OK, ON_PAUSE, WHILE_CHANGING
from pivy import coin
from PySide import QtCore, QtGui
from scenes import assembly, drawn, handle_vertices, largest, new_assembly, new_morph, part
from scenes import regions, stored
from shapes import sheet

__all__ = [
    "test_snapping_drags_in_steps",
    "test_escape_takes_a_drag_back_and_the_panel_stays",
    "test_escape_ends_every_fast_drag",
    "test_escape_ends_a_drag_whoever_has_the_keys",
    "test_every_handle_can_be_clicked_in_the_isometric_view",
    "test_the_pivot_is_moved_and_the_shape_stays",
    "test_a_point_is_dragged_in_the_plane_of_the_view",
    "test_a_point_of_a_handle_drags_the_handle",
    "test_apply_is_an_undo_step_and_cancel_goes_back_to_it",
    "test_a_point_that_was_only_clicked_is_gone_after_apply",
    "test_a_slow_frame_blocks_nothing_and_the_last_event_wins",
    "test_a_preview_that_is_refined_on_release_says_so",
    "test_a_value_is_typed_beside_the_cursor_while_dragging",
    "test_arrows_are_as_large_on_the_screen_in_every_view",
    "test_a_view_that_has_lost_its_camera_is_let_be",
    "test_the_panel_says_which_parts_will_not_follow",
]


def handle_place() -> np.ndarray:
    """Where the middle of the handle is at rest."""
    return np.mean(sheet()[0][handle_vertices()], axis=0)


def grab_up_arrow(shift=(0.0, 0.0, 0.0)):
    """Presses the mouse on the arrow that points up, of a handle that was shifted, (3,) mm.

    Returns where that is on the screen.
    """
    x, y = on_screen(handle_place() + shift)
    yield from xdotool("mousemove", x, y - 30)
    yield from xdotool("mousedown", 1)
    return x, y - 30


def drag_up(start, steps: int = 5):
    """Drags so many steps of 8 px up from a place on the screen."""
    x, y = start
    for step in range(1, steps + 1):
        yield from xdotool("mousemove", x, y - 8 * step)


@contextlib.contextmanager
def preferring(**entries):
    """These preferences for a while."""
    before = {entry: preferences.get(entry) for entry in entries}
    for entry, value in entries.items():
        preferences.put(entry, value)
    yield
    for entry, value in before.items():
        preferences.put(entry, value)


def test_snapping_drags_in_steps():
    with preferring(Snap=True, SnapLength=2.0):
        yield from new_morph()
        yield from open_panel()
        assert child("snap").isChecked()
        start = yield from grab_up_arrow()
        yield from drag_up(start)
        yield from xdotool("mouseup", 1)
        yield from press("OK")
    height = regions("handle")[0].TranslationZ.Value
    assert height >= 4.0 and height % 2.0 == 0.0, height


def test_escape_takes_a_drag_back_and_the_panel_stays():
    yield from new_morph()
    rest = stored()
    yield from open_panel()
    yield from enter(child("translation_x"), "3")
    start = yield from grab_up_arrow((3.0, 0.0, 0.0))
    yield from drag_up(start)
    yield from until(lambda: lifted(rest, drawn())[0, 2] > 3, "the drag")
    yield from xdotool("key", "Escape")
    yield from drag_up((start[0], start[1] - 40), 2)
    yield from xdotool("mouseup", 1)
    yield from settled()
    assert Gui.Control.activeDialog()
    assert child("translation_z").value() == 0.0
    assert np.allclose(lifted(rest, drawn()), (3, 0, 0), atol=1e-4)
    start = yield from grab_up_arrow((3.0, 0.0, 0.0))
    yield from drag_up(start)
    yield from xdotool("mouseup", 1)
    yield from settled()
    assert child("translation_z").value() > 3.0
    yield from press("Cancel")
    assert np.array_equal(stored(), rest)


def test_escape_ends_every_fast_drag():
    """All in one go, faster than frames and recomputes; Escape comes anywhere on the way.

    A press that takes no arrow begins no drag: then Escape closes the panel, as it should.
    """
    yield from new_morph()
    rest, draw, missed = stored(), random.Random(37), 0
    for preference, drags in ((AUTOMATIC, 16), (WHILE_CHANGING, 32)):
        with preferring(UpdateResults=preference), counted_grabs() as grabs:
            yield from open_panel()
            for drag in range(drags):
                grabs.clear()
                yield from drag_with_escape(draw)
                told = f"drag {drag} of preference {preference}: "
                if not grabs and not Gui.Control.activeDialog():
                    missed += 1
                    yield from open_panel()
                assert Gui.Control.activeDialog(), told + "Escape closed the panel"
                assert child("translation_z").value() == 0.0, told + "Escape was lost"
                assert np.allclose(lifted(rest, drawn()), 0.0, atol=1e-4), told + "still drawn"
            yield from press("Cancel")
    assert missed <= 4, missed


@contextlib.contextmanager
def counted_grabs():
    """A list that has an entry for each drag that began."""
    grabs, on_grab = [], HandleDrag.on_grab

    def counted(drag):
        grabs.append(drag)
        on_grab(drag)

    HandleDrag.on_grab = counted
    try:
        yield grabs
    finally:
        HandleDrag.on_grab = on_grab


def test_escape_ends_a_drag_whoever_has_the_keys():
    """A field of the panel, the tree, or FreeCAD's window while it recomputes."""
    yield from new_morph()
    rest = stored()
    yield from open_panel()
    for widget in (child("translation_x"), child("handle"), Gui.getMainWindow()):
        start = yield from grab_up_arrow()
        yield from drag_up(start)
        yield from until(lambda: child("translation_z").value() > 1.0, "the drag")
        widget.setFocus()
        yield from xdotool("key", "Escape")
        yield from until(lambda: child("translation_z").value() == 0.0, "Escape to arrive")
        yield from xdotool("mouseup", 1)
        yield from settled()
        assert Gui.Control.activeDialog()
        assert np.allclose(lifted(rest, drawn()), 0.0, atol=1e-4)
    yield from press("Cancel")


def drag_with_escape(draw):
    """Up the arrow in one go; a field has the keys before."""
    x, y = on_screen(handle_place())
    child("translation_x").setFocus()
    yield from xdotool("mousemove", x, y - 28)
    yield from xdotool("mousemove", x, y - 30)
    words, at = ["mousedown", 1], draw.randint(1, 8)
    for step in range(1, 10):
        words += ["mousemove", x, y - 30 - 5 * step]
        words += ["sleep", draw.choice((0.0, 0.002, 0.01, 0.05))]
        if step == at:
            words += ["key", "Escape"]
    yield from all_at_once(*words, "mouseup", 1)
    yield from settled()


def all_at_once(*words):
    """As a quick hand: nobody waits for anything to arrive."""
    process = subprocess.Popen(["xdotool", *map(str, words)])
    yield from until(lambda: process.poll() is not None, "xdotool to end")
    for _ in range(9):
        settling.receive()
        yield POLL


def test_every_handle_can_be_clicked_in_the_isometric_view():
    """Some lie behind each other there: pivots on one line of sight."""
    yield from new_morph()
    sight = np.array(tuple(view().getViewDirection()))
    free = np.setdiff1d(np.arange(len(sheet()[0])), handle_vertices())
    points = sheet()[0]
    inner = free[(np.abs(points[free, 0] - 60.0) < 50.0)]
    along = points[inner] - np.outer(points[inner] @ sight, sight)
    order = np.lexsort(np.round(along / 6.0).T)
    chosen = [int(inner[k]) for k in order[:: max(1, len(order) // 9)]][:8]
    behind = [int(v) for v in inner[np.argsort(np.linalg.norm(along - along[0], axis=1))[:4]]]
    for number, vertex in enumerate(dict.fromkeys(chosen + behind)):
        api.add_handle(assembly(), part(), [vertex], f"H{number}")
    App.ActiveDocument.recompute()
    labels = [handle.Label for handle in regions("handle")]
    yield from open_panel()
    picture("handles-isometric")
    for label in labels[::-1]:
        others = [one for one in labels if one != child("handle").currentText()]
        if label not in others:
            continue
        yield from click_mark(others.index(label))
        yield from until(lambda t=label: child("handle").currentText() == t, f"{label} chosen")
    assert App.ActiveDocument.UndoNames == ["Move Handle"] or not App.ActiveDocument.UndoNames
    yield from press("Cancel")


def click_mark(number: int):
    """Clicks the mark of one of the handles that do not have the arrows."""
    (marks,) = [one for one in gc.get_objects() if isinstance(one, HandleMarks) and one._view]
    x, y = marks.place_of(number)
    widget = view().graphicsView().viewport()
    ratio = widget.devicePixelRatioF()
    place = widget.mapToGlobal(
        QtCore.QPoint(round(x / ratio), round(widget.height() - 1 - y / ratio))
    )
    yield from xdotool("mousemove", place.x(), place.y(), "click", 1)
    yield from settled()


def test_the_pivot_is_moved_and_the_shape_stays():
    yield from new_morph()
    yield from open_panel()
    yield from enter(child("angle"), "20")
    yield from settled()
    before = drawn()
    yield from click_widget(child("move_pivot"))
    start = yield from grab_up_arrow()
    yield from drag_up(start)
    yield from xdotool("mouseup", 1)
    yield from settled()
    yield from click_widget(child("move_pivot"))
    assert child("pivot_z").value() > handle_place()[2] + 3.0
    assert largest(drawn() - before) < 1e-3
    picture("pivot")
    yield from press("OK")
    assert not regions("handle")[0].PivotAtCentroid


def test_a_point_is_dragged_in_the_plane_of_the_view():
    yield from new_morph()
    rest = stored()
    yield from open_panel()
    yield from tick(child("points"))
    x, y = on_screen((60.0, 0.0, 0.0))
    yield from xdotool("mousemove", x, y - 3)
    yield from xdotool("mousedown", 1)
    yield from drag_up((x, y), 6)
    picture("point")
    sight = np.array(tuple(Gui.activeDocument().activeView().getViewDirection()))
    yield from until(lambda: largest(drawn() - rest) > 5, "the point")
    yield from xdotool("mouseup", 1)
    yield from settled()
    shown = regions("handle")[1]
    assert shown.Label == "Point on sheet morphed"
    yield from press("OK")
    point = regions("handle")[1]
    assert point == shown, "OK keeps what is shown and makes nothing anew"
    assert point.FreeRotation and len(point.Vertices) == 1
    shift = np.array([point.TranslationX.Value, point.TranslationY.Value, point.TranslationZ.Value])
    assert np.linalg.norm(shift) > 5 and abs(shift @ sight) < 1e-3, shift
    vertex = int(point.Vertices[0])
    assert np.allclose((stored() - rest)[vertex], shift, atol=1e-4)
    assert np.array_equal(stored()[handle_vertices()], rest[handle_vertices()])
    assert App.ActiveDocument.UndoNames == ["Move Handle"]
    App.ActiveDocument.undo()
    assert np.array_equal(stored(), rest) and len(regions("handle")) == 1


def test_a_point_of_a_handle_drags_the_handle():
    yield from new_morph()
    rest = stored()
    yield from open_panel()
    yield from tick(child("arrows"))
    yield from tick(child("points"))
    x, y = on_screen((120.0, 10.0, 15.0))
    yield from xdotool("mousemove", x, y)
    yield from xdotool("mousedown", 1)
    yield from drag_up((x, y))
    yield from xdotool("mouseup", 1)
    yield from settled()
    moved = lifted(rest, drawn())
    assert moved[0, 2] > 2 and np.allclose(moved, moved[0], atol=1e-4)
    yield from tick(child("arrows"))
    yield from press("OK")
    assert len(regions("handle")) == 1


def test_apply_is_an_undo_step_and_cancel_goes_back_to_it():
    yield from new_morph()
    yield from open_panel()
    yield from enter(child("translation_z"), "7")
    yield from press("Apply")
    assert App.ActiveDocument.UndoNames == ["Move Handle"]
    applied = stored()
    yield from enter(child("translation_z"), "12")
    yield from settled()
    yield from press("Cancel")
    assert np.array_equal(stored(), applied)
    assert regions("handle")[0].TranslationZ.Value == 7.0
    App.ActiveDocument.undo()
    assert regions("handle")[0].TranslationZ.Value == 0.0


def test_a_point_that_was_only_clicked_is_gone_after_apply():
    yield from new_morph()
    yield from open_panel()
    yield from tick(child("points"))
    x, y = on_screen((60.0, 0.0, 0.0))
    yield from xdotool("mousemove", x, y - 3, "mousedown", 1, "mouseup", 1)
    yield from until(lambda: len(regions("handle")) == 2, "the point")
    yield from press("Apply")
    assert child("handle").count() == 1 and len(regions("handle")) == 1
    yield from enter(child("translation_z"), "5")
    yield from press("OK")
    assert regions("handle")[0].TranslationZ.Value == 5.0


def test_a_slow_frame_blocks_nothing_and_the_last_event_wins():
    yield from new_morph()
    rest = stored()
    answered, quick, may_go_on = [], live_session.LiveSession.answer, threading.Event()

    def slow(self, question, goes_on=None):
        answered.append(question)
        assert may_go_on.wait(60.0), "the window was blocked"
        return quick(self, question, goes_on)

    live_session.LiveSession.answer = slow
    try:
        yield from open_panel()
        for height in range(1, 21):
            child("translation_z").setValue(float(height))
            yield POLL
        assert len(answered) == 1 and largest(drawn() - rest) == 0.0
        may_go_on.set()
        yield from until(lambda: lifted(rest, drawn())[0, 2] > 19.9, "the last value")
        assert len(answered) < 5, len(answered)
        yield from press("Cancel")
    finally:
        may_go_on.set()
        live_session.LiveSession.answer = quick
    assert np.array_equal(stored(), rest)


def test_a_preview_that_is_refined_on_release_says_so():
    yield from new_morph()
    model.assembly_of(regions("handle")[0]).Refine = True
    App.ActiveDocument.recompute()
    with preferring(UpdateResults=ON_OK):
        yield from open_panel()
        yield from enter(child("translation_z"), "20")
        yield from until(lambda: "Preview" in child("status").text(), "the word for a preview")
        assert "refined on release" in child("status").text(), child("status").text()
        yield from press("Cancel")
    with preferring(UpdateResults=ON_PAUSE):
        yield from open_panel()
        yield from enter(child("translation_z"), "20")
        yield from until(lambda: "Computed" in child("status").text(), "a frame")
        yield from until(lambda: "Preview" not in child("status").text(), "the exact shape")
        yield from press("Cancel")


def beside_cursor() -> str:
    """What stands beside the cursor; empty if nothing does."""
    viewport = view().graphicsView().viewport()
    label = viewport.findChild(QtGui.QLabel, "SheetMorphCursorValue")
    return label.text() if label.isVisible() else ""


def test_a_value_is_typed_beside_the_cursor_while_dragging():
    yield from new_morph()
    rest = stored()
    yield from open_panel()
    start = yield from grab_up_arrow()
    yield from drag_up(start)
    yield from until(lambda: beside_cursor().endswith(" mm"), "how far it is")
    shown = float(beside_cursor().split()[0])
    assert abs(shown - child("translation_z").value()) < 0.01 * shown
    picture("cursor-value")
    yield from xdotool("type", "--delay", 30, "12.5")
    yield from until(lambda: beside_cursor().startswith("12.5"), "what is typed")
    picture("cursor-typed")
    yield from xdotool("key", "Return")
    yield from xdotool("mouseup", 1)
    assert child("translation_z").value() == 12.5 and beside_cursor() == ""
    yield from until(lambda: np.allclose(lifted(rest, drawn())[:, 2], 12.5, atol=1e-3), "lift")
    start = yield from grab_up_arrow((0.0, 0.0, 12.5))
    yield from drag_up(start)
    yield from xdotool("type", "--delay", 30, "1 cm")
    yield from xdotool("mouseup", 1)
    yield from until(lambda: child("translation_z").value() == 22.5, "with a unit")
    yield from press("Cancel")


def arrows_px() -> float:
    """What the arrows take for one, on the screen."""
    search = coin.SoSearchAction()
    kinds = [coin.SoType.fromName(name) for name in generations.DRAGGERS]
    search.setType(next(kind for kind in kinds if not kind.isBad()))
    search.apply(view().getSceneGraph())
    size = search.getPath().getTail().getField("draggerSize").getValue()
    mm_per_px = view().getCameraNode().height.getValue() / view().getSize()[1]
    return size / mm_per_px


def test_arrows_are_as_large_on_the_screen_in_every_view():
    yield from new_morph()
    frame = Gui.getMainWindow().findChild(QtGui.QMdiArea).subWindowList()[0]
    yield from open_panel()
    before = arrows_px()
    frame.showNormal()
    frame.resize(700, 320)
    yield from until(lambda: view().getSize()[1] < 320, "a small view")
    yield from until(lambda: abs(arrows_px() - before) < 0.01 * before, "arrows of the same size")
    Gui.SendMsgToActiveView("ViewFit")
    yield from until(lambda: abs(arrows_px() - before) < 0.01 * before, "the same at this zoom")
    picture("arrows-small-view")
    frame.showMaximized()
    yield from settled()
    yield from press("Cancel")


def test_a_view_that_has_lost_its_camera_is_let_be():
    """As a view is that closes: FreeCAD itself dies of the question for the camera then."""
    yield from new_morph()
    yield from open_panel()
    before = arrows_px()
    renderer = generations.viewer_of(view()).getSoRenderManager()
    camera = renderer.getCamera()
    renderer.setCamera(None)
    camera.touch()
    coin.SoDB.getSensorManager().processDelayQueue(False)
    renderer.setCamera(camera)
    Gui.SendMsgToActiveView("ViewFit")
    yield from until(lambda: abs(arrows_px() - before) < 0.01 * before, "arrows of the same size")
    yield from press("Cancel")
    assert not Gui.Control.activeDialog()


def test_the_panel_says_which_parts_will_not_follow():
    yield from new_assembly(is_joined=True)
    Gui.Selection.clearSelection()
    Gui.Selection.addSelection(regions("handle")[0])
    yield from open_panel()
    assert child("staying").isVisible() and "loose" in child("staying").text()
    assert "bracket" not in child("staying").text()
    picture("will-not-follow")
    yield from press("Cancel")

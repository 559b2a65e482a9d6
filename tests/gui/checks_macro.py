# SPDX-License-Identifier: LGPL-2.1-or-later
"""What a user does is recorded as lines of the API; replayed without a window it does the same."""

import os
import re
import subprocess

import FreeCAD as App
import FreeCADGui as Gui
import numpy as np
from checks_drawing import ring, start
from checks_picking import start_morph, view_from
from desk import Recorder, WORK, child, choose_below, click_point, draw_along, enter, press
from desk import press_tool, settled, until, xdotool
from PySide import QtGui
from scenes import add_bracket, assembly, labelled, largest, look, new_document, stored
from scenes import stored_of_all
from shapes import HOLES

__all__ = [
    "test_a_recorded_macro_replays_headless_to_the_bit",
    "test_figures_drawn_on_the_screen_replay_headless_to_the_bit",
    "test_a_recorded_contact_replays_headless_to_the_bit",
]

HERE = os.path.dirname(os.path.abspath(__file__))
CALLS = ["create_assembly", "propose_thin", "add_fixed", "add_handle", "add_feature", "add_feature"]


def start_recording(name: str):
    """Macro > Macro recording…, a name, Record: as a user does it."""
    earlier = os.path.join(WORK, f"{name}.FCMacro")
    if os.path.exists(earlier):  # of a first try; FreeCAD would ask
        os.remove(earlier)
    App.ParamGet("User parameter:BaseApp/Preferences/Macro").SetString("MacroPath", WORK)
    Recorder.start()
    yield from until(QtGui.QApplication.activeModalWidget, "the dialog")
    yield from settled()
    dialog = QtGui.QApplication.activeModalWidget()
    field = dialog.findChild(QtGui.QLineEdit, "lineEditPath")
    field.setFocus()
    yield from xdotool("key", "ctrl+a")
    yield from xdotool("type", "--delay", 15, name)
    dialog.findChild(QtGui.QPushButton, "buttonStart").click()
    yield from settled()


def stop_recording(name: str):
    """Stops; then the macro ``name`` is there."""
    Recorder.stop()
    yield from until(lambda: os.path.exists(macro_path(name)), "the macro")


def macro_path(name: str) -> str:
    """Where a recorded macro is."""
    return os.path.join(WORK, f"{name}.FCMacro")


def calls_in(name: str) -> list[str]:
    """The functions of the API that a macro calls, in order."""
    with open(macro_path(name), encoding="utf-8") as file:
        return re.findall(r"^(?:\w+ = )?api\.(\w+)\(", file.read(), re.MULTILINE)


def replay(name: str):
    """Runs a macro without a window; the positions of all parts are those of this document."""
    yield from Replay(name).finish()


class Replay:
    """Runs a macro without a window, beside what else happens; expects what is stored now."""

    def __init__(self, name: str):
        self._replayed = os.path.join(WORK, f"{name}.npy")
        wanted = {"SHEETMORPH_MACRO": macro_path(name), "SHEETMORPH_REPLAYED": self._replayed}
        self._expected = stored_of_all()
        self._process = subprocess.Popen(
            ["freecadcmd", os.path.join(HERE, "replay.py")],
            env={**os.environ, **wanted},
            stdin=subprocess.DEVNULL,
            stdout=subprocess.DEVNULL,
        )

    def finish(self):
        """Waits for the end; the positions of all parts are the same to the bit."""
        yield from until(lambda: self._process.poll() is not None, "the replay")
        assert self._process.returncode == 0
        assert np.array_equal(np.load(self._replayed), self._expected)


def do_a_morph():
    """Picks all regions with the mouse and moves the handle."""
    yield from start_morph()
    for x, command in ((0.0, "Mark Fixed Region…"), (120.0, "Mark Handle…")):
        view_from(x)
        yield from press_tool(command)
        yield from click_point((x, 30, 10))
        yield from press("OK")
    Gui.activeDocument().activeView().viewTop()
    Gui.SendMsgToActiveView("ViewFit")
    yield from press_tool("Mark Form Features…")
    for (x, y, radius), key in zip(HOLES, ("", "shift")):
        yield from click_point((x, y + radius + 1.5, 0), key)
    yield from press("OK")
    yield from press_tool("Move Handle…")
    yield from settled()
    yield from enter(child("translation_z"), "17.3")
    yield from enter(child("angle"), "-12")
    yield from settled()
    yield from press("OK")


def test_a_recorded_macro_replays_headless_to_the_bit():
    yield from start_recording("recorded")
    yield from new_document()
    yield from do_a_morph()
    yield from stop_recording("recorded")
    assert calls_in("recorded") == [*CALLS, "set_motion"], calls_in("recorded")
    yield from replay("recorded")


def test_figures_drawn_on_the_screen_replay_headless_to_the_bit():
    yield from start_recording("drawn")
    yield from new_document()
    yield from start_morph()
    yield from start("Mark Fixed Region…", "rectangle")
    yield from draw_along([(-3, -3, 0), (6, 63, 0)])
    yield from press("OK")
    yield from start("Mark Form Features…", "lasso")
    yield from draw_along(ring(*HOLES[0][:2], HOLES[0][2] + 5))
    yield from press("OK")
    yield from start("Mark Handle…", "brush")
    yield from draw_along([(112, 8, 0), (112, 52, 0)])
    yield from press("OK")
    yield from press_tool("Move Handle…")
    yield from settled()
    yield from enter(child("translation_z"), "11.9")
    yield from settled()
    yield from press("OK")
    yield from stop_recording("drawn")
    wanted = ["add_fixed", "add_feature", "add_handle", "set_motion"]
    assert calls_in("drawn")[-4:] == wanted, calls_in("drawn")
    yield from replay("drawn")


def test_a_recorded_contact_replays_headless_to_the_bit():
    yield from start_recording("joined")
    yield from new_document()
    yield from add_bracket()
    yield from start_morph(["sheet", "bracket"])
    view_from(0.0)
    yield from press_tool("Mark Fixed Region…")
    yield from click_point((0, 30, 10))
    yield from press("OK")
    look()
    yield from press_tool("Mark Contact…")
    yield from click_point((20.5, 12.0, 0))
    yield from click_point((59.0, 95.0, 1))
    yield from choose_below(child("type"), 1)
    yield from press("OK")
    view_from(120.0)
    yield from press_tool("Mark Handle…")
    yield from click_point((120, 30, 10))
    yield from press("OK")
    yield from press_tool("Move Handle…")
    yield from enter(child("translation_z"), "13.7")
    yield from enter(child("angle"), "7")
    yield from settled()
    yield from press("OK")
    yield from stop_recording("joined")
    assert calls_in("joined").count("add_contact") == 1
    assert assembly().Unreached == [] and largest(stored(labelled("bracket"))) > 100
    yield from replay("joined")

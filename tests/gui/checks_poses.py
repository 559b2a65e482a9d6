# SPDX-License-Identifier: LGPL-2.1-or-later
"""Poses are saved by name, blended with the slider, taken out as meshes."""

import FreeCAD as App
import FreeCADGui as Gui
import numpy as np
from checks_moving import lifted
from desk import child, click_widget, enter, picture, press, press_tool, settled, until, xdotool
from freecad.sheetmorph import api
from PySide import QtCore, QtGui
from scenes import assembly, drawn, new_morph, regions, stored

__all__ = ["test_two_poses_are_saved_blended_and_copied"]


def save_pose(text: str):
    """Save Pose…, a name, Return."""
    QtCore.QTimer.singleShot(0, lambda: Gui.runCommand("SheetMorph_SavePose"))
    yield from until(QtGui.QApplication.activeModalWidget, "the dialog")
    yield from settled()
    yield from xdotool("key", "ctrl+a")
    yield from xdotool("type", "--delay", 15, text)
    yield from xdotool("key", "Return")
    yield from settled()


def test_two_poses_are_saved_blended_and_copied():
    yield from new_morph()
    rest, handle = stored(), regions("handle")[0]
    api.set_motion(handle, (0, 0, 30))
    yield from save_pose("High")
    api.set_motion(handle, (0, 0, 0), (1, 0, 0), 40)
    App.ActiveDocument.recompute()
    yield from save_pose("Turned")
    assert [pose.Label for pose in api.poses(assembly())] == ["High", "Turned"]
    Gui.Selection.clearSelection()
    Gui.Selection.addSelection(api.poses(assembly())[0])
    yield from press_tool("Blend Poses…")
    yield from until(lambda: np.allclose(lifted(rest, drawn()), (0, 0, 30), atol=1e-3), "High")
    assert "30, " in child("apart").text()
    yield from enter(child("percent"), "50")
    yield from until(lambda: np.allclose(lifted(rest, drawn()), (0, 0, 15), atol=1e-3), "half")
    picture("blending")
    yield from click_widget(child("slider"))
    yield from press("OK")
    assert 10.0 < handle.TranslationZ.Value < 20.0 and handle.Angle.Value == 0.0
    assert np.array_equal(stored(), drawn())
    Gui.Selection.clearSelection()
    Gui.Selection.addSelection(api.poses(assembly())[1])
    yield from press_tool("Copy as Meshes")
    (copy,) = App.ActiveDocument.getObjectsByLabel("Morph Turned")[0].Group
    assert copy.TypeId == "Mesh::Feature" and copy.Mesh.CountPoints == len(rest)
    turned = api.poses(assembly())[1]
    assert turned.ViewObject.Proxy.doubleClicked(turned.ViewObject)
    assert handle.Angle.Value == 40.0
    names = ["Apply Pose", "Copy as Meshes", "Blend Poses", "Save Pose", "Save Pose"]
    assert App.ActiveDocument.UndoNames == names

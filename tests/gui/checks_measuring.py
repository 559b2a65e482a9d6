# SPDX-License-Identifier: LGPL-2.1-or-later
"""A distance is measured on the deformed shape, and FreeCAD's section planes cut it."""

import FreeCAD as App
import FreeCADGui as Gui
import numpy as np
from checks_dragging import drag_up, grab_up_arrow
from checks_moving import open_panel
from checks_share import slide
from checks_showing import found
from desk import child, click_point, click_widget, colour_at, enter, laid_out, picture, press
from desk import settled, tick, until, view, xdotool
from freecad.sheetmorph.scene import distance_mark
from pivy import coin
from PySide import QtCore, QtGui
from scenes import drawn, new_morph, regions, stored

__all__ = [
    "test_a_distance_follows_the_motion_and_the_slider",
    "test_escape_ends_the_measurement_and_points_take_the_mouse",
    "test_the_section_planes_of_freecad_cut_the_moved_shape",
]

LEFT, RIGHT = (0.0, 60.0, 20.0), (120.0, 60.0, 20.0)


def measured() -> list[str]:
    """What stands at the measured line in the view."""
    marks = [n for n in found(coin.SoAnnotation, view().getSceneGraph())]
    marks = [n for n in marks if n.getName() == distance_mark.NAME]
    texts = [n.string.getValues()[0] for mark in marks for n in found(coin.SoText2, mark)]
    return [text.strip() for text in texts if text.strip()]


def measure_ends():
    yield from click_widget(child("measure"))
    yield from click_point(LEFT)
    yield from until(lambda: "second" in child("distance").text(), "the first point")
    yield from click_point(RIGHT)
    yield from until(measured, "the distance")


def test_a_distance_follows_the_motion_and_the_slider():
    yield from new_morph()
    rest = stored()
    yield from open_panel()
    yield from measure_ends()
    said = child("distance").text()
    assert said == "Distance 120.00 mm; at rest 120.00 mm; change 0.00 mm", said
    yield from enter(child("translation_x"), "10")
    yield from settled()
    said = child("distance").text()
    assert said == "Distance 130.00 mm; at rest 120.00 mm; change +10.00 mm", said
    assert measured() == ["130.00 mm (+10.00 mm)"]
    picture("measure")
    yield from slide(0.5)
    share = child("share").value() / 100.0
    assert measured() == [f"{120 + 10 * share:.2f} mm (+{10 * share:.2f} mm)"], measured()
    start = yield from grab_up_arrow((10.0, 0.0, 0.0))
    yield from drag_up(start)
    yield from settled()
    height = child("translation_z").value()
    wanted = np.hypot(130.0, height)
    yield from until(lambda: measured()[0].startswith(f"{wanted:.2f}"), "the drag in the distance")
    yield from xdotool("mouseup", 1)
    yield from settled()
    panel_undo = App.ActiveDocument.UndoNames
    assert panel_undo in ([], ["Move Handle"]), panel_undo
    yield from press("Cancel")
    assert measured() == [] and np.array_equal(stored(), rest)


def test_escape_ends_the_measurement_and_points_take_the_mouse():
    yield from new_morph()
    yield from open_panel()
    yield from measure_ends()
    view().graphicsView().setFocus()
    yield from xdotool("key", "Escape")
    yield from until(lambda: not child("measure").isChecked(), "the end of the measurement")
    assert Gui.Control.activeDialog() and measured() == []
    assert not child("distance").isVisible()
    yield from measure_ends()
    yield from tick(child("points"))
    assert not child("measure").isChecked() and measured() == []
    yield from click_widget(child("measure"))
    assert not child("points").isChecked()
    yield from click_point((60.0, 0.0, 0.0))
    yield from settled()
    assert len(regions("handle")) == 1, "a click that measures makes no handle"
    yield from press("OK")
    assert not found(coin.SoAnnotation, view().getSceneGraph()) or measured() == []


def clip_planes() -> list:
    """The section planes of the view that are on."""
    planes = found(coin.SoClipPlane, view().getSceneGraph())
    return [plane for plane in planes if plane.on.getValue()]


def sections() -> list:
    """FreeCAD's visible panels of section planes."""
    docks = Gui.getMainWindow().findChildren(QtGui.QDockWidget)
    return [d for d in docks if d.isVisible() and d.findChild(QtGui.QDoubleSpinBox, "clipY")]


def show_section(field: str, offset: float):
    """Opens the section planes with the button, and switches one on at an offset, mm."""
    yield from click_widget(child("section"))
    yield from until(sections, "FreeCAD's section planes")
    yield from laid_out()
    (dock,) = sections()
    dock.findChild(QtGui.QGroupBox, f"groupBox{field[-1]}").setChecked(True)
    dock.findChild(QtGui.QDoubleSpinBox, field).setValue(offset)
    yield from settled()


def close_sections() -> None:
    """Presses Close, which ends the cut."""
    for dock in sections():
        (box,) = dock.findChildren(QtGui.QDialogButtonBox)
        box.button(QtGui.QDialogButtonBox.Close).click()


def test_the_section_planes_of_freecad_cut_the_moved_shape():
    yield from new_morph()
    rest = stored()
    yield from open_panel()
    yield from enter(child("translation_z"), "10")
    yield from settled()
    near = int(np.linalg.norm(rest - (60.0, 10.0, 0.0), axis=1).argmin())
    place = drawn()[near]
    whole = colour_at(place)
    yield from show_section("clipY", 30.0)
    picture("section")
    (dock,) = sections()
    left = [place.mapToGlobal(QtCore.QPoint(0, 0)).x() for place in (child("section"), dock)]
    assert left[1] > left[0] + 400, "the panel keeps its room"
    assert len(clip_planes()) == 1
    cut = colour_at(place)
    assert max(abs(a - b) for a, b in zip(whole, cut)) > 12, (whole, cut)
    yield from enter(child("translation_z"), "20")
    yield from settled()
    assert Gui.Control.activeDialog() and len(clip_planes()) == 1
    yield from press("Cancel")
    close_sections()
    yield from until(lambda: not sections(), "the section planes to close")
    assert clip_planes() == [] and np.array_equal(stored(), rest)

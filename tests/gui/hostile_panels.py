# SPDX-License-Identifier: LGPL-2.1-or-later
"""All panels: how each is opened and used, and a document with steps to undo for all of them."""

import os
import time

import FreeCAD as App
import FreeCADGui as Gui
from desk import WORK, activate, panel, settled
from freecad.sheetmorph import api
from freecad.sheetmorph.objects import model
from hostile_acts import with_step
from hostile_traces import child_processes
from PySide import QtGui
from scenes import assembly, contacts, labelled, new_assembly, part, regions

STARTS = 1000  # looks whether a process has started, 20 ms apart


def prepared():
    """The assembly joined by a contact, with a second handle and a pose as steps of their own."""
    path = os.path.join(WORK, "hostile.FCStd")
    if os.path.exists(path):
        if Gui.activeWorkbench().name() != "SheetMorphWorkbench":
            yield from activate()  # a fresh FreeCAD has no commands of ours yet
        App.openDocument(path)
        yield from settled()
    else:
        yield from new_assembly(is_joined=True)
        App.ActiveDocument.saveAs(path)
    document = App.ActiveDocument
    with_step("Second Handle", lambda: add_second_handle(document))
    with_step("Pose", lambda: api.save_pose(assembly(), "High"))
    yield from settled()


def add_second_handle(document) -> None:
    bracket = labelled("bracket")
    points = api.rest_mesh(bracket)[0]
    far = [k for k, point in enumerate(points) if point[1] > 108.0]
    handle = api.add_handle(assembly(), bracket, far, "Second")
    api.set_motion(handle, (0.0, 0.0, 3.0))


# -- the panels: how each is opened, and used so far that something is shown or changed


def open_by(command: str, *chosen) -> None:
    Gui.Selection.clearSelection()
    for obj in chosen:
        Gui.Selection.addSelection(obj)
    Gui.runCommand(f"SheetMorph_{command}")


def second_handle():
    return next(r for r in regions("handle") if r.Label == "Second")


def edit(obj) -> None:
    obj.ViewObject.Proxy.doubleClicked(obj.ViewObject)


def set_field(name: str, value: float) -> None:
    panel().findChild(QtGui.QWidget, name).setValue(value)


def set_percent() -> None:
    panel().findChild(QtGui.QWidget, "percent").setValue(50.0)


def press_button(name: str) -> None:
    panel().findChild(QtGui.QAbstractButton, name).click()


def light_row() -> None:
    panel().findChild(QtGui.QTableWidget, "table").cellEntered.emit(0, 0)


def pick_all() -> None:
    press_button("invert")


def preview() -> None:
    """A coarse one: it stands for all, and thirty of them are made."""
    box = panel().findChild(QtGui.QAbstractButton, "remesh")
    box.setChecked(True)
    set_field("edge", 8.0)
    press_button("preview")


def a_study():
    """A study of the second handle that is not done before something is done to it."""
    parameters = [("lift", second_handle(), "TranslationZ", 0.0, 20.0)]
    if not model.studies(assembly()):
        with_step("A Study", lambda: api.add_study(assembly(), parameters=parameters, count=500))
    return model.studies(assembly())[0]


def run_study() -> None:
    """Until its process is there: for a moment it has the name of FreeCAD."""
    press_button("run")
    message = panel().findChild(QtGui.QLabel, "message").text()
    assert panel().findChild(QtGui.QPushButton, "stop").isEnabled(), f"not started: {message}"
    for _ in range(STARTS):
        if child_processes():
            return
        time.sleep(0.02)
    raise AssertionError(f"no process was started: {message}")


def nothing() -> None:
    pass


# What it is about is deleted as "subject".
PANELS = {
    "fixed": (lambda: open_by("MarkFixed", part()), pick_all, part),
    "handle": (
        lambda: open_by("MarkHandle", labelled("loose")),
        pick_all,
        lambda: labelled("loose"),
    ),
    "follower": (lambda: open_by("MarkFollower", part()), pick_all, part),
    "features": (lambda: open_by("MarkFeature", part()), pick_all, part),
    "region": (lambda: edit(regions("fixed")[0]), nothing, lambda: regions("fixed")[0]),
    "contact": (
        lambda: open_by("MarkContact", part(), labelled("loose")),
        nothing,
        lambda: labelled("loose"),
    ),
    "edit_contact": (lambda: edit(contacts()[0]), nothing, lambda: contacts()[0]),
    "feature": (
        lambda: open_by("FeatureSettings", regions("form feature")[0]),
        lambda: panel().findChild(QtGui.QComboBox, "motion").setCurrentIndex(1),
        lambda: regions("form feature")[0],
    ),
    "find_features": (lambda: open_by("FindFeatures"), light_row, part),
    "find_contacts": (lambda: open_by("FindContacts"), light_row, lambda: labelled("bracket")),
    "move": (
        lambda: open_by("MoveHandle", second_handle()),
        lambda: set_field("translation_z", 20.0),
        second_handle,
    ),
    "blend": (
        lambda: open_by("BlendPoses", api.poses(assembly())[0]),
        set_percent,
        lambda: api.poses(assembly())[0],
    ),
    "study": (lambda: open_by("Study", a_study()), run_study, a_study),
    "prepare": (lambda: open_by("PrepareMesh", part()), preview, part),
    "propagation": (
        lambda: open_by("Propagation"),
        lambda: press_button("meshes"),
        lambda: contacts()[0],
    ),
    "loose_pieces": (
        lambda: open_by("Propagation"),
        lambda: panel().findChild(QtGui.QComboBox, "unheld").setCurrentIndex(1),
        lambda: labelled("loose"),
    ),
    "thickness": (lambda: open_by("ThicknessMap", part()), nothing, part),
    "guide": (lambda: open_by("Guide"), nothing, part),
}


def is_shown() -> bool:
    try:
        return bool(panel())
    except AssertionError:
        return False

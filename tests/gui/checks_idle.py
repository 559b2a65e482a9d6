# SPDX-License-Identifier: LGPL-2.1-or-later
"""How long OK, Cancel and Esc of every panel take on an enclosure of 38 parts and on one part of
100,000 vertices, until the event loop is idle; and the memory of the enclosure. It is reported."""

import json
import os
import time

import FreeCAD as App
import FreeCADGui as Gui
import numpy as np
from checks_answering import click, escape, timed
from checks_enclosure import STEP
from desk import activate, buttons_called, child, clear_report_view, laid_out, note, panel, picture
from desk import press, settled, until
from freecad.sheetmorph import api
from freecad.sheetmorph.bridge import conversion
from freecad.sheetmorph.interaction import finishing
from freecad.sheetmorph.objects import model
from hostile_panels import edit, is_shown, open_by
from PySide import QtCore, QtGui
from scenes import assembly, contacts, labelled, regions
from shapes import grid_triangles

__all__ = [
    "test_ok_cancel_and_escape_on_100000_vertices_are_measured",
    "test_ok_cancel_and_escape_on_the_enclosure_are_measured",
]
BOUND = 10.0  # seconds; the solves of these morphs take longer on a loaded machine
MOST_OPEN = 1500  # MB, of the enclosure before a panel: it takes 1,450
PAGE = os.sysconf("SC_PAGE_SIZE") / 2.0**20  # MB


def megabytes() -> int:
    with open("/proc/self/statm", encoding="utf-8") as file:
        return round(int(file.read().split()[1]) * PAGE)


def grid_part(side: int):
    """A curved part of side x side vertices: one end fixed, the other a handle, a patch between
    them a form feature."""
    yield from activate()
    x, y = np.meshgrid(np.arange(side), np.arange(side), indexing="ij")
    points = np.stack([x.ravel(), y.ravel(), 4.0 * np.sin(x.ravel() / 15.0)], axis=1)
    document = App.newDocument("Large")
    source = document.addObject("Mesh::Feature", "Sheet")
    source.Mesh = conversion.MeshWriter(grid_triangles(side, side).astype(np.int32)).mesh(points)
    morph = api.create_assembly(document)
    api.add_part(morph, source)
    yield from ends_and_features(points[:, 0], side - 17.0, 16.0)


def enclosure():
    """The enclosure with its holes and contacts."""
    yield from activate()
    document = App.newDocument("Enclosure")
    morph = api.create_assembly(document)
    api.import_cad(morph, STEP)
    document.recompute()
    holes = [one for one in api.find_features(morph) if one.kind.endswith("hole")]
    api.add_found_features(morph, holes)
    api.add_found_contacts(morph, api.find_contacts(morph))
    api.set_primary(morph, labelled("MainEnclosure.MainSheet"))
    yield from ends_and_features(api.rest_mesh(morph.Primary)[0][:, 0], 400.0, 10.0)


def ends_and_features(x, fixed: float, moved: float):
    """The ends of the primary part as regions, a pose; recomputed once and nothing to undo."""
    morph = assembly()
    sheet = morph.Primary or model.parts(morph)[0]
    api.add_fixed(morph, sheet, np.flatnonzero(x > fixed).tolist())
    api.add_handle(morph, sheet, np.flatnonzero(x < moved).tolist())
    if not regions("form feature"):
        middle = np.flatnonzero((x > 100.0) & (x < 103.0))[40:60]
        api.add_feature(morph, sheet, middle.tolist())
    App.ActiveDocument.recompute()
    regions("handle")[0].TranslationZ = 5.0
    App.ActiveDocument.recompute()
    api.save_pose(morph, "High")
    App.ActiveDocument.recompute()
    App.ActiveDocument.clearUndos()
    Gui.SendMsgToActiveView("ViewFit")
    yield from settled()


def field(name: str, value: float):
    return lambda: panel().findChild(QtGui.QWidget, name).setValue(value)


def button(text: str):
    return lambda: buttons_called(text)[0].click()


def type_band() -> None:
    """Picks a band beside the fixed region by a selector."""
    region, far = regions("fixed")[0], 1e4
    x = api.rest_mesh(region.Part)[0][model.vertices(region), 0].min()
    where = child("where")
    where.setText(json.dumps({"box": [[x - 30.0, -far, -far], [x - 15.0, far, far]]}))
    key = QtGui.QKeyEvent(QtCore.QEvent.KeyPress, QtCore.Qt.Key_Return, QtCore.Qt.NoModifier)
    QtGui.QApplication.sendEvent(where, key)


def choice(name: str):
    """The next entry of a list."""

    def choose() -> None:
        combo = child(name)
        combo.setCurrentIndex((combo.currentIndex() + 1) % combo.count())

    return choose


def panels() -> dict:
    """How each panel is opened and what is changed in it."""
    sheet = assembly().Primary or model.parts(assembly())[0]

    found = {
        "Move Handle": (lambda: open_by("MoveHandle", regions("handle")[0]), None),
        "Blend Poses": (
            lambda: open_by("BlendPoses", api.poses(assembly())[0]),
            field("percent", 50.0),
        ),
        "Mark Fixed Region": (lambda: open_by("MarkFixed", sheet), type_band),
        "region": (lambda: edit(regions("fixed")[0]), button("Shrink")),
        "Form Feature": (
            lambda: open_by("FeatureSettings", regions("form feature")[0]),
            choice("rotation"),
        ),
        "Find Features": (lambda: open_by("FindFeatures"), None),
        "Propagation": (lambda: open_by("Propagation"), None),
        "Prepare Mesh": (lambda: open_by("PrepareMesh", sheet), None),
        "Thickness": (lambda: open_by("ThicknessMap", sheet), None),
        "Study": (lambda: open_by("Study"), None),
    }
    if contacts():
        found["Find Contacts"] = (lambda: open_by("FindContacts"), None)
        found["contact"] = (lambda: edit(contacts()[0]), choice("type"))
    return found


def answer(name: str, opened, used, way):
    """Opens a panel, changes something, and measures how long a way out takes."""
    Gui.Selection.clearSelection()
    opened()
    yield from until(is_shown, f"the panel {name}")
    yield from settled()
    if name == "Move Handle":
        child("translation_z").setValue(5.0 + answer.count)
        answer.count += 1
        yield from until(lambda: child("status").text().startswith("Computed"), "a frame")
    elif used is not None:
        used()
        yield from laid_out()
    before = time.process_time()
    yield from (escape(BOUND) if way == "Esc" else click(way, BOUND))
    note(f"    {name}: {1000.0 * (time.process_time() - before):.0f} ms of processor, all threads")
    if way == "OK" and name in ("Move Handle", "Mark Fixed Region"):
        picture(f"idle-{App.ActiveDocument.Name}-{name.replace(' ', '-')}")
    yield from until(lambda: not finishing.finishing().is_under_way(), "the shape")
    if Gui.Control.activeDialog():
        yield from press("Cancel")
    yield from settled()
    if way == "OK" and App.ActiveDocument.UndoCount:
        App.ActiveDocument.undo()
        yield from settled()
        yield from until(lambda: not finishing.finishing().is_under_way(), "the shape before")
    clear_report_view()


answer.count = 1


class Nothing:
    """A panel with nothing in it, to compare: what FreeCAD itself takes to close one."""

    def __init__(self):
        self.form = QtGui.QWidget()
        self.form.setObjectName("nothing")
        self.form.setWindowTitle("Nothing")

    def accept(self) -> bool:
        return True

    def reject(self) -> bool:
        return True


def measured():
    """Every panel, every way out."""
    for way in ("Cancel", "OK"):
        Gui.Control.showDialog(Nothing())
        yield from settled()
        (button,) = buttons_called(way)
        yield from timed(button.click, f"{way} of an empty panel", BOUND)
        yield from settled()
    for name, (opened, used) in panels().items():
        for way in ("Cancel", "Esc", "OK"):
            opened_way = way
            if name in ("Propagation", "Thickness") and way != "Esc":
                opened_way = "Close"
                if way == "OK":
                    continue
            if name in ("Prepare Mesh", "Study") and way == "OK":
                continue  # makes a mesh or runs variants, under a progress
            yield from answer(name, opened, used, opened_way)
    note(f"memory of {App.ActiveDocument.Name}: {megabytes()} MB")


def test_ok_cancel_and_escape_on_100000_vertices_are_measured():
    yield from grid_part(317)  # 100,489 vertices
    yield from measured()


def test_ok_cancel_and_escape_on_the_enclosure_are_measured():
    if not os.path.isfile(STEP):
        note("the enclosure: its STEP file is not at hand; SHEETMORPH_SHARED names the folder")
        return
    yield from enclosure()
    opened = megabytes()
    note(f"the enclosure before a panel: {opened} MB")
    assert opened <= MOST_OPEN, opened
    yield from measured()

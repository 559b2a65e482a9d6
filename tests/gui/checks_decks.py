# SPDX-License-Identifier: LGPL-2.1-or-later
"""A deck by mouse: its parts in the tree, quads, quality while dragging, the certificate."""

import json
import os

import FreeCAD as App
import FreeCADGui as Gui
import numpy as np
from checks_dragging import drag_up
from checks_moving import open_panel
from checks_showing import found, legend_in_the_view
from desk import WORK, activate, buttons_called, child, choose_below, click_widget, import_files
from desk import on_screen, picture, press, press_tool, settled, show_docks, until, xdotool
from freecad.sheetmorph import api
from freecad.sheetmorph.objects import model
from freecad.sheetmorph.qt import QtWidgets
from freecad.sheetmorph.scene.element_lines import NAME
from freecad.sheetmorph.tests.test_decks import ACROSS, ALONG, plates
from PySide import QtGui
from pivy import coin
from scenes import assembly, look

__all__ = [
    "test_a_deck_comes_in_as_a_tree_of_parts_with_quads",
    "test_elements_have_colours_and_a_histogram_while_dragging",
    "test_the_certificate_comes_from_the_toolbar",
    "test_a_deck_survives_undo_and_deletions_under_a_panel",
    "test_parts_of_a_deck_outlive_it_and_one_another",
]
QUADS = (ALONG - 1) * (ACROSS - 1)
EDGES = (ALONG - 1) * ACROSS + ALONG * (ACROSS - 1)


def parts() -> list:
    return model.parts(assembly())


def import_plates():
    """The two plates from their files, through Import Part…"""
    yield from activate()
    os.makedirs(os.path.join(WORK, "parts"), exist_ok=True)
    for name, text in zip(("plates.bdf", "parts/doubler.bdf"), plates()):
        with open(os.path.join(WORK, name), "w", encoding="ascii") as out:
            out.write(text)

    def arrived():
        return App.ActiveDocument is not None and len(App.ActiveDocument.Objects) > 7

    yield from import_files([os.path.join(WORK, "plates.bdf")], 0.0, arrived)
    look()
    yield from settled()


def hold_and_join() -> None:
    """The left end stays, the right one is a handle; the doubler is joined along its middle."""
    skin, doubler = parts()
    count = len(api.rest_mesh(skin)[0])
    api.add_fixed(assembly(), skin, range(2 * ACROSS))
    api.add_handle(assembly(), skin, range(count - ACROSS, count), "Tip")
    row = [ACROSS * k + 1 for k in range(ALONG)]
    api.add_contact(assembly(), (skin, row), (doubler, row))
    App.ActiveDocument.recompute()


def element_edges() -> list[int]:
    """How many edges of elements are seen, by part."""
    counts = []
    for part in parts():
        switches = [s for s in found(coin.SoSwitch, part.ViewObject.RootNode)]
        drawn = [s for s in switches if s.getName().getString() == NAME]
        seen = [s for s in drawn if s.whichChild.getValue() == coin.SO_SWITCH_ALL]
        lines = [line for switch in seen for line in found(coin.SoIndexedLineSet, switch)]
        counts += [sum(line.coordIndex.getNum() // 3 for line in lines)]
    return counts


def test_a_deck_comes_in_as_a_tree_of_parts_with_quads():
    yield from import_plates()
    skin, doubler = parts()
    assert [part.Label for part in (skin, doubler)] == ["skin", "PID 8"]
    shown = skin.ViewObject.Proxy.claimChildren()
    assert [child.Label for child in shown[1:]] == ["skin · PID 7 · 1.5 mm"]
    assert element_edges() == [EDGES, EDGES], "the diagonals of quads are no edges"
    doubler.ViewObject.Visibility = False
    assert element_edges() == [EDGES, 0]
    doubler.ViewObject.Visibility = True
    show_docks()
    yield from settled()
    for tree in Gui.getMainWindow().findChildren(QtGui.QTreeWidget):
        tree.expandAll()
    doubler.Shells[0].ViewObject.Visibility = True
    Gui.Selection.clearSelection()
    Gui.Selection.addSelection(skin.Shells[0])
    yield from settled()
    picture("deck-tree")
    (drawn,) = doubler.Shells[0].ViewObject.Proxy._drawn
    assert drawn.node.whichChild.getValue() == coin.SO_SWITCH_ALL


def test_elements_have_colours_and_a_histogram_while_dragging():
    yield from import_plates()
    hold_and_join()
    yield from open_panel()
    colours = child("colours")
    titles = [colours.itemText(k) for k in range(colours.count())]
    steps = titles.index("Elements: Jacobian")
    yield from choose_below(colours, steps)
    assert colours.currentText() == "Elements: Jacobian"
    x, y = on_screen(np.mean(api.rest_mesh(parts()[0])[0][-ACROSS:], axis=0))
    yield from xdotool("mousemove", x, y - 30, "mousedown", 1)
    yield from drag_up((x, y - 30), 12)
    yield from until(lambda: "worst Jacobian" in legend_in_the_view(), "the legend")
    bars = child("histogram")
    yield from until(lambda: bars.isVisible() and bars.pixmap() is not None, "the histogram")
    assert f"of {2 * QUADS} elements beyond the limit of 0.3" in child("scale_text").text()
    yield from settled()
    picture("deck-quality")
    yield from xdotool("mouseup", 1)
    yield from choose_below(colours, titles.index("Displacement") - steps)
    yield from until(lambda: not bars.isVisible(), "no histogram for what is no quality")
    yield from choose_below(colours, -1)
    yield from press("OK")
    assert element_edges() == [EDGES, EDGES]


def certify(folder: str, criteria: str):
    """Certificate… with its dialogs answered."""
    asked, chosen = (QtWidgets.QFileDialog.getExistingDirectory, QtWidgets.QInputDialog.getItem)
    answered = []
    QtWidgets.QFileDialog.getExistingDirectory = lambda *_: answered.append(folder) or folder
    QtWidgets.QInputDialog.getItem = lambda *_: (criteria, True)
    try:
        yield from press_tool("Certificate…")
        yield from until(lambda: answered, "both questions")
    finally:
        QtWidgets.QFileDialog.getExistingDirectory = asked
        QtWidgets.QInputDialog.getItem = chosen


def dialogs() -> list:
    every = Gui.getMainWindow().findChildren(QtGui.QDialog, "SheetMorphCertificate")
    return [dialog for dialog in every if dialog.isVisible()]


def test_the_certificate_comes_from_the_toolbar():
    yield from import_plates()
    hold_and_join()
    handle = next(region for region in model.regions(assembly()) if region.Role == "handle")
    api.set_motion(handle, (0, 0, 12))
    App.ActiveDocument.recompute()
    folder = os.path.join(WORK, "certified")
    yield from certify(folder, "static")
    yield from until(dialogs, "the verdict")
    text = dialogs()[0].findChild(QtGui.QLabel, "certificate").text()
    assert "Certified" in text and "joints: 11" in text, text
    yield from settled()
    picture("deck-certificate")
    with open(os.path.join(folder, "certificate.json"), encoding="utf-8") as file:
        assert json.load(file)["passed"]
    assert os.path.isfile(os.path.join(folder, "parts", "doubler.bdf"))
    yield from click_widget(buttons_called("Close")[0])
    yield from until(lambda: not dialogs(), "the dialog to close")


def test_a_deck_survives_undo_and_deletions_under_a_panel():
    yield from activate()
    App.newDocument("Undo")
    yield from settled()
    yield from import_plates()
    document = App.ActiveDocument
    document.undo()
    yield from settled()
    assert not model_objects(document), "the import is one step"
    document.redo()
    yield from settled()
    assert element_edges() == [EDGES, EDGES]
    hold_and_join()
    yield from open_panel()
    yield from choose_below(child("colours"), 9)
    yield from until(lambda: child("histogram").isVisible(), "the histogram")
    document.removeObject(parts()[0].Shells[0].Name)
    yield from settled()
    assert child("histogram").isVisible()
    yield from choose_below(child("colours"), -9)
    document.removeObject(model.decks(assembly())[0].Name)
    yield from until(lambda: not Gui.Control.activeDialog(), "the panel to end")


def test_parts_of_a_deck_outlive_it_and_one_another():
    yield from import_plates()
    document = App.ActiveDocument
    document.removeObject(model.decks(assembly())[0].Name)
    folder = os.path.join(WORK, "without")
    api.write_parts(assembly(), folder)
    assert sorted(os.listdir(folder)) == ["PID 8.obj", "skin.obj"]
    points = np.array([[float(x) for x in line.split()[1:]] for line in vertices(folder)])
    skin = parts()[0]
    assert np.array_equal(points, api.rest_mesh(skin)[0])
    Gui.Selection.clearSelection()
    Gui.Selection.addSelection(skin)
    Gui.runCommand("Std_Delete")
    yield from settled()
    assert len(parts()) == 1 and element_edges() == [EDGES]
    document.undo()
    yield from settled()
    assert len(parts()) == 2 and element_edges() == [EDGES, EDGES]
    App.closeDocument(document.Name)
    yield from until(lambda: App.ActiveDocument is not document, "the document to close")


def vertices(folder: str) -> list[str]:
    with open(os.path.join(folder, "skin.obj"), encoding="ascii") as file:
        return [line for line in file if line.startswith("v ")]


def model_objects(document) -> list:
    return [obj for obj in document.Objects if model.kind(obj)]

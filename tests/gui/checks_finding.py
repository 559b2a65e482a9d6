# SPDX-License-Identifier: LGPL-2.1-or-later
"""What is found is proposed in a list, lights up under the mouse, and comes in as one undo step."""

import threading

import FreeCAD as App
import FreeCADGui as Gui
from desk import activate, child, choose_below, enter, picture, press, press_tool, settled, tick
from desk import until, view, within_reach, xdotool
from checks_propagation import Canceller, dialog
from freecad.sheetmorph import api
from freecad.sheetmorph.commands import exchange
from freecad.sheetmorph.objects import model
from freecad.sheetmorph.panels import find_table
from hostile_panels import is_shown
from PySide import QtCore, QtGui
from scenes import assembly, contacts, drawn, labelled, largest, look, new_assembly, part
from scenes import regions
from sheetmorph import finding

__all__ = [
    "test_holes_found_become_form_features_in_one_step",
    "test_proposals_are_filtered_by_kind_and_size",
    "test_bends_are_offered_and_not_checked",
    "test_contacts_found_light_up_and_become_contacts",
    "test_what_takes_long_is_cancelled_and_nothing_has_changed",
    "test_only_selected_parts_are_searched",
    "test_the_window_goes_on_while_a_search_takes_long",
    "test_names_stand_in_full_and_a_double_click_zooms_to_the_place",
    "test_hundreds_of_vertices_are_not_printed_into_the_console",
    "test_a_bare_frame_is_dragged_after_two_clicks_and_a_handle",
]


def bare_frame() -> None:
    """The welded frame with a handle and a fixed end, and nothing else marked."""
    assert exchange.open_recipe(exchange.example_recipes()["Welded Frame"], "Frame")
    document, morph = App.ActiveDocument, assembly()
    api.reset_motion(regions("handle")[0])
    for obj in [*regions("form feature"), *model.contacts(morph)]:
        document.removeObject(obj.Name)
    document.recompute()
    document.clearUndos()
    look()


def rows_shown() -> int:
    """How many proposals are seen."""
    table = child("table")
    return sum(not table.isRowHidden(row) for row in range(table.rowCount()))


def cell_place(row: int, offset: int = 60) -> tuple[int, int]:
    """Where the first cell of a row is on the screen."""
    table = child("table")
    cell = table.visualItemRect(table.item(row, 0))
    place = table.viewport().mapToGlobal(QtCore.QPoint(cell.left() + offset, cell.center().y()))
    return place.x(), place.y()


def press_ok():
    """OK, and the recompute after it, which lets events through."""
    yield from press("OK")
    yield from until(lambda: not Gui.Control.activeDialog(), "the panel to close")


def lit(which) -> int:
    """How many nodes hang over a part."""
    return which.ViewObject.RootNode.getNumChildren()


class FollowedLinks:
    """How often the deformation is given other regions in a context."""

    count = 0

    def __enter__(self):
        App.addDocumentObserver(self)

    def __exit__(self, *_):
        App.removeDocumentObserver(self)

    def slotChangedObject(self, obj, name: str) -> None:
        self.count += name == "Regions" and model.kind(obj) == model.DEFORMATION


def test_holes_found_become_form_features_in_one_step():
    yield from new_assembly()
    before = len(regions("form feature"))
    for region in regions("form feature"):
        App.ActiveDocument.removeObject(region.Name)
    App.ActiveDocument.clearUndos()
    yield from press_tool("Find Features…")
    assert child("table").rowCount() == before == 2
    nodes, links = lit(part()), FollowedLinks()
    x, y = cell_place(0)
    yield from xdotool("mousemove", x, y)
    yield from settled()
    assert lit(part()) == nodes + 1
    picture("find-features")
    over = view().graphicsView().viewport()  # the panel may lie left or right of its middle
    away = over.mapToGlobal(over.rect().center())
    yield from xdotool("mousemove", away.x(), away.y())
    yield from settled()
    assert lit(part()) == nodes
    with links:
        yield from press_ok()
    assert len(regions("form feature")) == 2 and links.count == 1
    assert App.ActiveDocument.UndoNames == ["Find Features"]
    App.ActiveDocument.undo()
    assert regions("form feature") == []
    App.ActiveDocument.redo()
    assert len(regions("form feature")) == 2


def test_what_takes_long_is_cancelled_and_nothing_has_changed():
    yield from new_assembly()
    for region in regions("form feature"):
        App.ActiveDocument.removeObject(region.Name)
    App.ActiveDocument.clearUndos()
    yield from press_tool("Find Features…")
    with Canceller():
        yield from press("OK")
        yield from until(lambda: "Cancelled" in child("message").text(), "the panel to say so")
    picture("find-cancelled")
    assert dialog() is None or not dialog().isVisible()
    assert regions("form feature") == [] and App.ActiveDocument.UndoNames == []
    yield from press_ok()
    assert len(regions("form feature")) == 2


def test_the_window_goes_on_while_a_search_takes_long():
    yield from new_assembly()
    found, beats, may_go_on = finding.find, [], threading.Event()

    def slow(*arguments, **keywords):
        assert may_go_on.wait(60.0), "the window was blocked"
        return found(*arguments, **keywords)

    def beat() -> None:
        if dialog() and dialog().isVisible():
            beats.append(dialog().value())
        if len(beats) > 10:
            may_go_on.set()

    finding.find = slow
    timer = QtCore.QTimer()
    timer.timeout.connect(beat)
    timer.start(20)
    try:
        yield from press_tool("Find Features…")
        yield from until(is_shown, "the proposals")
    finally:
        timer.stop()
        finding.find = found
    assert len(beats) > 10, "no beat while the progress was shown"
    assert rows_shown() == 2 and dialog() is None
    yield from press("Cancel")


def test_only_selected_parts_are_searched():
    yield from new_assembly()
    Gui.Selection.addSelection(labelled("bracket"))
    yield from press_tool("Find Features…")
    assert rows_shown() == 0
    yield from press("Cancel")
    Gui.Selection.clearSelection()
    yield from press_tool("Find Features…")
    assert rows_shown() == 2
    yield from press("Cancel")
    for label, is_touching in (("loose", False), ("bracket", True)):
        Gui.Selection.clearSelection()
        Gui.Selection.addSelection(labelled(label))
        yield from press_tool("Find Contacts…")
        table = child("table")
        names = [table.item(row, 0).text() for row in range(table.rowCount())]
        assert bool(names) == is_touching and all(label in name for name in names), names
        yield from press("Cancel")


def test_proposals_are_filtered_by_kind_and_size():
    yield from activate()
    bare_frame()
    yield from press_tool("Find Features…")
    everything = rows_shown()
    assert everything == 50
    yield from enter(child("smallest"), "20")
    large = rows_shown()
    assert 0 < large < everything
    largest = child("largest")
    for typed, text, shown in (
        ("10", "10.00 mm", 0),
        ("0", "any size", large),
        ("any size", "any size", large),
        ("10 mm", "10.00 mm", 0),
    ):
        yield from enter(largest, typed)
        assert (largest.text(), rows_shown()) == (text, shown), (typed, largest.text())
    yield from xdotool("key", "shift+Tab", "ctrl+a", "Delete", "Tab")
    assert (largest.text(), rows_shown()) == ("any size", large), "an emptied field"
    yield from press("None")
    assert find_table.checked(child("table")) == []
    yield from press("OK")
    assert "Nothing is checked" in child("message").text()
    x, y = cell_place(next(r for r in range(50) if not child("table").isRowHidden(r)), 10)
    yield from xdotool("mousemove", x, y, "click", 1)
    assert len(find_table.checked(child("table"))) == 1
    yield from within_reach(child("surfaces"))
    yield from tick(child("surfaces"))
    yield from press("Search Again")
    yield from within_reach(child("kind"))
    yield from choose_below(child("kind"), 1)
    kinds = {child("kind").itemText(k) for k in range(child("kind").count())}
    assert {"plane", "round hole"} <= kinds
    picture("find-filtered")
    yield from press("Cancel")
    assert App.ActiveDocument.UndoNames == []


def test_bends_are_offered_and_not_checked():
    yield from activate()
    assert exchange.open_recipe(exchange.example_recipes()["Door Mirror"], "Mirror")
    look()
    yield from press_tool("Find Features…")
    table = child("table")
    (row,) = (r for r in range(table.rowCount()) if "bend" in table.item(r, 0).text())
    assert table.item(row, 0).checkState() == QtCore.Qt.Unchecked
    assert table.item(row, 1).text().startswith("R ")
    table.scrollToItem(table.item(row, 0))
    yield from xdotool("mousemove", *cell_place(row))
    yield from settled()
    picture("find-bend")
    yield from press("Cancel")


def test_contacts_found_light_up_and_become_contacts():
    yield from new_assembly()
    yield from press_tool("Find Contacts…")
    yield from within_reach(child("gap"))
    yield from enter(child("gap"), "1.5")
    yield from press("Search Again")
    yield from within_reach(child("kind"))
    table = child("table")
    assert table.rowCount() >= 1
    mine = [p for p in model.parts(assembly()) if p.Label.startswith(("sheet", "bracket"))]
    nodes = [lit(each) for each in mine]
    yield from xdotool("mousemove", *cell_place(0))
    yield from settled()
    assert [lit(each) for each in mine] == [count + 1 for count in nodes]
    picture("find-contacts")
    yield from press_ok()
    assert contacts() and all(contact.PartA != contact.PartB for contact in contacts())
    assert App.ActiveDocument.UndoNames == ["Find Contacts"]
    yield from press_tool("Find Contacts…")
    assert "already in the document" in child("count").text()
    yield from press("Cancel")


def test_a_bare_frame_is_dragged_after_two_clicks_and_a_handle():
    yield from activate()
    bare_frame()
    parts = model.parts(assembly())
    for title, least in (("Find Features…", 50), ("Find Contacts…", 24)):
        yield from press_tool(title)
        yield from until(is_shown, "the panel")
        assert rows_shown() >= least
        picture("find-frame-" + title.split()[1][:8].lower())
        yield from press_ok()
    assert assembly().Unreached == []
    rest = [drawn(each) for each in parts]
    yield from press_tool("Move Handle…")
    yield from enter(child("translation_z"), "40")

    def moved() -> list:
        return [largest(drawn(each) - before) for each, before in zip(parts, rest)]

    yield from until(lambda: min(moved()) > 0.3, "every part to follow")
    picture("find-frame-moved")
    yield from press("Cancel")


def is_in_full(table, row: int) -> bool:
    """Whether the name in a row has the room that it needs."""
    room = table.visualItemRect(table.item(row, 0))
    wide = room.width() - 30  # beside the check box
    flags = QtCore.Qt.TextWordWrap
    needed = table.fontMetrics().boundingRect(0, 0, wide, 999, flags, table.item(row, 0).text())
    return needed.width() <= wide and needed.height() <= room.height()


def test_names_stand_in_full_and_a_double_click_zooms_to_the_place():
    yield from new_assembly()
    part().Label = "side panel with the long name of a drawing, left"
    labelled("bracket").Label = "bracket of the same drawing with a long name, 2nd"
    Gui.Selection.clearSelection()
    yield from press_tool("Find Contacts…")
    table = child("table")
    assert rows_shown() > 0
    assert all(is_in_full(table, row) for row in range(table.rowCount()))
    assert "side panel with the long name" in table.item(0, 0).toolTip()
    picture("find-long-names")
    before = view().getCameraNode().height.getValue()
    x, y = cell_place(0)
    yield from xdotool("mousemove", x, y, "click", "--repeat", 2, "--delay", 60, 1)
    height = view().getCameraNode().height
    yield from until(lambda: height.getValue() < 0.8 * before, "the view to come near")
    picture("find-zoomed")
    yield from press("Cancel")


def test_hundreds_of_vertices_are_not_printed_into_the_console():
    yield from new_assembly()
    Gui.Selection.clearSelection()
    yield from press_tool("Find Contacts…")
    console = Gui.getMainWindow().findChild(QtGui.QPlainTextEdit, "Python console")
    console.clear()
    yield from press_ok()
    assert len(contacts()) > 0
    said = console.toPlainText()
    assert "recompute" in said and "add_contact" not in said, said
    macro = App.ParamGet("User parameter:BaseApp/Preferences/Macro")
    assert macro.GetBool("ScriptToPyConsole", True)

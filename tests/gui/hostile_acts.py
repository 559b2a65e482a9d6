# SPDX-License-Identifier: LGPL-2.1-or-later
"""What is done under an open panel that it did not ask for."""

import os
import subprocess

import FreeCAD as App
import FreeCADGui as Gui
from desk import WORK, answered, say_yes, settled, show_docks, until, view, xdotool
from PySide import QtCore, QtGui
from freecad.sheetmorph import api
from freecad.sheetmorph.objects import model
from scenes import assembly, contacts, part, regions


def undo(_subject):
    Gui.runCommand("Std_Undo")
    yield from settled()


def undo_all(_subject):
    while App.ActiveDocument.UndoNames:
        Gui.runCommand("Std_Undo")
        yield from settled()
    yield from settled()


def undo_all_at_once(_subject):
    while App.ActiveDocument.UndoNames:
        App.ActiveDocument.undo()
    yield from settled()


def undo_and_redo(_subject):
    yield from undo_all(_subject)
    while App.ActiveDocument.RedoNames:
        Gui.runCommand("Std_Redo")
        yield from settled()
    yield from settled()


def delete(obj) -> None:
    """As the tree does; the question whether that may break something is answered with yes."""
    Gui.Selection.clearSelection()
    Gui.Selection.addSelection(obj)
    with answered(say_yes):
        Gui.runCommand("Std_Delete")


def delete_subject(subject):
    delete(subject)
    yield from settled()


def delete_part(_subject):
    delete(part())
    yield from settled()


def delete_fixed(_subject):
    delete(regions("fixed")[0])
    yield from settled()


def delete_handle(_subject):
    delete(regions("handle")[0])
    yield from settled()


def delete_contact(_subject):
    delete(contacts()[0])
    yield from settled()


def delete_feature(_subject):
    delete(regions("form feature")[0])
    yield from settled()


def delete_pose(_subject):
    delete(api.poses(assembly())[0])
    yield from settled()


def delete_in_python(subject):
    App.ActiveDocument.removeObject(subject.Name)
    yield from settled()


def close_document(_subject):
    App.closeDocument(App.ActiveDocument.Name)
    yield from settled()


def close_dialog(_subject):
    Gui.Control.closeDialog()
    yield from settled()


def another_command(_subject):
    Gui.runCommand("Std_Part")
    yield from settled()


def our_command(_subject):
    """One that opens no panel and asks for nothing; only the guide lets it do something."""
    Gui.runCommand("SheetMorph_Flatten")
    yield from settled()
    # The guide gives way to a command and comes back; other panels stay.
    yield from until(Gui.Control.activeDialog, "the panel again")


def another_document(_subject):
    mine = App.ActiveDocument.Name
    App.newDocument("Other")
    yield from settled()
    App.closeDocument("Other")
    App.setActiveDocument(mine)
    yield from settled()


def another_workbench(_subject):
    Gui.activateWorkbench("MeshWorkbench")
    yield from settled()
    Gui.activateWorkbench("SheetMorphWorkbench")
    yield from settled()


def spreadsheet(_subject):
    sheet = App.ActiveDocument.addObject("Spreadsheet::Sheet", "Cells")
    sheet.ViewObject.doubleClicked()
    yield from settled()


def tall_view(_subject):
    (window, before) = (Gui.getMainWindow(), Gui.getMainWindow().geometry())
    window.showNormal()
    window.resize(560, 950)
    yield from settled()
    window.setGeometry(before)
    window.showMaximized()
    yield from until(lambda: window.geometry() == before, "the window to be as it was")
    yield from settled()


def second_view(_subject):
    Gui.runCommand("Std_ViewCreate")
    yield from settled()
    close_active_window()
    yield from settled()


def split_view(_subject):
    """Two views beside each other, each taller than wide, and one again."""
    mdi = Gui.getMainWindow().findChild(QtGui.QMdiArea)
    Gui.runCommand("Std_ViewCreate")
    yield from settled()
    mdi.tileSubWindows()
    yield from settled()
    close_active_window()
    yield from settled()
    mdi.activeSubWindow().showMaximized()
    yield from settled()


def first_view_closed(_subject):
    """The view the panel works in is closed, another one of the document stays."""
    mdi = Gui.getMainWindow().findChild(QtGui.QMdiArea)
    first = mdi.activeSubWindow()
    Gui.runCommand("Std_ViewCreate")
    yield from settled()
    mdi.setActiveSubWindow(first)
    yield from settled()
    close_active_window()
    yield from settled()


def save(_subject):
    """Under another name, then once more: the next test opens the first file."""
    App.ActiveDocument.saveAs(os.path.join(WORK, "hostile-saved.FCStd"))
    yield from settled()
    Gui.runCommand("Std_Save")
    yield from settled()


def revert(_subject):
    """The document as it was saved, in place of what it is."""
    with answered(say_yes):
        Gui.runCommand("Std_Revert")
    yield from settled()
    assert App.ActiveDocument.UndoNames == [], "the document is not that of the file"


def hide_and_show(_subject):
    """The part, as the space bar does."""
    for is_shown in (False, True):
        Gui.Selection.clearSelection()
        Gui.Selection.addSelection(part())
        Gui.runCommand("Std_ToggleVisibility")
        yield from settled()
        assert part().ViewObject.Visibility == is_shown, f"shown: {not is_shown}"


def hide_until_the_end(_subject):
    """The part stays hidden when the panel has closed."""
    shown = part()
    shown.ViewObject.Visibility = False
    yield from settled()
    Gui.Control.closeDialog()
    yield from settled()
    assert not shown.ViewObject.Visibility, "a hidden part came into view again"
    shown.ViewObject.Visibility = True


def rename(subject):
    """As the tree does, in a step of its own; and back."""
    for label in ("“Renamed” <b>&amp; 2", subject.Label):
        App.ActiveDocument.openTransaction("Relabel")
        subject.Label = label
        App.ActiveDocument.commitTransaction()
        yield from settled()


def escape_twice(_subject):
    """With the mouse over the view."""
    over = view().graphicsView().viewport()
    place = over.mapToGlobal(over.rect().center())
    view().graphicsView().setFocus()
    yield from xdotool("mousemove", place.x(), place.y(), "key", "Escape", "key", "Escape")
    yield from settled()


def select_in_tree(subject):
    """A click on what the panel is about, and one on a region."""
    yield from show_tab("Model")
    for obj in (subject, regions("fixed")[0]):
        x, y = place_in_tree(obj.Label)
        yield from xdotool("mousemove", x, y, "click", 1)
        yield from settled()
        assert obj in Gui.Selection.getSelection(), "the click in the tree selected something else"
    yield from show_tab("Tasks")


def drag_in_tree(label: str, onto: str):
    """What is called so, onto something else, with the mouse."""
    show_docks()
    yield from settled()
    yield from show_tab("Model")
    place_in_tree(label)  # which may scroll the tree, and the other one again
    end, begin = place_in_tree(onto), place_in_tree(label)
    if end != place_in_tree(onto):
        return  # too far apart to be seen together
    # In one go: while Qt drags it tells of no button that is released.
    words = ["mousemove", *begin, "mousedown", 1, "sleep", 0.1]
    for place in (begin[0] + 20, begin[1] + 4), end, (end[0] + 1, end[1]):
        words += ["mousemove", *place, "sleep", 0.1]
    dragged = subprocess.Popen(["xdotool", *map(str, [*words, "mouseup", 1])])
    yield from until(lambda: dragged.poll() is not None, "the end of the drag")
    assert dragged.returncode == 0
    yield from settled()
    yield from show_tab("Tasks")


def take_out_of_the_morph(_subject):
    """A region leaves its group in a step, as when it is dragged to the document in the tree."""
    App.ActiveDocument.openTransaction("Move object")
    assembly().removeObject(regions("fixed")[0])
    App.ActiveDocument.commitTransaction()
    yield from settled()
    assert not regions("fixed"), "the region is still in the morph"


def move_source(_subject):
    """Where a part stands, as the property editor changes it."""
    with_step("Edit Placement", lambda: part().Source.Placement.move(App.Vector(0, 0, 5)))
    yield from settled()


def delete_source(_subject):
    """The mesh a part rests on."""
    delete(part().Source)
    yield from settled()


def link_to_it(subject):
    """Links to what the panel is about, to a part, to the morph: they answer as what they link to.

    Each is selected too, and commands are asked whether they would do something.
    """
    document = App.ActiveDocument
    for obj in (subject, part(), assembly()):
        link = document.addObject("App::Link", "Link")
        link.LinkedObject = obj
        document.recompute()
        Gui.Selection.clearSelection()
        Gui.Selection.addSelection(link)
        yield from settled()
    for obj in (subject, part(), assembly()):
        assert obj.Name in {one.Name for one in document.Objects}
    assert len(model.parts(assembly())) == 3


def copy_morph(_subject):
    """The whole morph, into the same document and into another one, that goes again."""
    mine = App.ActiveDocument
    with_step("Copy", lambda: mine.copyObject(assembly(), True))
    yield from settled()
    other = App.newDocument("Other")
    other.copyObject(mine.getObject(assembly_in(mine).Name), True)
    other.recompute()
    yield from settled()
    App.closeDocument("Other")
    App.setActiveDocument(mine.Name)
    yield from settled()


def assembly_in(document):
    return next(o for o in document.Objects if model.kind(o) == model.ASSEMBLY)


def with_step(title: str, action) -> None:
    """In an undo step of its own, as in the property editor."""
    App.ActiveDocument.openTransaction(title)
    action()
    App.ActiveDocument.recompute()
    App.ActiveDocument.commitTransaction()


def other_units(_subject):
    """Inches, and millimetres again."""
    for schema in (3, 0):
        App.Units.setSchema(schema)
        yield from settled()


def show_tab(title: str):
    """Clicks the tab of the tree, or of the panels, where they share a window."""
    for bar in Gui.getMainWindow().findChildren(QtGui.QTabBar):
        texts = [bar.tabText(k) for k in range(bar.count())]
        if title in texts and bar.isVisible():
            place = bar.mapToGlobal(bar.tabRect(texts.index(title)).center())
            yield from xdotool("mousemove", place.x(), place.y(), "click", 1)
    yield from settled()


def place_in_tree(label: str) -> tuple[int, int]:
    """Where an object stands in the tree, on the screen."""
    trees = Gui.getMainWindow().findChildren(QtGui.QTreeWidget)
    # Not a panel's: in FreeCAD 1.0 it remains visible, in a tab behind.
    trees = [tree for tree in trees if tree.metaObject().className() == "Gui::TreeWidget"]
    (tree,) = filter(QtGui.QWidget.isVisible, trees)
    item = tree.findItems(label, QtCore.Qt.MatchExactly | QtCore.Qt.MatchRecursive)[0]
    tree.scrollToItem(item)
    rect = tree.visualItemRect(item)
    place = tree.viewport().mapToGlobal(QtCore.QPoint(rect.left() + 30, rect.center().y()))
    return place.x(), place.y()


def close_active_window() -> None:
    Gui.getMainWindow().findChild(QtGui.QMdiArea).activeSubWindow().close()


GENTLE = (
    close_dialog,
    another_document,
    another_workbench,
    tall_view,
    second_view,
    split_view,
    first_view_closed,
    spreadsheet,
    another_command,
    our_command,
)
OF_A_PERSON = (
    save,
    hide_and_show,
    hide_until_the_end,
    rename,
    escape_twice,
    select_in_tree,
    take_out_of_the_morph,
)
FROM_ELSEWHERE = (move_source, other_units, link_to_it, copy_morph, delete_source)
STEPS = (undo, undo_all, undo_all_at_once, undo_and_redo, revert, close_document)
DELETIONS = (
    delete_subject,
    delete_part,
    delete_fixed,
    delete_handle,
    delete_contact,
    delete_feature,
    delete_pose,
    delete_in_python,
)
DESTRUCTIVE = STEPS + DELETIONS

# SPDX-License-Identifier: LGPL-2.1-or-later
"""What is done under an open panel that it did not ask for."""

import FreeCAD as App
import FreeCADGui as Gui
from desk import answered, say_yes, settled, until
from PySide import QtGui
from freecad.sheetmorph import api
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
STEPS = (undo, undo_all, undo_all_at_once, undo_and_redo, close_document)
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

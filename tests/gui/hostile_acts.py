# SPDX-License-Identifier: LGPL-2.1-or-later
"""What is done under an open panel that it did not ask for."""

import FreeCAD as App
import FreeCADGui as Gui
from desk import until
from PySide import QtCore, QtGui
from freecad.sheetmorph import api
from scenes import assembly, contacts, part, regions


def undo(_subject):
    Gui.runCommand("Std_Undo")
    yield 60


def undo_all(_subject):
    while App.ActiveDocument.UndoNames:
        Gui.runCommand("Std_Undo")
        yield 20
    yield 40


def undo_all_at_once(_subject):
    while App.ActiveDocument.UndoNames:
        App.ActiveDocument.undo()
    yield 60


def undo_and_redo(_subject):
    yield from undo_all(_subject)
    while App.ActiveDocument.RedoNames:
        Gui.runCommand("Std_Redo")
        yield 20
    yield 40


def delete(obj) -> None:
    """As the tree does; the question whether that may break something is answered with yes."""
    Gui.Selection.clearSelection()
    Gui.Selection.addSelection(obj)
    answering = QtCore.QTimer()  # it goes on while the question waits, however late that comes
    answering.timeout.connect(answer_yes)
    answering.start(50)
    Gui.runCommand("Std_Delete")
    answering.stop()


def answer_yes() -> None:
    box = QtGui.QApplication.activeModalWidget()
    if isinstance(box, QtGui.QMessageBox):
        box.button(QtGui.QMessageBox.Yes).click()


def delete_subject(subject):
    delete(subject)
    yield 200


def delete_part(_subject):
    delete(part())
    yield 200


def delete_fixed(_subject):
    delete(regions("fixed")[0])
    yield 200


def delete_handle(_subject):
    delete(regions("handle")[0])
    yield 200


def delete_contact(_subject):
    delete(contacts()[0])
    yield 200


def delete_feature(_subject):
    delete(regions("form feature")[0])
    yield 200


def delete_pose(_subject):
    delete(api.poses(assembly())[0])
    yield 200


def delete_in_python(subject):
    App.ActiveDocument.removeObject(subject.Name)
    yield 100


def close_document(_subject):
    App.closeDocument(App.ActiveDocument.Name)
    yield 150


def close_dialog(_subject):
    Gui.Control.closeDialog()
    yield 60


def another_command(_subject):
    Gui.runCommand("Std_Part")
    yield 60


def our_command(_subject):
    """One that opens no panel and asks for nothing; only the guide lets it do something."""
    Gui.runCommand("SheetMorph_Flatten")
    yield 60
    # The guide gives way to a command and comes back; other panels stay.
    yield from until(Gui.Control.activeDialog, "the panel again")


def another_document(_subject):
    mine = App.ActiveDocument.Name
    App.newDocument("Other")
    yield 60
    App.closeDocument("Other")
    App.setActiveDocument(mine)
    yield 60


def another_workbench(_subject):
    Gui.activateWorkbench("MeshWorkbench")
    yield 100
    Gui.activateWorkbench("SheetMorphWorkbench")
    yield 100


def spreadsheet(_subject):
    sheet = App.ActiveDocument.addObject("Spreadsheet::Sheet", "Cells")
    sheet.ViewObject.doubleClicked()
    yield 150


def tall_view(_subject):
    (window, before) = (Gui.getMainWindow(), Gui.getMainWindow().geometry())
    window.showNormal()
    window.resize(560, 950)
    yield 150
    window.setGeometry(before)
    window.showMaximized()
    yield from until(lambda: window.geometry() == before, "the window to be as it was")
    yield 150


def second_view(_subject):
    Gui.runCommand("Std_ViewCreate")
    yield 150
    close_active_window()
    yield 150


def split_view(_subject):
    """Two views beside each other, each taller than wide, and one again."""
    mdi = Gui.getMainWindow().findChild(QtGui.QMdiArea)
    Gui.runCommand("Std_ViewCreate")
    yield 100
    mdi.tileSubWindows()
    yield 150
    close_active_window()
    yield 50
    mdi.activeSubWindow().showMaximized()
    yield 150


def first_view_closed(_subject):
    """The view the panel works in is closed, another one of the document stays."""
    mdi = Gui.getMainWindow().findChild(QtGui.QMdiArea)
    first = mdi.activeSubWindow()
    Gui.runCommand("Std_ViewCreate")
    yield 150
    mdi.setActiveSubWindow(first)
    yield 50
    close_active_window()
    yield 150


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

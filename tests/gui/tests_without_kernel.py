# SPDX-License-Identifier: LGPL-2.1-or-later
"""The workbench without its compiled kernel: it loads and says what to do."""

import os

import FreeCAD as App
import FreeCADGui as Gui
from desk import WORK, activate, picture, report_view, settled, until
from PySide import QtGui


def test_the_workbench_loads_and_says_one_sentence():
    yield from activate()
    assert Gui.activeWorkbench().name() == "SheetMorphWorkbench"
    said = [line for line in report_view().splitlines() if "SheetMorph:" in line]
    assert len(said) == 1 and "./sheetmorph install" in said[0], said


def test_check_installation_shows_a_report_to_copy():
    yield from activate()
    Gui.runCommand("SheetMorph_CheckInstallation")
    dialog = lambda: Gui.getMainWindow().findChild(QtGui.QDialog, "SheetMorphReport")  # noqa: E731
    yield from until(lambda: dialog() is not None and dialog().isVisible(), "the report")
    picture("report")
    text = dialog().findChild(QtGui.QPlainTextEdit).toPlainText()
    assert "not usable" in text and "_core" in text
    dialog().close()


def test_a_document_with_a_morph_still_opens_and_says_what_is_missing():
    yield from activate()
    App.openDocument(os.path.join(WORK, "saved.FCStd"))  # saved by a test with the kernel
    yield from settled()
    from freecad.sheetmorph.objects import model

    (part,) = [o for o in App.ActiveDocument.Objects if model.kind(o) == model.PART]
    points = part.Mesh.CountPoints
    assert points > 1000
    assert not Gui.Command.get("SheetMorph_MoveHandle").isActive()
    part.Deformation.touch()
    App.ActiveDocument.recompute()
    assert part.Mesh.CountPoints == points
    assert "./sheetmorph install" in part.Deformation.getStatusString()

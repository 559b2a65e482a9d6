# SPDX-License-Identifier: LGPL-2.1-or-later
"""The report of Check Installation, ready to copy."""

import FreeCADGui as Gui

from freecad.sheetmorph.bridge import kernel
from freecad.sheetmorph.qt import QtGui, QtWidgets, connect, translate
from freecad.sheetmorph.scene import drawing


def show() -> None:
    """Show the report; Copy puts it on the clipboard."""
    dialog = QtWidgets.QDialog(Gui.getMainWindow())
    dialog.setObjectName("SheetMorphReport")
    dialog.setWindowTitle(translate("SheetMorph_CheckInstallation", "Check Installation"))
    dialog.resize(720, 420)
    text = QtWidgets.QPlainTextEdit(f"{kernel.report()}\n{drawing.report()}", dialog)
    text.setReadOnly(True)
    text.setLineWrapMode(QtWidgets.QPlainTextEdit.WidgetWidth)
    text.setFont(QtGui.QFontDatabase.systemFont(QtGui.QFontDatabase.FixedFont))
    buttons = QtWidgets.QDialogButtonBox(QtWidgets.QDialogButtonBox.Close, dialog)
    copy = buttons.addButton(
        translate("SheetMorph_CheckInstallation", "Copy"), QtWidgets.QDialogButtonBox.ActionRole
    )
    clipboard = QtWidgets.QApplication.clipboard()
    connect(copy, "clicked()", lambda: clipboard.setText(text.toPlainText()))
    connect(buttons, "rejected()", dialog.reject)
    column = QtWidgets.QVBoxLayout(dialog)
    column.addWidget(text)
    column.addWidget(buttons)
    dialog.show()

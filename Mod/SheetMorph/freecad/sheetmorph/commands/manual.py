# SPDX-License-Identifier: LGPL-2.1-or-later
"""The command that opens the manual in the browser."""

from freecad.sheetmorph import paths
from freecad.sheetmorph.commands.base import Command
from freecad.sheetmorph.qt import QtCore, QtGui

QT_TRANSLATE_NOOP = QtCore.QT_TRANSLATE_NOOP


class Manual(Command):
    """The command that opens the start page of the manual."""

    name = "SheetMorph_Manual"
    text = QT_TRANSLATE_NOOP("SheetMorph_Manual", "SheetMorph Manual")
    tooltip = QT_TRANSLATE_NOOP(
        "SheetMorph_Manual", "Opens the manual in the browser, also without a network"
    )
    alters = False
    needs_kernel = False

    def possible(self) -> bool:
        """Return True; `execute` reports a missing manual."""
        return True

    def execute(self) -> None:
        """Open the start page."""
        page = paths.manual("index.html")
        if not page:
            raise RuntimeError(
                "The manual is not installed; run ./sheetmorph docs, then ./sheetmorph install."
            )
        if not QtGui.QDesktopServices.openUrl(QtCore.QUrl(page)):
            raise RuntimeError(f"No browser opens {page}; open this address in one.")

# SPDX-License-Identifier: LGPL-2.1-or-later
"""The command for a report about the installation, and a warning without a kernel."""

import FreeCAD as App

from freecad.sheetmorph.bridge import kernel
from freecad.sheetmorph.commands.base import Command
from freecad.sheetmorph.qt import QtCore

QT_TRANSLATE_NOOP = QtCore.QT_TRANSLATE_NOOP


class CheckInstallation(Command):
    """The command that shows the report about the kernel."""

    name = "SheetMorph_CheckInstallation"
    text = QT_TRANSLATE_NOOP("SheetMorph_CheckInstallation", "Check Installation")
    tooltip = QT_TRANSLATE_NOOP(
        "SheetMorph_CheckInstallation",
        "Checks the deformation kernel and shows a report that you can copy",
    )
    alters = False
    needs_kernel = False

    def possible(self) -> bool:
        """Return True, since the report helps when nothing else works."""
        return True

    def execute(self) -> None:
        """Open the report."""
        from freecad.sheetmorph.panels import report_dialog

        report_dialog.show()


def warn_once(workbench) -> None:
    """Warn on the first activation if the kernel cannot be used."""
    try:
        kernel.load()
    except kernel.KernelError as error:
        if not getattr(workbench, "has_warned", False):
            workbench.has_warned = True
            App.Console.PrintWarning(f"SheetMorph: {error}\n")

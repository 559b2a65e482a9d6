# SPDX-License-Identifier: LGPL-2.1-or-later
"""The tooltip of a disabled command, which says what the user must do first."""

import FreeCADGui as Gui

from freecad.sheetmorph.qt import translate


class Hint:
    """The sentence in the tooltip and in the status bar of a command's action.

    FreeCAD writes both texts anew after a change of language or shortcut. Therefore a text that is
    not ours is always the original.
    """

    def __init__(self, name: str):
        self._name, self._action = name, None
        self._lacking = self._shown = ""
        self._original = ("", "")

    def show(self, lacking: str) -> None:
        """Show what the command lacks; restore the original texts if that is nothing.

        FreeCAD calls this often, so an unchanged sentence returns at once.
        """
        if lacking == self._lacking and (not lacking or self._action.toolTip() == self._shown):
            return
        if self._action is None:
            self._action = next(iter(Gui.Command.get(self._name).getAction() or ()), None)
        if self._action is not None:  # FreeCAD makes it with the first menu or toolbar
            self._write(lacking)

    def _write(self, lacking: str) -> None:
        if self._action.toolTip() != self._shown:
            self._original = self._action.toolTip(), self._action.statusTip()
        tip, status = self._original
        if lacking:
            status = translate("SheetMorph_needs", lacking)
            tip = f"{tip}<p><b>{status}</b></p>" if tip.startswith("<") else f"{tip}\n{status}"
        self._action.setToolTip(tip)
        self._action.setStatusTip(status)
        self._lacking, self._shown = lacking, tip if lacking else ""

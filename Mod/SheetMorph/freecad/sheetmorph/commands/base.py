# SPDX-License-Identifier: LGPL-2.1-or-later
"""The common base of all commands: resources, a fast and safe IsActive, error reports."""

import FreeCAD as App
import FreeCADGui as Gui

from freecad.sheetmorph import actions, paths
from freecad.sheetmorph.bridge import kernel


class Command:
    """A command; subclasses define the texts, `possible` and `execute`."""

    name = ""
    text = ""
    tooltip = ""
    alters = True
    needs_kernel = True
    registered: dict[str, "Command"] = {}
    _kernel_works: bool | None = None

    def GetResources(self) -> dict:
        """Return texts and icon; the icon has the name of the command."""
        return {
            "Pixmap": paths.icon(self.name.split("_", 1)[1]),
            "MenuText": self.text,
            "ToolTip": self.tooltip,
            "StatusTip": self.tooltip,
            # FreeCAD opens an address, and searches its wiki for any other text.
            "WhatsThis": paths.manual_of(self.name) or self.tooltip,
            "CmdType": "AlterDoc" if self.alters else "ForEdit",
        }

    def IsActive(self) -> bool:
        """Return whether the command is available; FreeCAD calls this often, so it never raises."""
        try:
            return not is_panel_open() and self.is_sensible()
        except (AttributeError, RuntimeError, ReferenceError):
            return False

    def is_sensible(self) -> bool:
        """Return whether kernel and document allow the command, whatever panel is open."""
        return (not self.needs_kernel or Command.kernel_works()) and bool(self.possible())

    @staticmethod
    def kernel_works() -> bool:
        """Return whether the kernel works; it is tested once, and a repair needs a restart."""
        if Command._kernel_works is None:
            Command._kernel_works = kernel.is_available()
        return Command._kernel_works

    def Activated(self, _index: int = 0) -> None:
        """Run the command after closing the guide's panel."""
        from freecad.sheetmorph.panels.guide import Guide

        Guide.make_room(self._run)

    def _run(self) -> None:
        """Execute the command and report every error, even an unexpected one."""
        try:
            self.execute()
        except Exception as error:
            actions.tell(self.text, error)

    def possible(self) -> bool:
        """Return whether the command makes sense now."""
        return App.ActiveDocument is not None

    def execute(self) -> None:
        """Perform the command."""
        raise TypeError(f"{self.name} has nothing to execute")


def is_panel_open() -> bool:
    """Return whether a panel other than the guide's is open."""
    if not Gui.Control.activeDialog():
        return False
    from freecad.sheetmorph.panels.guide import Guide

    return not Guide.is_shown()

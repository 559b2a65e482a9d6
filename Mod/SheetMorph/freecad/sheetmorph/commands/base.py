# SPDX-License-Identifier: LGPL-2.1-or-later
"""What all commands share: resources, a cheap and safe IsActive, errors told to the user."""

import FreeCAD as App
import FreeCADGui as Gui

from freecad.sheetmorph import actions, paths
from freecad.sheetmorph.bridge import kernel


class Command:
    """A command; subclasses give the texts, ``possible`` and ``execute``."""

    name = ""
    text = ""
    tooltip = ""
    alters = True
    needs_kernel = True
    registered: dict[str, "Command"] = {}
    _kernel_works: bool | None = None

    def GetResources(self) -> dict:
        """Texts and icon; the icon carries the command's name."""
        return {
            "Pixmap": paths.icon(self.name.split("_", 1)[1]),
            "MenuText": self.text,
            "ToolTip": self.tooltip,
            "StatusTip": self.tooltip,
            "WhatsThis": self.tooltip,
            "CmdType": "AlterDoc" if self.alters else "ForEdit",
        }

    def IsActive(self) -> bool:
        """Asked all the time: never raises."""
        try:
            return not is_panel_open() and self.is_sensible()
        except (AttributeError, RuntimeError, ReferenceError):
            return False

    def is_sensible(self) -> bool:
        """Whether the kernel and the document allow it, whatever panel is open."""
        return (not self.needs_kernel or Command.kernel_works()) and bool(self.possible())

    @staticmethod
    def kernel_works() -> bool:
        """Whether the kernel can be used; asked once, a restart is needed to mend it."""
        if Command._kernel_works is None:
            Command._kernel_works = kernel.is_available()
        return Command._kernel_works

    def Activated(self, _index: int = 0) -> None:
        """Runs the command, after the guide's panel gave way."""
        from freecad.sheetmorph.panels.guide import Guide

        Guide.make_room(self._run)

    def _run(self) -> None:
        """Reports every error, an unforeseen one, too."""
        try:
            self.execute()
        except Exception as error:
            actions.tell(self.text, error)

    def possible(self) -> bool:
        """Whether the command makes sense now."""
        return App.ActiveDocument is not None

    def execute(self) -> None:
        """What the command does."""
        raise TypeError(f"{self.name} has nothing to execute")


def is_panel_open() -> bool:
    """Whether a panel is open that does not give way to others, as the guide's does."""
    if not Gui.Control.activeDialog():
        return False
    from freecad.sheetmorph.panels.guide import Guide

    return not Guide.is_shown()

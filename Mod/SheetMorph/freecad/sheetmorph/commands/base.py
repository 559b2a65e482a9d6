# SPDX-License-Identifier: LGPL-2.1-or-later
"""A command: a row of the table, with the methods that FreeCAD calls."""

from __future__ import annotations

import importlib
import re
from collections.abc import Callable
from dataclasses import dataclass, field
from functools import cache
from typing import Any

import FreeCADGui as Gui

from freecad.sheetmorph import actions, paths
from freecad.sheetmorph.bridge import kernel
from freecad.sheetmorph.commands.hint import Hint
from freecad.sheetmorph.commands.needs import NOTHING, Need
from freecad.sheetmorph.qt import translate
from freecad.sheetmorph.tools.marked import QT_TRANSLATE_NOOP

CLOSE = QT_TRANSLATE_NOOP("SheetMorph_needs", "Close the open panel first.")
NO_KERNEL = QT_TRANSLATE_NOOP(
    "SheetMorph_needs", "The kernel does not work: see Check Installation."
)
MNEMONIC = re.compile(r"\(&\w\)|&")  # Japanese texts append the letter in brackets


class Panel:
    """Opens a panel; its module is imported at the first call, because it imports numpy and Coin.

    `function` has the form "module.function"; `extra` arguments follow the target.
    """

    def __init__(self, function: str, *extra: str):
        self.module, _, self.function = function.rpartition(".")
        self.extra = extra

    def __call__(self, *target) -> None:
        module = importlib.import_module(f"freecad.sheetmorph.panels.{self.module}")
        getattr(module, self.function)(*target, *self.extra)


class Step:
    """Runs API calls as one undo step; `lines` returns their texts for a target."""

    def __init__(self, lines: Callable[[Any], list[str]]):
        self.lines = lines


@dataclass
class Command:
    """A row of the table of commands.

    `act` gets the object that `need` finds; without a need it gets no argument. `keys` is a
    shortcut. `on` lists the objects in whose context menu the command appears, see `sorts`. Without
    a `picture` the icon has the name of the command.
    """

    name: str
    text: str
    tooltip: str
    need: Need
    act: Callable | Step
    keys: str = ""
    on: tuple[str, ...] = ()
    alters: bool = True
    needs_kernel: bool = True
    picture: str = ""
    _hint: Hint = field(init=False, repr=False)

    def __post_init__(self):
        self._hint = Hint(self.name)

    @property
    def title(self) -> str:
        """The English text without mnemonic and dots, as the name of an undo step."""
        return MNEMONIC.sub("", self.text).rstrip("…")

    @property
    def label(self) -> str:
        """The text in the user's language without a mnemonic."""
        return MNEMONIC.sub("", translate(self.name, self.text))

    @property
    def icon(self) -> str:
        """The path of the icon."""
        return paths.icon(self.picture or self.name.split("_", 1)[1])

    def GetResources(self) -> dict:
        """Return texts, shortcut and icon."""
        return {
            "Pixmap": self.icon,
            "MenuText": self.text,
            "ToolTip": self.tooltip,
            "StatusTip": self.tooltip,
            # FreeCAD opens an address, and searches its wiki for any other text.
            "WhatsThis": paths.manual_of(self.name) or self.tooltip,
            "Accel": self.keys,
            "CmdType": "AlterDoc" if self.alters else "ForEdit",
        }

    def IsActive(self) -> bool:
        """Return whether the command is available; FreeCAD calls this often, so it never raises."""
        try:
            lacking = CLOSE if is_panel_open() else self.lacks()
            self._hint.show(lacking)
        except (AttributeError, RuntimeError, ReferenceError):
            return False
        return not lacking

    def lacks(self) -> str:
        """Return what the user must do first, whatever panel is open; empty for nothing."""
        if self.needs_kernel and not kernel_works():
            return NO_KERNEL
        return self.need.lacks()

    def Activated(self, _index: int = 0) -> None:
        """Run the command after closing the guide's panel."""
        from freecad.sheetmorph.panels.guide import Guide

        Guide.make_room(self._run)

    def _run(self) -> None:
        """Execute the command and report every error, even an unexpected one."""
        try:
            self.execute()
        except Exception as error:
            actions.tell(self.title, error)

    def execute(self) -> None:
        """Perform the command on its target."""
        target = () if self.need is NOTHING else (self.need.find(),)
        if isinstance(self.act, Step):
            actions.attempt(self.title, *self.act.lines(*target))
        else:
            self.act(*target)


@cache
def kernel_works() -> bool:
    """Return whether the kernel works; it is tested once, and a repair needs a restart."""
    return kernel.is_available()


REGISTERED: dict[str, Command] = {}
"""All commands by name, as soon as FreeCAD has them."""


def is_panel_open() -> bool:
    """Return whether a panel other than the guide's is open."""
    if not Gui.Control.activeDialog():
        return False
    from freecad.sheetmorph.panels.guide import Guide

    return not Guide.is_shown()

# SPDX-License-Identifier: LGPL-2.1-or-later
"""The commands of the workbench, registered in FreeCAD, for menus, toolbars and other callers."""

import FreeCADGui as Gui

from freecad.sheetmorph.commands.base import REGISTERED, Command
from freecad.sheetmorph.commands.table import COMMANDS, EMPTY, FIRST, MENU, SOURCE, TOOLBARS, names
from freecad.sheetmorph.kinds import REGION, kind


def registered() -> dict[str, Command]:
    """Return all commands by name; the first call registers them in FreeCAD."""
    for command in COMMANDS if not REGISTERED else ():
        REGISTERED[command.name] = command
        Gui.addCommand(command.name, command)
    return REGISTERED


def menu() -> dict[str, list[str]]:
    """Return the names of the commands by submenu; those of "" are in the menu itself."""
    return {title: names(row) for title, row in MENU.items()}


def toolbars() -> dict[str, list[str]]:
    """Return the names of the commands by toolbar."""
    return {title: names(row) for title, row in TOOLBARS.items()}


def sorts(obj) -> set[str]:
    """Return the words by which commands name an object: its kind, and the role of a region."""
    found = kind(obj)
    if found == REGION:
        return {REGION, obj.Role}
    is_source = obj.isDerivedFrom("Mesh::Feature") or obj.isDerivedFrom("Part::Feature")
    return {found or (SOURCE if is_source else "")}


def suiting(objects: list) -> list[str]:
    """Return the names for the context menu of selected objects, which may be none.

    They are the available commands that suit, with a separator after each submenu's.
    """
    wanted = set().union(*map(sorts, objects)) if objects else {EMPTY}
    every, found = registered(), []
    for title in (*FIRST, *(title for title in MENU if title not in FIRST)):
        suits = [every[name] for name in names(MENU[title]) if name in every]
        suits = [one for one in suits if wanted.intersection(one.on) and one.IsActive()]
        found += [*(one.name for one in suits), "Separator"] if suits else []
    return found


def run(name: str, obj) -> None:
    """Select an object, and run a command on it if it is available."""
    if Gui.Selection.getSelection() != [obj]:
        Gui.Selection.clearSelection()
        Gui.Selection.addSelection(obj)
    Gui.runCommand(registered()[name].name)

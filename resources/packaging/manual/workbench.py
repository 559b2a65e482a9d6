# SPDX-License-Identifier: LGPL-2.1-or-later
"""The commands of the workbench as Markdown, read from their sources without FreeCAD."""
import ast
import re
from collections.abc import Iterator
from dataclasses import dataclass
from functools import cache
from html import escape
from pathlib import Path
from typing import Any

FOLDER = Path(__file__).resolve().parents[3] / "Mod/SheetMorph/freecad/sheetmorph/commands"
SCRIPTING = Path(__file__).resolve().parents[3] / "resources" / "docs" / "scripting.md"
ROW = re.compile(r"^\| `(SheetMorph_\w+)` \|[^|]*\| (.*) \|$", re.MULTILINE)
# The section of a page that shows how to use a command, by its submenu or by its name.
SHOWN = {
    "Parts": "tutorials/first-drag.html",
    "FollowShape": "user-guide.html#from-mesh-back-to-cad",
    "ReplaceFile": "user-guide.html#picking",
    "PrepareMesh": "user-guide.html#preparing-meshes",
    "ThicknessMap": "user-guide.html#thin-solids",
    "SetPrimary": "user-guide.html#contacts",
    "Regions": "user-guide.html#picking",
    "FindFeatures": "user-guide.html#find-features-and-contacts",
    "Features": "user-guide.html#form-features",
    "Contacts": "user-guide.html#contacts",
    "FindContacts": "user-guide.html#find-features-and-contacts",
    "Motion": "user-guide.html#moving-a-handle",
    "SavePose": "user-guide.html#poses",
    "ApplyPose": "user-guide.html#poses",
    "BlendPoses": "user-guide.html#poses",
    "CopyInPose": "user-guide.html#poses",
    "CopyAsMeshes": "user-guide.html#poses",
    "Study": "user-guide.html#studies",
    "Exchange": "how-to/export.html",
    "DeformedShape": "user-guide.html#from-mesh-back-to-cad",
    "Flatten": "user-guide.html#steel",
    "Guide": "user-guide.html#the-guide",
    "Manual": "user-guide.html#help-preferences-and-languages",
    "CheckInstallation": "how-to/install.html",
}


@dataclass
class Command:
    """What the sources say about a command."""

    name: str
    text: str  # in the menu
    tooltip: str
    place: str  # the menu, the shortcut, and what is needed first: sentences
    shown: str  # the address of the page that shows how to use it


def all_commands() -> list[Command]:
    """Return the commands of the workbench, in the order of their table."""
    table = ast.parse((FOLDER / "table.py").read_text("utf-8"))
    menu = _menu(table)
    return [_command(node, menu) for node in _calls(table, "Command")]


def commands() -> str:
    """Return a section for each command: its menu text, its tooltip, when it is available."""
    lines = []
    for command in all_commands():
        lines += [f"## {command.text}", "", f"`{command.name}`: {command.tooltip}.", ""]
        lines += [command.place, ""]
    return "\n".join(lines)


def command_pages() -> Iterator[tuple[str, dict[str, str], str]]:
    """Yield a page for each command, as Sphinx collects them: name, context, template.

    FreeCAD opens the page of a command that the user clicks on in the mode "What's This?".
    """
    calls = dict(ROW.findall(SCRIPTING.read_text("utf-8")))
    for command in all_commands():
        body = [f"<h1>{escape(command.text)}</h1>", f"<p>{escape(command.tooltip)}.</p>"]
        body += [f"<p>{escape(command.place.replace('*', ''))}</p>"]
        body += [f'<p><a href="../{command.shown}">How to use it</a></p>']
        called = re.sub(r"`(\w+)`", r"<code>\1</code>", calls[command.name])
        if called != "nothing":
            macros = '<a href="../scripting.html">Calls in a macro</a>'
            body += [f"<p>{macros}: {called}</p>"]
        body += ['<p><a href="../reference/commands.html">All commands</a></p>']
        context = {"title": escape(command.text), "body": "\n".join(body)}
        yield f"command/{command.name}", context, "page.html"


def _command(node: ast.Call, menu: dict[str, str]) -> Command:
    name, text, tooltip, need = map(_text, node.args[:4])
    short = name.removeprefix("SheetMorph_")
    keys = [_text(entry.value) for entry in node.keywords if entry.arg == "keys"]
    said = [f"Menu: *{' ▸ '.join(filter(None, ('SheetMorph', menu[short])))}*."]
    said += [f"Shortcut: {key}." for key in keys]
    said += [f"If it is disabled: {words}" for words in [_needs()[need]] if words]
    shown = SHOWN.get(short, SHOWN.get(menu[short], "user-guide.html"))
    return Command(name, text.replace("&", ""), tooltip, " ".join(said), shown)


@cache
def _needs() -> dict[str, str]:
    """Return by the name of a need what the user must do first."""
    tree = ast.parse((FOLDER / "needs.py").read_text("utf-8"))
    found: dict[str, str] = {}
    for node in tree.body:
        if isinstance(node, ast.Assign) and isinstance(node.value, ast.Call):
            words = node.value.args[0]
            shared = isinstance(words, ast.Attribute) and isinstance(words.value, ast.Name)
            name = node.targets[0]
            assert isinstance(name, ast.Name)
            found[name.id] = found[words.value.id] if shared else _text(words)
    return found


def _menu(table: ast.Module) -> dict[str, str]:
    """Return the submenu of each command, both without prefix and mnemonic."""
    (rows,) = [
        node.value
        for node in table.body
        if isinstance(node, ast.Assign) and ast.unparse(node.targets[0]) == "MENU"
    ]
    assert isinstance(rows, ast.Dict)
    return {
        name: _text(title).replace("&", "")
        for title, row in zip(rows.keys, rows.values)
        for name in _text(row).replace("|", "").split()
        if title is not None
    }


def _calls(tree: ast.Module, name: str) -> list[ast.Call]:
    """Return the calls of a function, in their order."""
    calls = [node for node in ast.walk(tree) if isinstance(node, ast.Call)]
    found = [call for call in calls if isinstance(call.func, ast.Name) and call.func.id == name]
    return sorted(found, key=lambda call: call.lineno)


def _text(value: ast.expr | None) -> str:
    """The text of a constant, of the last argument of QT_TRANSLATE_NOOP, or of an attribute."""
    if isinstance(value, ast.Call) and value.args:
        value = value.args[-1]
    if isinstance(value, ast.Attribute):
        return value.attr
    found: Any = value.value if isinstance(value, ast.Constant) else ""
    return found if isinstance(found, str) else ""

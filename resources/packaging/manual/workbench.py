# SPDX-License-Identifier: LGPL-2.1-or-later
"""The commands of the workbench as Markdown, read from their sources without FreeCAD."""
import ast
import re
from collections.abc import Iterator
from dataclasses import dataclass
from html import escape
from pathlib import Path
from typing import Any

COMMANDS = (
    Path(__file__).resolve().parents[3]
    / "Mod/SheetMorph/freecad/sheetmorph/commands"  # each class with a name is a command
)
SCRIPTING = Path(__file__).resolve().parents[3] / "resources" / "docs" / "scripting.md"
ROW = re.compile(r"^\| `(SheetMorph_\w+)` \|[^|]*\| (.*) \|$", re.MULTILINE)
# The section of a page that shows how to use a command, or all commands of a source.
SHOWN = {
    "guide": "user-guide.html#the-guide",
    "create": "tutorials/first-drag.html",
    "SheetMorph_FollowShape": "user-guide.html#from-mesh-back-to-cad",
    "SheetMorph_ReplaceFile": "user-guide.html#picking",
    "regions": "user-guide.html#picking",
    "finding": "user-guide.html#find-features-and-contacts",
    "contacts": "user-guide.html#contacts",
    "features": "user-guide.html#form-features",
    "motion": "user-guide.html#moving-a-handle",
    "poses": "user-guide.html#poses",
    "study": "user-guide.html#studies",
    "SheetMorph_PrepareMesh": "user-guide.html#preparing-meshes",
    "SheetMorph_ThicknessMap": "user-guide.html#thin-solids",
    "SheetMorph_Flatten": "user-guide.html#steel",
    "SheetMorph_DeformedShape": "user-guide.html#from-mesh-back-to-cad",
    "exchange": "how-to/export.html",
    "installation": "how-to/install.html",
    "manual": "user-guide.html#help-preferences-and-languages",
}


@dataclass
class Command:
    """What the sources say about a command."""

    name: str
    text: str  # in the menu
    tooltip: str
    available: str  # a sentence, may be empty
    shown: str  # the address of the page that shows how to use it


def all_commands() -> list[Command]:
    """Return the commands of the workbench, in the order of their sources."""
    found = []
    for path in sorted(COMMANDS.glob("*.py")):
        tree = ast.parse(path.read_text("utf-8"))
        classes = [node for node in tree.body if isinstance(node, ast.ClassDef)]
        found += [_command(node, path.stem) for node in classes]
    return [command for command in found if command.name]


def commands() -> str:
    """Return a section for each command: its menu text, its tooltip, when it is available."""
    lines = []
    for command in all_commands():
        lines += [f"## {command.text}", "", f"`{command.name}`: {command.tooltip}.", ""]
        lines += [command.available, ""] if command.available else []
    return "\n".join(lines)


def command_pages() -> Iterator[tuple[str, dict[str, str], str]]:
    """Yield a page for each command, as Sphinx collects them: name, context, template.

    FreeCAD opens the page of a command that the user clicks on in the mode "What's This?".
    """
    calls = dict(ROW.findall(SCRIPTING.read_text("utf-8")))
    for command in all_commands():
        said = [f"{command.tooltip}.", command.available]
        body = [f"<h1>{escape(command.text)}</h1>"]
        body += [f"<p>{escape(sentence)}</p>" for sentence in said if sentence]
        body += [f'<p><a href="../{command.shown}">How to use it</a></p>']
        called = re.sub(r"`(\w+)`", r"<code>\1</code>", calls[command.name])
        if called != "nothing":
            macros = '<a href="../scripting.html">Calls in a macro</a>'
            body += [f"<p>{macros}: {called}</p>"]
        body += ['<p><a href="../reference/commands.html">All commands</a></p>']
        context = {"title": escape(command.text), "body": "\n".join(body)}
        yield f"command/{command.name}", context, "page.html"


def _command(node: ast.ClassDef, source: str) -> Command:
    said = {
        entry.targets[0].id: _text(entry.value)
        for entry in node.body
        if isinstance(entry, ast.Assign) and isinstance(entry.targets[0], ast.Name)
    }
    name, text, tooltip = (said.get(key, "") for key in ("name", "text", "tooltip"))
    shown = SHOWN.get(name, SHOWN.get(source, "user-guide.html"))
    return Command(name, text, tooltip, _available(node), shown)


def _available(command: ast.ClassDef) -> str:
    """When a command is available, from the docstring of its `possible`: "Return whether ..."."""
    for entry in command.body:
        if isinstance(entry, ast.FunctionDef) and entry.name == "possible":
            said = (ast.get_docstring(entry) or "").split("\n\n")[0].replace("\n", " ")
            condition = said.removeprefix("Return whether ")
            return f"Available if {condition}" if condition != said else "Always available."
    return ""


def _text(value: ast.expr) -> str:
    """The text of a constant, or of the last argument of QT_TRANSLATE_NOOP."""
    if isinstance(value, ast.Call) and value.args:
        value = value.args[-1]
    found: Any = value.value if isinstance(value, ast.Constant) else ""
    return found if isinstance(found, str) else ""

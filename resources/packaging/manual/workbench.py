# SPDX-License-Identifier: LGPL-2.1-or-later
"""The commands of the workbench as Markdown, read from their sources without FreeCAD."""
import ast
from collections.abc import Iterator
from dataclasses import dataclass
from html import escape
from pathlib import Path
from typing import Any

COMMANDS = (
    Path(__file__).resolve().parents[3]
    / "Mod/SheetMorph/freecad/sheetmorph/commands"  # each class with a name is a command
)
SEE_ALSO = (
    ("../user-guide.html", "The workbench: how to use the commands"),
    ("../reference/commands.html", "All commands"),
    ("../scripting.html#from-the-menu-to-the-call", "The calls of the commands in macros"),
)


@dataclass
class Command:
    """What the sources say about a command."""

    name: str
    text: str  # in the menu
    tooltip: str
    available: str  # a sentence, may be empty


def all_commands() -> list[Command]:
    """Return the commands of the workbench, in the order of their sources."""
    found = []
    for path in sorted(COMMANDS.glob("*.py")):
        tree = ast.parse(path.read_text("utf-8"))
        found += [_command(node) for node in tree.body if isinstance(node, ast.ClassDef)]
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
    for command in all_commands():
        said = [f"{command.tooltip}.", command.available]
        body = [f"<h1>{escape(command.text)}</h1>"]
        body += [f"<p>{escape(sentence)}</p>" for sentence in said if sentence]
        body += [f'<p><a href="{address}">{words}</a></p>' for address, words in SEE_ALSO]
        context = {"title": escape(command.text), "body": "\n".join(body)}
        yield f"command/{command.name}", context, "page.html"


def _command(node: ast.ClassDef) -> Command:
    said = {
        entry.targets[0].id: _text(entry.value)
        for entry in node.body
        if isinstance(entry, ast.Assign) and isinstance(entry.targets[0], ast.Name)
    }
    available = ""
    for entry in node.body:
        if isinstance(entry, ast.FunctionDef) and entry.name == "possible":
            condition = (ast.get_docstring(entry) or "").split("\n\n")[0].replace("\n", " ")
            available = f"Available: {condition[:1].lower()}{condition[1:]}"
    values = (said.get(key, "") for key in ("name", "text", "tooltip"))
    return Command(*values, available)


def _text(value: ast.expr) -> str:
    """The text of a constant, or of the last argument of QT_TRANSLATE_NOOP."""
    if isinstance(value, ast.Call) and value.args:
        value = value.args[-1]
    found: Any = value.value if isinstance(value, ast.Constant) else ""
    return found if isinstance(found, str) else ""

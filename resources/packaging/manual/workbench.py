# SPDX-License-Identifier: LGPL-2.1-or-later
"""The commands of the workbench as Markdown, read from their sources without FreeCAD."""
import ast
from pathlib import Path
from typing import Any

COMMANDS = (
    Path(__file__).resolve().parents[3]
    / "Mod/SheetMorph/freecad/sheetmorph/commands"  # each class with a name is a command
)


def commands() -> str:
    """Return a section for each command: its menu text, its tooltip, when it is available."""
    lines = []
    for path in sorted(COMMANDS.glob("*.py")):
        tree = ast.parse(path.read_text("utf-8"))
        for node in tree.body:
            if isinstance(node, ast.ClassDef):
                lines += _section(node)
    return "\n".join(lines)


def _section(command: ast.ClassDef) -> list[str]:
    said = {
        entry.targets[0].id: _text(entry.value)
        for entry in command.body
        if isinstance(entry, ast.Assign) and isinstance(entry.targets[0], ast.Name)
    }
    if not said.get("name"):
        return []
    lines = [f"## {said['text']}", "", f"`{said['name']}`: {said.get('tooltip', '')}.", ""]
    for entry in command.body:
        if isinstance(entry, ast.FunctionDef) and entry.name == "possible":
            condition = (ast.get_docstring(entry) or "").split("\n\n")[0].replace("\n", " ")
            lines += [f"Available: {condition[:1].lower()}{condition[1:]}", ""]
    return lines


def _text(value: ast.expr) -> str:
    """The text of a constant, or of the last argument of QT_TRANSLATE_NOOP."""
    if isinstance(value, ast.Call) and value.args:
        value = value.args[-1]
    found: Any = value.value if isinstance(value, ast.Constant) else ""
    return found if isinstance(found, str) else ""

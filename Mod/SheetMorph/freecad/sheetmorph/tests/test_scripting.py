# SPDX-License-Identifier: LGPL-2.1-or-later
"""The examples of the scripting guide run, say what they claim, and leave no call out."""

import ast
import re
import shutil
import unittest
from pathlib import Path

import FreeCAD

from freecad.sheetmorph import api

BLOCK = re.compile(r"^```python\n(.*?)^```$", re.MULTILINE | re.DOTALL)
VALUE = re.compile(r"# -> (.*)$")


def guide() -> Path | None:
    """Return the scripting guide, of the installed add-on or of a working copy; None if none."""
    for folder in Path(__file__).absolute().parents:
        found = folder / "resources" / "docs" / "scripting.md"
        if found.is_file():
            return found
    return None


def run_example(source: str, namespace: dict) -> list[tuple[str, str, str]]:
    """Run one example; return line, claimed value and found value where a value is claimed."""
    checked = []
    lines = source.splitlines()
    for statement in ast.parse(source).body:
        claim = VALUE.search(lines[statement.end_lineno - 1])
        if claim and isinstance(statement, ast.Expr):
            code = compile(ast.Expression(statement.value), "scripting.md", "eval")
            found = str(eval(code, namespace))
            checked.append((lines[statement.lineno - 1], claim.group(1), found))
        else:
            code = compile(ast.Module([statement], []), "scripting.md", "exec")
            exec(code, namespace)
    return checked


def commands_of_the_workbench() -> dict[str, str]:
    """Return the menu texts of all commands by name, from the source: they need a window."""
    table = Path(__file__).absolute().parent.parent / "commands" / "table.py"
    calls = [node for node in ast.walk(ast.parse(table.read_text("utf-8"))) if is_command(node)]
    return {call.args[0].value: call.args[1].value.replace("&", "") for call in calls}


def is_command(node: ast.AST) -> bool:
    """Return whether a node of a source is a row of the table of commands."""
    return isinstance(node, ast.Call) and getattr(node.func, "id", "") == "Command"


class TestGuide(unittest.TestCase):
    def setUp(self):
        path = guide()
        if path is None:
            self.skipTest("The scripting guide is not installed beside the add-on.")
        self.text = path.read_text(encoding="utf-8")
        self.blocks = BLOCK.findall(self.text)

    def test_all_examples_run_and_say_what_they_claim(self):
        namespace: dict = {"__name__": "example"}
        claims = 0
        try:
            for block in self.blocks:
                for line, claimed, found in run_example(block, namespace):
                    self.assertEqual(found, claimed, line)
                    claims += 1
        finally:
            shutil.rmtree(namespace.get("folder", ""), ignore_errors=True)
            for name in ("Scripting", "Imported"):
                if name in FreeCAD.listDocuments():
                    FreeCAD.closeDocument(name)
        self.assertGreater(claims, len(api.__all__))

    def test_every_call_has_a_heading_and_an_example(self):
        code = "\n".join(self.blocks)
        for name in api.__all__:
            with self.subTest(name):
                self.assertTrue(f"\n### `{name}(" in self.text, "no heading in the guide")
                self.assertRegex(code, rf"\bapi\.{name}\(")

    def test_every_command_is_in_the_table_and_calls_what_exists(self):
        rows = dict(re.findall(r"^\| `(SheetMorph_\w+)` \|.*?\| (.*) \|$", self.text, re.MULTILINE))
        self.assertEqual(set(rows), set(commands_of_the_workbench()))
        for command, calls in rows.items():
            for name in re.findall(r"`(\w+)`", calls):
                with self.subTest(command):
                    self.assertIn(name, api.__all__)

    def test_every_command_has_its_menu_text_in_the_table(self):
        for command, text in commands_of_the_workbench().items():
            with self.subTest(command):
                self.assertIn(f"| `{command}` | {text} |", self.text)

    def test_every_call_has_a_docstring(self):
        for name in api.__all__:
            with self.subTest(name):
                self.assertGreater(len(getattr(api, name).__doc__ or ""), 40)


if __name__ == "__main__":
    unittest.main()

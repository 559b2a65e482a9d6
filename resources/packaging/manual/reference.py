# SPDX-License-Identifier: LGPL-2.1-or-later
"""Reference pages as Markdown, made from the command line's parser and the JSON schemas."""
import argparse
import json
import sys
from collections.abc import Callable
from functools import partial
from pathlib import Path
from typing import Any
from unittest import mock

import workbench

PACKAGE = Path(__file__).resolve().parents[3] / "bindings" / "python" / "sheetmorph"
LIMITS = {
    "minimum": "at least {:g}",
    "exclusiveMinimum": "more than {:g}",
    "maximum": "at most {:g}",
    "minItems": "at least {} entries",
    "maxItems": "at most {} entries",
}


def command_line() -> str:
    """Return a section for each command: usage, arguments and options."""
    from sheetmorph.cli import parser

    with mock.patch.object(sys, "argv", ["sheetmorph"]), mock.patch.dict(
        "os.environ", {"COLUMNS": "80", "NO_COLOR": "1"}
    ):
        whole = parser()
        (commands,) = [a for a in whole._actions if isinstance(a, argparse._SubParsersAction)]
        said = {entry.dest: entry.help or "" for entry in commands._choices_actions}
        parts = [_command(name, said[name], one) for name, one in commands.choices.items()]
    return "\n".join([*parts, "## Exit status", "", whole.epilog or "", ""])


def _command(name: str, said: str, parser: argparse.ArgumentParser) -> str:
    rows = [
        f"| {_invocation(action)} | {_cell(_help(action, parser))} |"
        for action in parser._actions
        if action.dest != "help"
    ]
    usage = parser.format_usage().strip()
    head = ["| argument | meaning |", "|---|---|"] if rows else []
    example = (parser.epilog or "").removeprefix("Example: ") % {"prog": parser.prog}
    lines = [f"## `{name}`", "", _sentence(said), "", "```text", usage, "```", ""]
    return "\n".join([*lines, f"Example: `{example}`", "", *head, *rows, ""])


def _invocation(action: argparse.Action) -> str:
    value = action.metavar or ("" if action.nargs == 0 else action.dest)
    if action.choices and not action.metavar:
        value = "{" + ",".join(map(str, action.choices)) + "}"
    if isinstance(value, tuple):
        value = " ".join(value)
    if not action.option_strings:
        return f"`{value}`"
    value = f"[{value}]" if action.nargs == "?" else value
    return ", ".join(f"`{name} {value}`".replace(" `", "`") for name in action.option_strings)


def _help(action: argparse.Action, parser: argparse.ArgumentParser) -> str:
    return parser._get_formatter()._expand_help(action) if action.help else ""


def schema_page(name: str, of_all: str) -> str:
    """Return a table of the keys of a format, and one for each kind of entry in it.

    `of_all` is the heading of the first table.
    """
    (path,) = PACKAGE.rglob(f"{name}.schema.json")
    schema: dict[str, Any] = json.loads(path.read_text("utf-8"))
    kinds = Kinds(schema.get("$defs", {}))
    first = kinds.table(schema, "")
    sections = {}
    while kinds.met:
        kind, entry = kinds.met.popitem()
        said = _sentence(entry.get("description", ""))
        sections[kind] = "\n".join([f"## `{kind}`", "", said, "", kinds.table(entry, kind)])
    return "\n".join([f"## {of_all}", "", first, *(sections[kind] for kind in sorted(sections))])


class Kinds:
    """Writes the values of a schema in words, and collects the objects that get their own table."""

    def __init__(self, defined: dict[str, Any]):
        self.met: dict[str, dict[str, Any]] = {}  # objects without a table so far
        self._known: set[str] = set()
        self._defined = defined

    def table(self, entry: dict[str, Any], kind: str) -> str:
        """Return the keys of an object as a table: key, value, meaning."""
        needed = entry.get("required", [])
        rows = ["| key | value | meaning |", "|---|---|---|"]
        for key, value in entry.get("properties", {}).items():
            mark = " (needed)" if key in needed else ""
            said = self._value(value, f"{kind}.{key}".lstrip("."))
            rows.append(f"| `{key}`{mark} | {said} | {_sentence(self._meaning(value))} |")
        return "\n".join([*rows, ""])

    def _meaning(self, value: dict[str, Any]) -> str:
        kind = value.get("$ref", "").rsplit("/", 1)[-1]
        return str(value.get("description") or self._defined.get(kind, {}).get("description", ""))

    def _value(self, value: dict[str, Any], kind: str) -> str:
        """The values that a key takes, in words; an object is a link to its table."""
        if "$ref" in value:
            kind = value["$ref"].rsplit("/", 1)[-1]
            return self._value(_body(self._defined[kind]), kind)
        if "const" in value:
            return f"`{json.dumps(value['const'])}`"
        if "enum" in value:
            return ", ".join(f"`{json.dumps(one)}`" for one in value["enum"])
        if "properties" in value:
            return self._link(value, kind)
        branches = [value[name] for name in ("then", "else") if name in value and "if" in value]
        branches = value.get("anyOf", value.get("oneOf", branches))
        if branches:
            return " or ".join(dict.fromkeys(self._value(one, kind) for one in branches))
        if isinstance(value.get("items"), dict):
            return f"list of {self._value(value['items'], kind)}"
        if isinstance(value.get("additionalProperties"), dict):
            return f"object of {self._value(value['additionalProperties'], kind)}"
        return _plain(value)

    def _link(self, entry: dict[str, Any], kind: str) -> str:
        """A link to the table of an object; the first object with a name defines it."""
        if kind not in self._known:
            self._known.add(kind)
            self.met[kind] = entry
        anchor = kind.replace(".", "").lower()  # as MyST makes it from the heading
        return f"[`{kind}`](#{anchor})"


def _body(entry: dict[str, Any]) -> dict[str, Any]:
    """The entry that lists the keys: itself, or the branch of its `if` that does."""
    for branch in ("then", "else"):
        if "properties" not in entry and entry.get("if", {}).get("type") == "object":
            return entry
        if "properties" not in entry and "properties" in entry.get(branch, {}):
            return {"description": entry.get("description", ""), **entry[branch]}
    return entry


def _plain(value: dict[str, Any]) -> str:
    found = value.get("type", "list" if "items" in value else "any")
    name = " or ".join(found) if isinstance(found, list) else str(found)
    if name == "any" and {"minItems", "maxItems"} & set(value):
        name = "list"
    limits = [words.format(value[key]) for key, words in LIMITS.items() if key in value]
    return ", ".join([name, *limits])


def _cell(text: str) -> str:
    return text.replace("|", "\\|").replace("\n", " ").replace("<", "&lt;").replace("*", "\\*")


def _sentence(text: str) -> str:
    said = _cell(text).strip()
    return said[:1].upper() + said[1:] + ("" if not said or said.endswith(".") else ".")


PAGES: dict[str, Callable[[], str]] = {
    "command line": command_line,
    "commands": workbench.commands,
    "recipe": partial(schema_page, "recipe", "The recipe"),
    "study": partial(schema_page, "study", "The study"),
    "report": partial(schema_page, "report", "The report"),
    "certificate": partial(schema_page, "certificate", "The certificate"),
    "doctor": partial(schema_page, "doctor", "The diagnosis"),
    "find": partial(schema_page, "find", "The findings"),
}

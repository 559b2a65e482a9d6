# SPDX-License-Identifier: LGPL-2.1-or-later
"""Results as text and JSON: on stdout, or in a file."""

from __future__ import annotations

import argparse
import contextlib
import json
import sys
from pathlib import Path
from typing import Any, TextIO

from ..files.atomic import FileSet
from .parsing import STDOUT


def json_file(wanted: argparse.Namespace) -> Path | None:
    """Return the file that `--json` names, or None."""
    return None if wanted.json in (None, STDOUT) else Path(wanted.json)


def as_json(found: Any) -> list[str]:
    """Return the lines of a result as JSON."""
    return json.dumps(found, indent=2, ensure_ascii=False, allow_nan=False).splitlines()


def write_text(wanted: argparse.Namespace, text: str, files: FileSet) -> Path:
    """Write a text to the file of `-o` and return its path. Raises FileError."""
    path = Path(wanted.output)
    files.reads += [Path(file) for file in wanted.files]
    with files:
        files.temporary_for(path).write_text(text, "utf-8")
        files.commit()
    return path


def one_line_each(found: dict[str, Any]) -> str:
    """Return JSON with one line for every feature and contact, for readability."""
    lines = []
    for key, value in found.items():
        rows = [json.dumps(row, ensure_ascii=False, allow_nan=False) for row in as_list(value)]
        if rows:
            lines.append(f"  {json.dumps(key)}: [\n    " + ",\n    ".join(rows) + "\n  ]")
        else:
            lines.append(f"  {json.dumps(key)}: {json.dumps(value, allow_nan=False)}")
    return "{\n" + ",\n".join(lines) + "\n}"


def as_list(value: Any) -> list[Any]:
    """Return a non-empty list of objects as it is, and an empty list for any other value."""
    return value if isinstance(value, list) and value and isinstance(value[0], dict) else []


def say(lines: list[str]) -> None:
    """Print to stdout; a closed or full stdout does not turn a success into a failure."""
    try:
        for line in lines:
            print(_printable(line, sys.stdout))
        if sys.stdout is not None:
            sys.stdout.flush()
    except (OSError, ValueError) as error:
        # What is left in the buffer would fail again at exit.
        sys.stdout = None  # type: ignore[assignment]  # as Python itself has it without a console
        if not isinstance(error, BrokenPipeError):
            complain(f"done, but stdout cannot be written ({error})")


def complain(text: str) -> None:
    """Print a line to stderr, if there is one."""
    with contextlib.suppress(OSError, ValueError):
        print(_printable(text, sys.stderr), file=sys.stderr)


def _printable(text: str, stream: TextIO | None) -> str:
    encoding = getattr(stream, "encoding", None) or "utf-8"
    return text.encode(encoding, "backslashreplace").decode(encoding)

# SPDX-License-Identifier: LGPL-2.1-or-later
"""Results as text and JSON: on stdout, or in a file."""

from __future__ import annotations

import argparse
import contextlib
import json
import sys
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any, TextIO

from ..base.errors import Fault, FileError, RecipeError
from ..files import suffixes, unpacked_name
from ..files.atomic import FileSet, require_file_place
from ..files.identity import is_one_of
from .parsing import STDOUT

DONE, BAD_INPUT, NOT_CERTIFIED = 0, 2, 3


@dataclass(frozen=True)
class Outcome:
    """What a command found: lines for a person, and the same as data for `--json`."""

    lines: list[str]
    data: Any
    status: int = DONE


def json_target(wanted: argparse.Namespace) -> Path | None:
    """Return the file of `--json` or of `--report`. Raises RecipeError if both name one."""
    named = None if wanted.json in (None, STDOUT) else wanted.json
    if named is not None and wanted.report is not None:
        what = f"--report names {wanted.report} already"
        raise RecipeError([Fault("--json", what, "leave out one of the two files")])
    chosen = wanted.report if named is None else named
    return None if chosen is None else Path(chosen)


def require_target(wanted: argparse.Namespace, inputs: Sequence[str], files: FileSet) -> None:
    """Check before any work that the file of `--json` may be written. Raises FileError."""
    target = json_target(wanted)
    if target is None:
        return
    files.reads += map(Path, inputs)
    if unpacked_name(target).suffix.lower() in suffixes():
        todo = "write --json=- for stdout, or name a file that ends in .json"
        raise FileError(target, "it has the name of a part, which --json does not write", todo)
    if getattr(wanted, "output", None) and is_one_of(target, [Path(wanted.output)]):
        raise FileError(target, "-o names it already", "name another file for --json")
    if not target.parent.is_dir():
        raise FileError(target, "its folder does not exist", "create the folder first")
    require_file_place(target)
    files.require_ours(target)


def write_target(wanted: argparse.Namespace, data: Any, read: Sequence[Path]) -> None:
    """Write the result to the file of `--json`, if there is one. Raises FileError."""
    target = json_target(wanted)
    if target is not None:
        with FileSet(wanted.command, force=wanted.force) as files:
            files.reads += read
            files.temporary_for(target).write_text("\n".join([*as_json(data), ""]), "utf-8")
            files.commit()


def as_json(found: Any) -> list[str]:
    """Return the lines of a result as JSON."""
    return json.dumps(found, indent=2, ensure_ascii=False, allow_nan=False).splitlines()


def write_text(wanted: argparse.Namespace, text: str, files: FileSet) -> Path:
    """Write a text to the file of `-o` and return its path. Raises FileError."""
    path = Path(wanted.output)
    files.reads += [Path(file) for file in getattr(wanted, "files", ())]
    with files:
        files.temporary_for(path).write_text(text, "utf-8")
        files.commit()
    return path


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

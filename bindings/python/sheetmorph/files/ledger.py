# SPDX-License-Identifier: LGPL-2.1-or-later
"""Which files the program wrote: only these may be written over without being asked to.

One line a file in the user's folder for the state of programs: its size, its time of change in
nanoseconds, what wrote it (run, find, ...) and its path. A file that somebody changed since, or
that another command wrote, is not ours to replace.
"""

from __future__ import annotations

import json
import os
import sys
from collections.abc import Iterable
from contextlib import suppress
from functools import cached_property
from pathlib import Path

# Bytes of the ledger from which its older half is forgotten.
_LARGEST = 4_000_000


class Ledger:
    """place: the file of the ledger, that of the user if None."""

    def __init__(self, place: Path | None = None) -> None:
        self._place = place or _of_user()

    def has(self, path: Path, by: str) -> bool:
        """Whether a command wrote the file, and it stayed as it was written."""
        with suppress(OSError):
            return self._lines.get(_name_of(path)) == _line_of(path, by)
        return False

    def add(self, written: Iterable[tuple[Path, str]]) -> None:
        """Record files and the command that wrote each.

        A run succeeds without a ledger; the next run then refuses to replace the files.
        """
        with suppress(OSError):
            text = "".join(_line_of(path, by) for path, by in written)
            self._place.parent.mkdir(parents=True, exist_ok=True)
            if self._place.exists() and self._place.stat().st_size > _LARGEST:
                kept = list(_read(self._place).values())
                self._place.write_text("".join(kept[len(kept) // 2 :]), "utf-8")
            # One write to the end, so that processes beside each other lose no line.
            with self._place.open("ab") as file:
                file.write(text.encode("utf-8"))
            self.__dict__.pop("_lines", None)

    @cached_property
    def _lines(self) -> dict[str, str]:
        """Read once for all files of a command."""
        return _read(self._place)


def _read(place: Path) -> dict[str, str]:
    """Return the last line of every path, by path."""
    try:
        text = place.read_text("utf-8", errors="replace")
    except FileNotFoundError:
        return {}
    return {line.split(" ", 3)[-1]: line for line in text.splitlines(keepends=True)}


def _name_of(path: Path) -> str:
    return json.dumps(str(path.parent.resolve() / path.name)) + "\n"


def _line_of(path: Path, by: str) -> str:
    found = path.stat()
    return f"{found.st_size} {found.st_mtime_ns} {by} {_name_of(path)}"


def _of_user() -> Path:
    if sys.platform == "win32":
        state = os.environ.get("LOCALAPPDATA") or "~/AppData/Local"
    elif sys.platform == "darwin":
        state = "~/Library/Application Support"
    else:
        state = os.environ.get("XDG_STATE_HOME") or "~/.local/state"
    return Path(state).expanduser() / "sheetmorph" / "written.txt"

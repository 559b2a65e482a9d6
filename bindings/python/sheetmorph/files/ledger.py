# SPDX-License-Identifier: LGPL-2.1-or-later
"""Record of the files that SheetMorph wrote, which it may overwrite without --force.

The ledger has one line for each file in the state folder of the user: size, modification time in
nanoseconds, the command (run, find, ...) and the path. A file that changed later, or that another
command wrote, must not be replaced.
"""

from __future__ import annotations

import json
import os
import sys
from collections.abc import Iterable
from contextlib import suppress
from functools import cached_property
from pathlib import Path

# Size of the ledger, bytes, above which its older half is removed.
_LARGEST = 4_000_000


class Ledger:
    """The ledger of written files, by default that of the user."""

    def __init__(self, place: Path | None = None) -> None:
        self._place = place or _of_user()

    def has(self, path: Path, by: str) -> bool:
        """Return whether the command wrote the file and nobody changed it since."""
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
            # A single append, so that concurrent processes lose no line.
            with self._place.open("ab") as file:
                file.write(text.encode("utf-8"))
            self.__dict__.pop("_lines", None)

    @cached_property
    def _lines(self) -> dict[str, str]:
        """The lines by path, read once for all files of a command."""
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

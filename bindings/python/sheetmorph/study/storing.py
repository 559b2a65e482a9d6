# SPDX-License-Identifier: LGPL-2.1-or-later
"""The folder of a study: one subfolder per variant, which appears complete or not at all.

Finished variants and files of others stay. A variant lists its own files in its `parameters.json`.
An unfinished folder belongs to the process with its lease.
"""

from __future__ import annotations

import json
import os
import re
import secrets
import shutil
from collections.abc import Iterator
from concurrent.futures import ThreadPoolExecutor
from contextlib import contextmanager, suppress
from pathlib import Path
from typing import Any

from ..base.errors import FileError, OccupiedError
from ..files.atomic import FileSet, flush, flush_folder, temporaries_of
from .leases import LOCK, Lease, is_abandoned
from .rows import FILE, Row, folder_name, read_row

_AT_ONCE = 8
_FOLDER = re.compile(r"\d{6}$")
_UNFINISHED = re.compile(r"\.\d{6}\.[0-9a-f]{8}\.tmp$")
_LEASE = re.compile(r"\.\d{6}\.[0-9a-f]{8}\.lease$")
_ASIDE = re.compile(r"\.[0-9a-f]{64}\.kept$")
_MOST_NAMES = 3


class Store:
    """The variants of a study in a folder."""

    def __init__(self, out: Path):
        self.out = out
        self._files: list[Path] = []

    def row(self, run: int, wanted: str) -> Row | None:
        """Return the row of a finished variant with this hash and all its files, or None."""
        folder = self.out / folder_name(run)
        row = read_row(folder)
        is_done = row is not None and row.hash == wanted and not _lost(folder, row)
        return row if is_done else None

    def open(self, *names: str) -> None:
        """Create the folder. Raises FileError.

        names are files that the call will write. If one exists in a folder without the lock of a
        study, it belongs to somebody else and OccupiedError is raised.
        """
        try:
            self.out.mkdir(parents=True, exist_ok=True)
        except OSError as error:
            todo = "choose another folder with -o"
            raise FileError(self.out, f"is not a folder ({error.strerror})", todo) from None
        self._files = [self.out / name for name in names]
        if not (self.out / LOCK).exists():
            for file in self._files:
                if file.exists():
                    raise OccupiedError(file)

    def tidy(self, wanted: list[str]) -> None:
        """Remove unfinished variants and move finished ones to their runs, before a study
        continues.

        wanted has the hash of every variant by run. Raises FileError if a foreign file is in the
        way.
        """
        self.sweep()
        stale = []
        for path in self._matching(_FOLDER):
            row, run = read_row(path), int(path.name)
            is_wanted = row is not None and run < len(wanted) and wanted[run] == row.hash
            if row is None or not is_wanted or _lost(path, row):
                _require_own(path, row)
                stale.append((path, row))
        for path, row in stale:
            if row is None:  # empty
                path.rmdir()
            elif _lost(path, row):
                shutil.rmtree(path)
            else:
                self._put_aside(path, row.hash)
        self._fetch(wanted)

    def sweep(self) -> None:
        """Remove partial files of killed calls and workers; the caller must have the lock."""
        for file in self._files:
            for half_written in temporaries_of(file):
                half_written.unlink(missing_ok=True)
        for path in self._matching(_UNFINISHED):
            if is_abandoned(_lease_of(path), path):
                shutil.rmtree(path, ignore_errors=True)
        for path in self._matching(_LEASE):
            if not path.with_suffix(".tmp").exists() and is_abandoned(path, path):
                path.unlink(missing_ok=True)

    def aside(self) -> int:
        """Count the finished variants of other settings, which have hidden names."""
        return len(self._matching(_ASIDE))

    def _put_aside(self, path: Path, key: str) -> None:
        aside = self.out / f".{key}.kept"
        if aside.exists():  # a duplicate of the variant
            shutil.rmtree(path)
        else:
            path.rename(aside)

    def _fetch(self, wanted: list[str]) -> None:
        """Move variants of earlier settings back if they are wanted again."""
        runs = {f".{key}.kept": run for run, key in enumerate(wanted)}
        for aside in self._matching(_ASIDE):
            place = self.out / folder_name(runs.get(aside.name, 0))
            if aside.name in runs and not place.exists():
                aside.rename(place)

    def _matching(self, names: re.Pattern[str]) -> list[Path]:
        return sorted(path for path in self.out.iterdir() if names.match(path.name))

    @contextmanager
    def folder(self, run: int) -> Iterator[Path]:
        """Provide a folder for a variant; without an exception it gets its name at the end.

        If another worker finished the same variant first, its folder stays.
        """
        made = self._hidden(run)
        with Lease(_lease_of(made)):
            made.mkdir()
            try:
                yield made
                _list_files(made)
                # In parallel, because a disk flushes many files almost as fast as one.
                with ThreadPoolExecutor(_AT_ONCE) as pool:
                    list(pool.map(flush, filter(Path.is_file, made.rglob("*"))))
                self._name(made, self.out / folder_name(run))
            except OSError as error:
                if error.filename is None or not Path(error.filename).is_relative_to(made):
                    raise
                named = self.out / folder_name(run) / Path(error.filename).relative_to(made)
                raise OSError(error.errno, error.strerror, str(named)) from error
            finally:
                shutil.rmtree(made, ignore_errors=True)

    def _hidden(self, run: int) -> Path:
        return self.out / f".{folder_name(run)}.{secrets.token_hex(4)}.tmp"

    def _name(self, made: Path, final: Path) -> None:
        own = read_row(made)
        for _ in range(3):
            try:
                os.rename(made, final)
                flush_folder(self.out)
                return
            except OSError:
                if not final.is_dir():
                    continue
                there = read_row(final)
                is_done = there is not None and there.is_final and not _lost(final, there)
                if there is not None and own is not None and there.hash == own.hash and is_done:
                    return
                _require_own(final, there)
                old = self._hidden(int(final.name))
                with suppress(FileNotFoundError):  # another worker was faster
                    final.rename(old)
                shutil.rmtree(old, ignore_errors=True)
        raise FileError(final, "it cannot be written there", "check the folder and its rights")


def _lease_of(made: Path) -> Path:
    return made.with_suffix(".lease")


def _list_files(folder: Path) -> None:
    """Add the names and sizes of all other files to the row of a variant."""
    found = json.loads((folder / FILE).read_text("utf-8"))
    found["files"] = {
        str(file.relative_to(folder).as_posix()): file.stat().st_size
        for file in sorted(folder.rglob("*"))
        if file.is_file() and file != folder / FILE
    }
    write_json(folder, {FILE: found})


def _lost(folder: Path, row: Row) -> list[str]:
    """Return the files of a variant that are missing or were emptied."""
    return [name for name, size in row.files.items() if size and not _size(folder / name)]


def _size(path: Path) -> int:
    try:
        return path.stat().st_size
    except OSError:
        return 0


def _require_own(folder: Path, row: Row | None) -> None:
    """Check that a folder to be replaced has no foreign files. Raises FileError."""
    files = [file for file in sorted(folder.rglob("*")) if not file.is_dir()]
    names = [file.relative_to(folder).as_posix() for file in files]
    if row is None:
        foreign = names
    else:
        foreign = [
            name
            for name in names
            if name != FILE and _size(folder / name) not in (0, row.files.get(name))
        ]
    if foreign:
        told = ", ".join(foreign[:_MOST_NAMES]) + (", ..." if len(foreign) > _MOST_NAMES else "")
        what = (
            "a variant belongs there, but it contains files that this study did "
            f"not write: {told}"
        )
        raise FileError(folder, what, "move it away, or choose another folder with -o")


def write_json(folder: Path, data: dict[str, dict[str, Any]]) -> None:
    """Write JSON files into a folder, by name; the caller flushes them if needed."""
    with FileSet(flushed=False, is_own=True) as files:
        for name, content in data.items():
            files.temporary_for(folder / name).write_text(_text(content), "utf-8")
        files.commit()


def _text(content: dict[str, Any]) -> str:
    """Return JSON with one line per key: readable, and ten times faster than indented JSON."""
    lines = [
        f" {json.dumps(key)}: {json.dumps(value, ensure_ascii=False, allow_nan=False)}"
        for key, value in content.items()
    ]
    return "{\n" + ",\n".join(lines) + "\n}\n"

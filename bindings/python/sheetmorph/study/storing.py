# SPDX-License-Identifier: LGPL-2.1-or-later
"""The folder of a study: one folder a variant, that appears whole or not at all.

What is finished stays, and so does what somebody else made. A variant knows its own files by the
list in its `parameters.json`; a folder under work belongs to the process that holds its lease.
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

from ..errors import FileError, OccupiedError
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
    """Keeps the variants of a study below a folder."""

    def __init__(self, out: Path):
        self.out = out
        self._files: list[Path] = []

    def row(self, run: int, wanted: str) -> Row | None:
        """The row of a variant that is done, depends on what is wanted and has all its files; else
        None."""
        folder = self.out / folder_name(run)
        row = read_row(folder)
        is_done = row is not None and row.hash == wanted and not _lost(folder, row)
        return row if is_done else None

    def open(self, *names: str) -> None:
        """Make the folder. Raises FileError.

        names: files that the call will write. Only in a folder without the lock of a study can they
        belong to somebody else; then OccupiedError is raised.
        """
        try:
            self.out.mkdir(parents=True, exist_ok=True)
        except OSError as error:
            todo = "name another folder with -o"
            raise FileError(self.out, f"is no folder ({error.strerror})", todo) from None
        self._files = [self.out / name for name in names]
        if not (self.out / LOCK).exists():
            for file in self._files:
                if file.exists():
                    raise OccupiedError(file)

    def tidy(self, wanted: list[str]) -> None:
        """Before a study goes on: what was left half done goes, what is done comes to its place.

        wanted: the hash of every variant, in the order of the runs. Raises FileError where a file
        that is no variant's stands in the way.
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
        """Remove half-written files of killed calls and workers. The caller must be alone in the
        folder."""
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
        """How many finished variants of other settings are kept aside, under hidden names."""
        return len(self._matching(_ASIDE))

    def _put_aside(self, path: Path, key: str) -> None:
        aside = self.out / f".{key}.kept"
        if aside.exists():  # the same variant once more
            shutil.rmtree(path)
        else:
            path.rename(aside)

    def _fetch(self, wanted: list[str]) -> None:
        """Variants that were put aside and are wanted again, wherever they stand now."""
        runs = {f".{key}.kept": run for run, key in enumerate(wanted)}
        for aside in self._matching(_ASIDE):
            place = self.out / folder_name(runs.get(aside.name, 0))
            if aside.name in runs and not place.exists():
                aside.rename(place)

    def _matching(self, names: re.Pattern[str]) -> list[Path]:
        return sorted(path for path in self.out.iterdir() if names.match(path.name))

    @contextmanager
    def folder(self, run: int) -> Iterator[Path]:
        """A folder to write a variant into; without an exception it gets its name at the end.

        Where another worker was faster with the same variant, its folder stays.
        """
        made = self._hidden(run)
        with Lease(_lease_of(made)):
            made.mkdir()
            try:
                yield made
                _list_files(made)
                # All at once: a disk takes many files in little more time than one.
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
                is_done = there is not None and not _lost(final, there)
                if there is not None and own is not None and there.hash == own.hash and is_done:
                    return
                _require_own(final, there)
                old = self._hidden(int(final.name))
                with suppress(FileNotFoundError):  # another worker was faster
                    final.rename(old)
                shutil.rmtree(old, ignore_errors=True)
        raise FileError(final, "it cannot be put there", "check the folder and its rights")


def _lease_of(made: Path) -> Path:
    return made.with_suffix(".lease")


def _list_files(folder: Path) -> None:
    """Let the row of a variant name every other file of its folder, and how large it is."""
    found = json.loads((folder / FILE).read_text("utf-8"))
    found["files"] = {
        str(file.relative_to(folder).as_posix()): file.stat().st_size
        for file in sorted(folder.rglob("*"))
        if file.is_file() and file != folder / FILE
    }
    write_json(folder, {FILE: found})


def _lost(folder: Path, row: Row) -> list[str]:
    """The files of a variant that are gone or that were emptied."""
    return [name for name, size in row.files.items() if size and not _size(folder / name)]


def _size(path: Path) -> int:
    try:
        return path.stat().st_size
    except OSError:
        return 0


def _require_own(folder: Path, row: Row | None) -> None:
    """Raises FileError if a folder that is to be replaced holds what no study wrote."""
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
        what = f"it stands where a variant belongs, and holds what this study did not write: {told}"
        raise FileError(folder, what, "move it away, or name another folder with -o")


def write_json(folder: Path, data: dict[str, dict[str, Any]]) -> None:
    """Write JSON files into a folder, by name; whoever needs them on the disk flushes them."""
    with FileSet(flushed=False, is_own=True) as files:
        for name, content in data.items():
            files.temporary_for(folder / name).write_text(_text(content), "utf-8")
        files.commit()


def _text(content: dict[str, Any]) -> str:
    """JSON with one line for every key: for people, and written ten times as fast as indented."""
    lines = [
        f" {json.dumps(key)}: {json.dumps(value, ensure_ascii=False, allow_nan=False)}"
        for key, value in content.items()
    ]
    return "{\n" + ",\n".join(lines) + "\n}\n"

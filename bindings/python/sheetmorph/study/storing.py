# SPDX-License-Identifier: LGPL-2.1-or-later
"""The folder of a study: one folder a variant, that appears whole or not at all."""

from __future__ import annotations

import json
import os
import re
import secrets
import shutil
from collections.abc import Iterator
from concurrent.futures import ThreadPoolExecutor
from contextlib import contextmanager
from pathlib import Path
from typing import Any

from ..errors import FileError
from ..files.atomic import FileSet, flush
from .rows import FILE, Row, folder_name, read_row

_AT_ONCE = 8
_FOLDER = re.compile(r"\d{6}$")
_UNFINISHED = re.compile(r"\.\d{6}\.[0-9a-f]{8}\.tmp$")
_ASIDE = re.compile(r"\.[0-9a-f]{64}\.kept$")


class Store:
    """Keeps the variants of a study below a folder."""

    def __init__(self, out: Path):
        self.out = out

    def row(self, run: int, wanted: str) -> Row | None:
        """The row of a variant that is done and depends on what is wanted; else None."""
        row = read_row(self.out / folder_name(run))
        return row if row is not None and row.hash == wanted else None

    def open(self) -> None:
        """Make the folder. Raises FileError."""
        try:
            self.out.mkdir(parents=True, exist_ok=True)
        except OSError as error:
            todo = "name another folder with -o"
            raise FileError(self.out, f"is no folder ({error.strerror})", todo) from None

    def tidy(self, wanted: list[str]) -> None:
        """Before a study goes on: what was left half done goes, what is done comes to its place.

        wanted: the hash of every variant, in the order of the runs.
        """
        self.sweep()
        for path in self._matching(_FOLDER):
            row, run = read_row(path), int(path.name)
            if row is None:
                if (path / FILE).exists() or not any(path.iterdir()):
                    shutil.rmtree(path)
                else:
                    what = "it stands where a variant belongs, and holds none"
                    raise FileError(path, what, "move it away, or name another folder with -o")
            elif run >= len(wanted) or wanted[run] != row.hash:
                self._put_aside(path, row.hash)
        self._fetch(wanted)

    def sweep(self) -> None:
        """Remove what workers that died have left half done."""
        for path in self._matching(_UNFINISHED):
            shutil.rmtree(path, ignore_errors=True)

    def _put_aside(self, path: Path, key: str) -> None:
        aside = self.out / f".{key}.kept"
        if aside.exists():
            shutil.rmtree(path)
        else:
            path.rename(aside)

    def _fetch(self, wanted: list[str]) -> None:
        """Variants that have other numbers now; the rest of what was put aside goes."""
        runs = {f".{key}.kept": run for run, key in enumerate(wanted)}
        for aside in self._matching(_ASIDE):
            place = self.out / folder_name(runs.get(aside.name, 0))
            if aside.name in runs and not place.exists():
                aside.rename(place)
            else:
                shutil.rmtree(aside)

    def _matching(self, names: re.Pattern[str]) -> list[Path]:
        return sorted(path for path in self.out.iterdir() if names.match(path.name))

    @contextmanager
    def folder(self, run: int) -> Iterator[Path]:
        """A folder to write a variant into; without an exception it gets its name at the end.

        Where another worker was faster with the same variant, its folder stays.
        """
        made = self.out / f".{folder_name(run)}.{secrets.token_hex(4)}.tmp"
        made.mkdir()
        try:
            yield made
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

    def _name(self, made: Path, final: Path) -> None:
        own = read_row(made)
        for _ in range(3):
            try:
                os.rename(made, final)
                return
            except OSError:
                there = read_row(final)
                if there is not None and own is not None and there.hash == own.hash:
                    return
                shutil.rmtree(final, ignore_errors=True)
        raise FileError(final, "it cannot be put there", "check the folder and its rights")


def write_json(folder: Path, data: dict[str, dict[str, Any]]) -> None:
    """Write JSON files into a folder, by name; whoever needs them on the disk flushes them."""
    with FileSet(flushed=False) as files:
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

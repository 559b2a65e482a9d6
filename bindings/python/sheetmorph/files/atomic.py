# SPDX-License-Identifier: LGPL-2.1-or-later
"""Files that appear together and complete, or not at all."""

from __future__ import annotations

import filecmp
import os
import re
import secrets
import stat
from collections.abc import Iterator
from contextlib import contextmanager, suppress
from pathlib import Path

from ..base.errors import FileError, OccupiedError
from .beside import require_unread
from .identity import is_one_of
from .ledger import Ledger
from .signals import postponed


class FileSet:
    """Files that are written under temporary names beside their targets and renamed together.

    Use it in a ``with`` block; leaving the block without ``commit()`` removes the temporary files.
    ``committed`` is true once every file has its name. ``force`` allows to overwrite files that
    SheetMorph did not write. Files in ``reads`` are inputs and never overwritten.

    Parameters
    ----------
    by : str
        The command that writes; it may replace its own earlier files.
    flushed : bool
        Flush the files to disk before they get their names; if False, the caller must do this.
    force : bool
        Initial value of the attribute.
    is_own : bool
        The folder belongs to SheetMorph, so every file in it may be replaced.
    """

    def __init__(
        self, by: str = "run", *, flushed: bool = True, force: bool = False, is_own: bool = False
    ) -> None:
        self._by, self._other = by, dict[Path, str]()
        self._flushed = flushed
        self.force = force
        self.reads: list[Path] = []
        self._is_own = is_own
        self._ledger = Ledger()
        self._pending: list[tuple[Path, Path]] = []
        self.committed = False

    def __enter__(self) -> FileSet:
        return self

    def __exit__(self, _kind: object, error: object, _trace: object) -> None:
        pending = list(self._pending)
        with postponed():
            for temporary, _final in pending:
                temporary.unlink(missing_ok=True)
            self._pending.clear()
        if isinstance(error, OSError) and pending:
            raise _of_target(error, pending) from error

    def temporary_for(self, path: Path, by: str = "") -> Path:
        """Return a new hidden name beside `path` with the same suffix, which readers need.

        by names the writer if it is not the command of the set. Raises FileError if the folder does
        not exist.
        """
        if not path.parent.is_dir():
            raise FileError(path, "its folder does not exist", "create the folder first")
        if by:
            self._other[path] = by
        temporary = _hidden(path)
        self._pending.append((temporary, path))
        return temporary

    @contextmanager
    def named(self, temporary: Path) -> Iterator[None]:
        """Convert errors on a temporary file to errors on its target."""
        final = dict(self._pending)[temporary]
        try:
            yield
        except FileError as error:
            if error.path != temporary:
                raise
            raise FileError.of(final, error) from error
        except OSError as error:
            raise _of_target(error, [(temporary, final)]) from error

    def commit(self) -> None:
        """Rename all files to their targets, with SIGINT, SIGTERM and SIGHUP postponed.

        Raises FileError, also if another recipe in the folder reads a target that would change, and
        OccupiedError for a file that SheetMorph did not write. Every target then is as before.
        """
        places = [final for _temporary, final in self._pending]
        for temporary, final in self._pending:
            require_file_place(final)
            if final.exists() and not filecmp.cmp(temporary, final, shallow=False):
                require_unread(final, places)
                self.require_ours(final)
            if self._flushed:
                with self.named(temporary):
                    flush(temporary)
        made = [final for final in places if not final.exists() or self._may_replace(final)]
        with postponed():
            _rename_all(self._pending)
            self._pending.clear()
            self.committed = True
            for folder in {final.parent for final in places} if self._flushed else ():
                flush_folder(folder)
        if not self._is_own:
            self._ledger.add((path, self._other.get(path, self._by)) for path in made)

    def require_ours(self, path: Path, by: str = "") -> None:
        """Check that a target may be written; see temporary_for() for by.

        Raises FileError if the file is an input, and OccupiedError if it exists, this command did
        not write it and `force` is false.
        """
        if by:
            self._other[path] = by
        if not path.exists():
            return
        if is_one_of(path, self.reads):
            raise FileError(path, "this command also reads it", "name another file")
        if not self._may_replace(path):
            raise OccupiedError(path)

    def _may_replace(self, path: Path) -> bool:
        by = self._other.get(path, self._by)
        return self._is_own or self.force or self._ledger.has(path, by)


def _of_target(error: OSError, pairs: list[tuple[Path, Path]]) -> OSError:
    """Return the error with the target's name in place of the temporary one.

    A failed write, as on a full disk, names no file. The last of the (temporary, final) files is
    then the current one.
    """
    if error.filename is None:
        final: Path | None = pairs[-1][1]
    else:
        final = dict(pairs).get(Path(os.fsdecode(error.filename)))
    return error if final is None else OSError(error.errno, error.strerror, str(final))


def flush(path: Path) -> None:
    """Flush a file to disk."""
    with open(path, "rb") as written:
        os.fsync(written.fileno())


def flush_folder(folder: Path) -> None:
    """Flush the names in a folder to disk, where the system supports it."""
    with suppress(OSError):
        opened = os.open(folder, os.O_RDONLY)
        try:
            os.fsync(opened)
        finally:
            os.close(opened)


def require_file_place(path: Path) -> None:
    """Check that a path is a file or can become one. Raises FileError."""
    try:
        kind = os.stat(path).st_mode
    except OSError:  # the path does not exist, or is a broken link
        kind = stat.S_IFREG
    if stat.S_ISDIR(kind):
        raise FileError(path, "it is a folder", "give a file name, or remove the folder")
    if not stat.S_ISREG(kind):
        raise FileError(path, "it is a device or a pipe", "name a file")
    if path.parent.is_dir() and not os.access(path.parent, os.W_OK | os.X_OK):
        todo = "change the rights of the folder, or choose another one"
        raise FileError(path, "its folder cannot be written", todo)


def _hidden(path: Path) -> Path:
    return path.with_name(f".{path.stem}.{secrets.token_hex(4)}.tmp{path.suffix}")


def temporaries_of(path: Path) -> list[Path]:
    """Return the temporary files beside a file, from a running or a killed process."""
    name = re.compile(rf"\.{re.escape(path.stem)}\.[0-9a-f]{{8}}\.tmp{re.escape(path.suffix)}")
    return [there for there in path.parent.iterdir() if name.fullmatch(there.name)]


def _rename_all(pairs: list[tuple[Path, Path]]) -> None:
    """Rename all (temporary, final) files, or none."""
    backups: list[tuple[Path, Path | None]] = []
    current = Path()
    try:
        for temporary, final in pairs:
            current = final
            backups.append((final, _kept(final)))
            os.replace(temporary, final)
    except OSError as error:
        lost = [str(final) for final, kept in reversed(backups) if not _put_back(final, kept)]
        what = f"it cannot be written ({error.strerror or error})"
        what += f", and {', '.join(lost)} could not be put back" if lost else ""
        raise FileError(current, what, "check the path and its rights") from error
    for _final, kept in backups:
        _remove(kept)


def _kept(final: Path) -> Path | None:
    """Keep the file at `final` under a second name; return None if there is none."""
    if not os.path.lexists(final):
        return None
    kept = _hidden(final)
    try:
        os.link(final, kept, follow_symlinks=False)
    except OSError:  # the file system has no hard links
        os.rename(final, kept)
    return kept


def _put_back(final: Path, kept: Path | None) -> bool:
    try:
        if kept is None:
            final.unlink(missing_ok=True)
        else:
            os.replace(kept, final)
            # os.replace() does nothing if both names are links to one file
            kept.unlink(missing_ok=True)
    except OSError:
        return False
    return True


def _remove(kept: Path | None) -> None:
    """Remove a backup; a failure is harmless and does not turn a success into an error."""
    try:
        if kept is not None:
            kept.unlink()
    except OSError:
        return

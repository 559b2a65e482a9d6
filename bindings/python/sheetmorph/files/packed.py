# SPDX-License-Identifier: LGPL-2.1-or-later
"""Files that gzip has packed: read unpacked, written unpacked."""

from __future__ import annotations

import gzip
import shutil
import tempfile
import zlib
from collections.abc import Callable
from pathlib import Path

from ..errors import FileError
from .part_file import PartFile


def is_packed(path: str | Path) -> bool:
    """Whether the name says that gzip has packed the file."""
    return Path(path).suffix.lower() == ".gz"


def unpacked_name(path: str | Path) -> Path:
    """The path without .gz."""
    place = Path(path)
    return place.with_suffix("") if is_packed(place) else place


def read_packed(path: Path, read: Callable[[Path], PartFile]) -> PartFile:
    """What `read` makes of the unpacked file, which stays on disk as long as the result lives.

    Raises FileError.
    """
    folder = tempfile.TemporaryDirectory(prefix="sheetmorph-")
    place = Path(folder.name) / unpacked_name(path).name
    try:
        with gzip.open(path) as packed, place.open("wb") as unpacked:
            shutil.copyfileobj(packed, unpacked)
    except (EOFError, gzip.BadGzipFile, zlib.error) as error:
        what = f"gzip cannot unpack it ({error})"
        raise FileError(path, what, "unpack it yourself, or get it again") from error
    try:
        file = read(place)
    except FileError as error:
        raise FileError(path, error.what, error.todo) from error
    file.origin, file.unpacked_in = path, folder
    return file

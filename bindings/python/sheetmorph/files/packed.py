# SPDX-License-Identifier: LGPL-2.1-or-later
"""Files packed by gzip, which are read and written in unpacked form."""

from __future__ import annotations

import gzip
import shutil
import tempfile
import zlib
from collections.abc import Callable
from pathlib import Path

from ..base.errors import FileError
from .part_file import PartFile


def is_packed(path: str | Path) -> bool:
    """Return whether the suffix is that of gzip."""
    return Path(path).suffix.lower() == ".gz"


def unpacked_name(path: str | Path) -> Path:
    """Return the path without .gz."""
    place = Path(path)
    return place.with_suffix("") if is_packed(place) else place


def read_packed(path: Path, read: Callable[[Path], PartFile]) -> PartFile:
    """Unpack a file and read it; the unpacked copy exists as long as the result.

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
        raise FileError.of(path, error) from error
    file.origin, file.unpacked_in = path, folder
    return file

# SPDX-License-Identifier: LGPL-2.1-or-later
"""Files of welds and bolts beside the part files; their points follow the joined sheets."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

from ..base.errors import FileError
from .csv_points import read_csv, read_vip
from .points import JointFile
from .xml_points import read_xml

__all__ = ["JointFile", "is_joint_file", "read_joint_bytes", "read_joint_file", "suffixes"]

_READERS: dict[str, Callable[[Path, bytes], JointFile]] = {
    ".xml": read_xml,
    ".xmcf": read_xml,
    ".mcf": read_xml,
    ".vip": read_vip,
    ".csv": read_csv,
}


def suffixes() -> list[str]:
    """Return the file name suffixes that read_joint_file() supports."""
    return sorted(_READERS)


def is_joint_file(path: str | Path) -> bool:
    """Return whether a file name is that of a joint file."""
    return Path(path).suffix.lower() in _READERS


def read_joint_file(path: str | Path) -> JointFile:
    """Read a joint file. Raises FileError."""
    place = Path(path)
    if not is_joint_file(place):
        todo = f"use one of {', '.join(suffixes())}"
        raise FileError(place, "it is not a joint file", todo)
    try:
        data = place.read_bytes()
    except OSError as error:
        raise FileError.of(place, error) from None
    return read_joint_bytes(place, data)


def read_joint_bytes(path: Path, data: bytes) -> JointFile:
    """Read a joint file from its bytes. Raises FileError."""
    return _READERS[path.suffix.lower()](path, data)

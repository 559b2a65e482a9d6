# SPDX-License-Identifier: LGPL-2.1-or-later
"""Mesh files: read a part, write the same file again with other coordinates."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

from ..errors import FileError
from .atomic import FileSet
from .meshio_file import SUFFIXES, MeshioFile
from .nastran import NastranFile
from .obj import ObjFile
from .off import OffFile
from .part_file import PartFile
from .ply import read_ply
from .stl import read_stl

__all__ = ["FileSet", "PartFile", "read_part", "suffixes"]

_CAD = (".step", ".stp", ".iges", ".igs", ".brep", ".brp", ".fcstd")
_READERS: dict[str, Callable[[Path], PartFile]] = {
    ".obj": ObjFile.read,
    ".off": OffFile.read,
    ".ply": read_ply,
    ".stl": read_stl,
    **dict.fromkeys((".nas", ".bdf", ".dat", ".fem", ".blk"), NastranFile),
    **dict.fromkeys(SUFFIXES, MeshioFile),
}


def suffixes() -> list[str]:
    """The file name endings that read_part() takes."""
    return sorted(_READERS)


def read_part(path: str | Path) -> PartFile:
    """A part from a file: ``.mesh`` (PartMesh, doubles) and ``.write(path, positions)``.

    Raises FileError if the file is missing, empty, cut short, corrupt or of an unknown format.
    """
    place = Path(path)
    suffix = place.suffix.lower()
    if suffix in _CAD:
        todo = "mesh it in FreeCAD and export PLY or OBJ"
        raise FileError(place, "CAD files are not read in this version", todo)
    if suffix not in _READERS:
        todo = f"use one of {', '.join(suffixes())}"
        raise FileError(place, f'unknown format "{place.suffix}"', todo)
    if not place.is_file():
        raise FileError(place, "there is no such file", "check the path")
    return _READERS[suffix](place)

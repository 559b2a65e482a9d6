# SPDX-License-Identifier: LGPL-2.1-or-later
"""Mesh files: read a part, and write the same file again with other coordinates."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import replace
from pathlib import Path

import numpy as np

from ..base.errors import FileError
from ..base.labels import Labels, by_key
from .atomic import FileSet
from .cad_file import CAD_SUFFIXES, read_cad
from .deck_file import SUFFIXES as DECKS
from .deck_file import DeckFile
from .meshio_file import SUFFIXES, MeshioFile
from .obj import ObjFile
from .off import OffFile
from .packed import is_packed, read_packed, unpacked_name
from .part_file import PartFile
from .ply import read_ply
from .stl import read_stl
from .unknown import unknown_format

__all__ = ["FileSet", "PartFile", "is_cad", "output_name", "read_part", "suffixes", "unpacked_name"]

_READERS: dict[str, Callable[[Path], PartFile]] = {
    ".obj": ObjFile.read,
    ".off": OffFile.read,
    ".ply": read_ply,
    ".stl": read_stl,
    **dict.fromkeys(SUFFIXES, MeshioFile),
    **dict.fromkeys(DECKS, DeckFile),
}


def suffixes() -> list[str]:
    """Return the file name suffixes that read_part() supports."""
    return sorted([*_READERS, *CAD_SUFFIXES])


def is_cad(path: str | Path) -> bool:
    """Return whether a file is a CAD file, which must be meshed."""
    return unpacked_name(path).suffix.lower() in CAD_SUFFIXES


def output_name(path: str | Path) -> str:
    """Return the file name that a run writes; deformed CAD parts are meshes in OBJ."""
    place = unpacked_name(path)
    return f"{place.stem}.obj" if is_cad(place) else place.name


def read_part(
    path: str | Path,
    meshing: Mapping[str, float] | None = None,
    progress: Callable[[float, str], bool] | None = None,
) -> PartFile:
    """Read a part from a file.

    Parameters
    ----------
    path : str or path
        The file.
    meshing : mapping, optional
        Mesh sizes for a CAD file: `edge` and `deflection` in mm, `angle` in degrees.
    progress : callable, optional
        progress(fraction, task) is called while a CAD file is meshed; False cancels (RuntimeError).

    Returns
    -------
    PartFile
        The file, with the ``mesh`` (PartMesh) and ``write(path, positions)``.

    Raises
    ------
    FileError
        If the file is missing, empty, truncated, corrupt or of an unknown format.
    """
    place = Path(path)
    suffix = unpacked_name(place).suffix.lower()
    if suffix not in _READERS and not is_cad(place):
        raise unknown_format(place, suffixes())
    if not place.is_file():
        raise FileError(place, "the file does not exist", "check the path")
    if is_packed(place):
        return read_packed(place, lambda inner: read_part(inner, meshing, progress))
    if is_cad(place):
        return read_cad(place, meshing, progress)
    if meshing:
        raise FileError(place, "only CAD files are meshed", "leave out the mesh sizes")
    return _with_properties(_READERS[suffix](place))


def _with_properties(file: PartFile) -> PartFile:
    """Add the property ids of a deck to the labels of its mesh."""
    if file.properties is not None:
        names = [f"PID {number}" for number in np.unique(file.properties).tolist()]
        labels = (file.mesh.labels or Labels()).with_groups(by_key(names, file.properties))
        file.mesh = replace(file.mesh, labels=labels)
    return file

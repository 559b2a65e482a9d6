# SPDX-License-Identifier: LGPL-2.1-or-later
"""Finite element decks: read as they stand, written byte for byte but for nodes that moved."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

from ..errors import FileError
from .deck import Deck
from .includes import output_places
from .model import Elements, Opener, Place
from .abaqus import SUFFIXES as ABAQUS
from .abaqus import read_abaqus
from .dyna import SUFFIXES as DYNA
from .dyna import read_dyna
from .gmsh import SUFFIXES as GMSH
from .gmsh import read_gmsh
from .heap import give_back_large_arrays
from .nastran import SUFFIXES as NASTRAN
from .nastran import read_nastran
from .radioss import SUFFIXES as RADIOSS
from .radioss import read_radioss
from .shells import Sheet, sheet_of

__all__ = [
    "Deck", "Elements", "Place", "Sheet", "is_deck", "output_places", "read_bytes", "read_deck",
    "sheet_of", "suffixes",
]  # fmt: skip

_READERS: dict[str, Callable[[Path, Opener], Deck]] = {
    **dict.fromkeys(NASTRAN, read_nastran),
    **dict.fromkeys(DYNA, read_dyna),
    **dict.fromkeys(ABAQUS, read_abaqus),
    **dict.fromkeys(RADIOSS, read_radioss),
    **dict.fromkeys(GMSH, read_gmsh),
}


def suffixes() -> list[str]:
    """The file name endings that read_deck() takes."""
    return sorted(_READERS)


def is_deck(path: Path) -> bool:
    """Whether a file's name is that of a deck."""
    return path.suffix.lower() in _READERS


def read_deck(path: Path, opener: Opener | None = None) -> Deck:
    """A deck with all that it includes. opener: the bytes of a file, another way than from disk.

    Raises FileError.
    """
    give_back_large_arrays()
    try:
        deck = _READERS[path.suffix.lower()](path, opener or read_bytes)
    except RecursionError:
        what = "cards refer to one another in a chain that does not end"
        raise FileError(path, what, "correct the deck") from None
    return deck


def read_bytes(path: Path) -> bytes:
    """The file's bytes. Raises FileError if it cannot be read."""
    try:
        return path.read_bytes()
    except OSError as error:
        reason = error.strerror or str(error)
        todo = "check the path and its rights"
        raise FileError(path, f"cannot be read ({reason})", todo) from None
